// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"

#include <algorithm>

namespace brickwall {
namespace {

/// A name read from a hostile file may contain line ends; the message still has to be one line.
std::string oneLine(std::string_view place, std::string_view message)
{
    std::string line = place.empty() ? std::string(message) : std::string(place) + ": " + std::string(message);
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return line;
}

} // namespace

Error::Error(std::string_view place, std::string_view message) : std::runtime_error(oneLine(place, message)) {}

} // namespace brickwall
