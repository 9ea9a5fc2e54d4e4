// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/StateSet>

namespace brickwall {

/// Texture units and names that the drawer's program reads.
namespace drawerState {
constexpr unsigned colorUnit = 0;
constexpr unsigned depthUnit = 1;
constexpr const char* backgroundName = "brickwallBackground";
} // namespace drawerState

/// What all views of a MultiChannelDrawer are drawn with: program (GLSL 1.20, no fixed function), samplers,
/// premultiplied blending, depth test LEQUAL with depth written, after the opaque and before the transparent bin.
osg::ref_ptr<osg::StateSet> makeDrawerState();

} // namespace brickwall
