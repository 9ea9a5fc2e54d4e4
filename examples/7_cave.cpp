// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The virtual CAVE: five walls around a head, two eyes each, in windows on this desktop. With --frames N and
/// --out FOLDER it draws N frames, writes a picture of every window, and ends.
#include "Arguments.h"

#include <brickwall/channels/RigFiles.h>
#include <brickwall/core/scene/SceneSetup.h>
#include <brickwall/plugin/RigViewer.h>

using namespace brickwall;

int main(int argc, char** argv)
{
    return runExample(argc, argv, {}, [](const Arguments& arguments) {
        const Rig cave = loadRig("cave5");
        SceneOptions options;
        options.data = arguments.data;
        const Executor executor;
        Progress silent;
        const PreparedScene prepared = prepareScene(options, executor, silent);

        ViewerOptions viewer;
        viewer.windowScale = 0.125; // the walls have more pixels than a desktop
        viewer.frames = arguments.frames;
        viewer.screenshotFolder = arguments.out;
        viewScene(prepared.scene, cave, renderSettings(options), viewer, silent);
    });
}
