// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFilesXml.h"

namespace brickwall {

/// ParaView's display configuration (.pvx, as ParaView 6.2 reads it): one machine is one window, screen and channel.
/// Its frame is y up, -z into the front screen, metres; its numbers are read strictly. What ParaView ignores or we
/// cannot show becomes a note. Throws Error naming file, line and attribute.
Rig readPvx(const RigXml& file);

/// A .pvx file of the rig, and what such a file cannot say.
std::string writePvx(const Rig& rig, std::vector<std::string>& lost);

} // namespace brickwall
