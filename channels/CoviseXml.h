// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFiles.h"
#include "brickwall/channels/RigFilesXml.h"

namespace brickwall {

/// A rig from COVISE's COCONFIG XML: screens, channels, viewports, windows, pipes, stereo, viewer, near and far of what
/// `scope` sees. Without a host, all hosts that show channels become one rig. Included files are read from beside the
/// file that names them; a missing one is a note. Throws Error naming file, line, element and attribute.
Rig readCovise(const RigXml& file, const RigScope& scope);

/// A COCONFIG file of the rig, one GLOBAL section, and what it cannot say (COVISE counts in whole millimetres).
std::string writeCovise(const Rig& rig, std::vector<std::string>& lost);

} // namespace brickwall
