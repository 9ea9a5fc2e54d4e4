// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/MultiChannelDrawer.h"

#include <osg/Program>

namespace brickwall {

/// The image as a rectangle over the viewport, with its depth carried over to the projection of the draw.
osg::ref_ptr<osg::Program> makeAsIsProgram();

/// The image's pixels where they are seen by now, as points or as a surface, for a PixelGrid.
osg::ref_ptr<osg::Program> makeWarpProgram(MultiChannelDrawer::Mode mode);

} // namespace brickwall
