// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

namespace brickwall::fuzz {

/// Does what `brickwall info` and `render` do with data: opens them, loads every field, alone and with all others, and
/// prepares them for rays. A file may be answered with an Error of one line; everything else ends the process.
void readAll(const std::string& data);

/// The same demand on any reading.
void answered(const std::function<void()>& reading);

} // namespace brickwall::fuzz
