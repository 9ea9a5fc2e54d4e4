// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"
#include "brickwall/plugin/WindowCapture.h"

#include <string>
#include <vector>

namespace brickwall {

/// One PNG file per window, named like it, in a folder that is made where it is missing; right eyes of quad-buffered
/// windows get "-right". Throws Error for a file that cannot be written and a window that was not drawn.
void writePictures(const std::string& folder, const Rig& rig, const std::vector<WindowCapture::Picture>& pictures);

} // namespace brickwall
