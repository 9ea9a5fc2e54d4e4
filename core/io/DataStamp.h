// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

namespace brickwall {

/// What tells whether files are still the ones that something was made from: a line for each, with its name, size, time
/// of the last change, and a hash of its first and last 64 KiB, where headers and tables are. Nothing if one of them
/// cannot be read.
std::string stampOf(std::span<const std::string> files);

/// The same without a look into the files, which may be thousands: whether they have changed since a moment ago.
std::string timesOf(std::span<const std::string> files);

} // namespace brickwall
