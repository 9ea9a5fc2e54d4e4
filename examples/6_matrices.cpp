// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Camera matrices from a script, as a host with OpenGL has them: a flight around the data, OUT-0.png to OUT-3.png.
#include "Arguments.h"

#include <brickwall/core/render/ImageFiles.h>
#include <brickwall/core/scene/SceneSetup.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

using namespace brickwall;

int main(int argc, char** argv)
{
    return runExample(argc, argv, {.out = "matrices", .frames = 4}, [](const Arguments& arguments) {
        SceneOptions options;
        options.data = arguments.data;
        const Executor executor;
        Progress silent;
        const PreparedScene prepared = prepareScene(options, executor, silent);
        const vec3d center = 0.5 * (prepared.bounds.lower + prepared.bounds.upper);
        const vec3d extent = prepared.bounds.extent();
        const double size = std::max({extent.x, extent.y, extent.z});

        const mat4d projection = glm::perspective(0.5, 320.0 / 240.0, 0.1 * size, 10.0 * size);
        std::vector<View> views;
        for (int i = 0; i < arguments.frames; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / arguments.frames;
            const vec3d eye = center + 2.5 * size * vec3d(std::sin(angle), 0.2, std::cos(angle));
            const mat4d modelview = glm::lookAt(eye, center, vec3d(0, 1, 0));
            views.push_back(viewOfMatrices(std::to_string(i), modelview, projection, 320, 240));
        }
        const Renderer renderer(prepared.scene, executor);
        for (const Frame& frame : renderer.render(views, renderSettings(options), silent))
            writePng(imageOver(frame, vec3f(0.0f)), arguments.out + "-" + frame.view.name + ".png");
    });
}
