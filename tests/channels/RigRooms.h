// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"

/// Rigs for the tests of views.
namespace brickwall::test {

/// A cube room of 2 m with four screens (front, left, right, floor) about a head that looks forward, one mono channel
/// each, all in one window of 400 x 100 pixels.
inline Rig cubeRoom()
{
    Rig rig;
    rig.name = "cube";
    rig.screens = {{"front", {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}},
                   {"left", {-1, -1, -1}, {-1, 1, -1}, {-1, 1, 1}},
                   {"right", {1, 1, -1}, {1, -1, -1}, {1, -1, 1}},
                   {"floor", {-1, -1, -1}, {1, -1, -1}, {1, 1, -1}}};
    rig.viewers.emplace_back();
    rig.viewers[0].name = "head";
    rig.windows.emplace_back();
    rig.windows[0].width = 400;
    rig.windows[0].height = 100;
    for (int i = 0; i < 4; ++i) {
        Channel channel;
        channel.name = rig.screens[i].name;
        channel.screen = i;
        channel.viewport = {100 * i, 0, 100, 100};
        rig.channels.push_back(channel);
    }
    return rig;
}

/// The front wall alone, 200 x 100 pixels.
inline Rig oneWall(StereoMode stereo)
{
    Rig rig = cubeRoom();
    rig.screens.resize(1);
    rig.channels.resize(1);
    rig.channels[0].viewport = {10, 20, 200, 80};
    rig.channels[0].stereo = stereo;
    return rig;
}

} // namespace brickwall::test
