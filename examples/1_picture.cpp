// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// From data to a picture, with the core alone.
#include "Arguments.h"

#include <brickwall/core/render/ImageFiles.h>
#include <brickwall/core/scene/SceneSetup.h>

#include <algorithm>
#include <vector>

using namespace brickwall;

int main(int argc, char** argv)
{
    return runExample(argc, argv, {.out = "picture.png"}, [](const Arguments& arguments) {
        SceneOptions options; // the same as on the command line of brickwall render
        options.data = arguments.data;
        const Executor executor; // all cores
        Progress silent;
        const PreparedScene prepared = prepareScene(options, executor, silent);

        // Look at the middle of the data from three times their size away.
        const vec3d center = 0.5 * (prepared.bounds.lower + prepared.bounds.upper);
        const vec3d extent = prepared.bounds.extent();
        const double size = std::max({extent.x, extent.y, extent.z});
        const vec3d eye = center + size * vec3d(-1.0, 1.0, 2.5);
        const View view = viewOfCamera("picture", eye, center, {0, 1, 0}, 28.0, 320, 240, 0.1 * size, 10.0 * size);

        const Renderer renderer(prepared.scene, executor);
        const std::vector<Frame> frames = renderer.render({&view, 1}, renderSettings(options), silent);
        writePng(imageOver(frames.front(), vec3f(0.0f)), arguments.out);
    });
}
