// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "OsgHost.h"
#include "TestRigs.h"

#include <fmt/format.h>

namespace brickwall::test {

/// A small sample as osgviewer shows it, and what the renderer makes of it for the same matrices.
struct HostScene
{
    static constexpr int width = 160;
    static constexpr int height = 120;
    const std::string file = "sample:wake:60k.brickwall";

    PreparedScene prepared;
    RenderSettings settings;
    osg::Vec3d center;
    osg::Vec3d eye;    ///< in front of the data
    double size = 0.0; ///< of the data

    /// Options as in SceneText.h.
    explicit HostScene(const std::string& options);

    /// osgviewer in a window at the upper left, looking from `eye`, with these arguments.
    std::string viewer(const std::string& arguments) const;

    /// side as in hostModelview; the window's part for this view.
    Frame frame(int side, int viewWidth = width, int viewHeight = height, const osg::Matrixd& model = {}) const;

    /// The window's colour at a pixel for a frame that covers it.
    Rgb expected(const Frame& frame, int x, int y) const;
    bool isClose(const osg::Image& picture, const Frame& frame, int x, int y) const;

    /// Waits until all of the window is as said.
    void expectWindow(OsgHost& host, const std::function<Rgb(int x, int y)>& expected,
                      const std::string& display = {}) const;
    void expectMono(OsgHost& host, const Frame& frame) const;
};

/// Why the stock programs cannot run here; empty if they can.
const std::string& whyNoOsgviewer();

} // namespace brickwall::test

#define BRICKWALL_NEEDS_OSGVIEWER()                                                                                    \
    BRICKWALL_NEEDS_DISPLAY();                                                                                         \
    if (!brickwall::test::whyNoOsgviewer().empty())                                                                    \
    GTEST_SKIP() << brickwall::test::whyNoOsgviewer()
