// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFilesRecord.h"

namespace brickwall {

/// Our TOML file as a record. Throws Error with the line of the first mistake in the TOML.
RigRecord recordOfToml(const RigText& source);

/// A record as TOML: general tables first, then the lists, one key a line; numbers so that they read back exactly.
std::string tomlOfRecord(const nlohmann::ordered_json& root);

} // namespace brickwall
