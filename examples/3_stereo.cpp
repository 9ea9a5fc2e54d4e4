// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The two eyes of a head before the built-in stereo wall, rendered in one call: OUT-wall-left.png and
/// OUT-wall-right.png.
#include "Arguments.h"

#include <brickwall/channels/RigFiles.h>
#include <brickwall/core/render/ImageFiles.h>
#include <brickwall/core/scene/SceneSetup.h>

using namespace brickwall;

int main(int argc, char** argv)
{
    return runExample(argc, argv, {.out = "stereo"}, [](const Arguments& arguments) {
        Rig rig = loadRig("stereo-wall");
        for (Channel& channel : rig.channels)
            channel.viewport = {0, 0, 320, 180}; // its windows are as large as the projectors' images
        SceneOptions options;
        options.data = arguments.data;
        const Executor executor;
        Progress silent;
        const PreparedScene prepared = prepareScene(options, executor, silent);
        const mat4d place = worldFromRoom(rig, prepared.bounds.lower, prepared.bounds.upper);
        std::vector<View> views;
        for (const ChannelView& view : viewsOfRig(rig, place).views)
            views.push_back(view.view);

        const Renderer renderer(prepared.scene, executor);
        for (const Frame& frame : renderer.render(views, renderSettings(options), silent))
            writePng(imageOver(frame, rig.background), arguments.out + "-" + frame.view.name + ".png");
    });
}
