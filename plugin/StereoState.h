// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"

#include <osg/Camera>

#include <vector>

namespace brickwall {

/// The eyes that a channel of this mode shows, left before right.
std::vector<Eye> eyesOf(StereoMode mode);

bool isInterlaced(StereoMode mode);

/// Lets a camera write only where and what its eye may: draw buffer, colour mask, stencil test. For the interlaced
/// modes the stencil buffer has to have the patterns of makeInterlacePatterns().
void restrictToEye(osg::Camera& camera, StereoMode mode, Eye eye);

/// Sets a bit of the stencil buffer for each interlaced mode where the right eye belongs, in pixels of the window
/// counted from its lower left corner. To be drawn over the whole window after its stencil buffer was cleared to 0.
osg::ref_ptr<osg::Node> makeInterlacePatterns();

} // namespace brickwall
