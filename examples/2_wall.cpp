// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// One wall of a room: a screen, a head that stands beside its middle, and the picture that is right for its eye.
#include "Arguments.h"

#include <brickwall/channels/Rig.h>
#include <brickwall/core/render/ImageFiles.h>
#include <brickwall/core/scene/SceneSetup.h>

using namespace brickwall;

int main(int argc, char** argv)
{
    return runExample(argc, argv, {.out = "wall.png"}, [](const Arguments& arguments) {
        // Metres; x to the right, y forward, z up. A wall of 4 m x 3 m, 1.5 m before the origin.
        Rig wall;
        wall.name = "wall";
        wall.screens = {{"front", {-2.0, 1.5, -1.5}, {2.0, 1.5, -1.5}, {2.0, 1.5, 1.5}}};
        wall.viewers = {Viewer{"visitor"}};
        wall.viewers[0].roomFromHead[3] = vec4d(0.8, -0.5, 0.2, 1.0); // not in the middle: off-axis
        wall.windows = {{"window", "", 0, 0, 320, 240}};
        Channel channel;
        channel.name = "front";
        channel.viewport = {0, 0, 320, 240};
        wall.channels = {channel};
        wall.sceneCenter = {0.0, 1.5, 0.0};
        checkRig(wall, "wall");

        SceneOptions options;
        options.data = arguments.data;
        const Executor executor;
        Progress silent;
        const PreparedScene prepared = prepareScene(options, executor, silent);
        // The data stand on the wall, two metres long.
        const mat4d place = worldFromRoom(wall, prepared.bounds.lower, prepared.bounds.upper);
        const RigViews views = viewsOfRig(wall, place);
        const Renderer renderer(prepared.scene, executor);
        const auto frames = renderer.render({&views.views.at(0).view, 1}, renderSettings(options), silent);
        writePng(imageOver(frames.front(), wall.background), arguments.out);
    });
}
