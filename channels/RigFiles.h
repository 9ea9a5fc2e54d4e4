// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"

#include <string>

namespace brickwall {

/// Which part of a configuration that serves a whole cluster is wanted (COVISE's LOCAL, CLUSTER and RANK).
struct RigScope
{
    std::string host{};   ///< empty: all hosts together, each host's channels a part of one rig
    std::string master{}; ///< empty: the file's own master sections all apply
    int rank = -1;        ///< -1: any
};

/// A rig from a file (our TOML or JSON, COVISE XML, ParaView .pvx, told apart by content) or the name of one of the
/// rigs in config/. Throws Error naming file, line and attribute.
Rig loadRig(const std::string& fileOrName, const RigScope& scope = {});

/// The rigs in config/, by name.
std::vector<std::string> builtInRigs();

enum class RigFormat { toml, json, covise, pvx };

/// The rig in another format; what the format cannot say is listed in `lost`.
std::string writeRig(const Rig& rig, RigFormat format, std::vector<std::string>& lost);

} // namespace brickwall
