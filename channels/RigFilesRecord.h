// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFilesText.h"

#include <nlohmann/json.hpp>

#include <map>

namespace brickwall {

/// The contents of our own rig files, TOML or JSON alike, with the line of each value under its JSON pointer
/// ("/screen/0/center"). The schema is in docs/rigs.md.
struct RigRecord
{
    std::string file;
    nlohmann::ordered_json root;
    std::map<std::string, int> lines;

    /// "FILE:LINE" of the value, or of the nearest one around it.
    std::string placeOf(std::string pointer) const;
};

/// Strict: unknown keys, wrong types and missing values throw Error naming file, line and key.
Rig rigOfRecord(const RigRecord& record);

/// The root of a record that `rigOfRecord` turns back into the same rig, bit for bit.
nlohmann::ordered_json recordOfRig(const Rig& rig);

} // namespace brickwall
