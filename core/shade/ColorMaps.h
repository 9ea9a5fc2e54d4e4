// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/TransferFunction.h"

#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// The names that `colorMap` knows, in the order in which they are listed for people.
std::vector<std::string> colorMapNames();

/// A colour map as control points in linear RGB. Case, blanks, '-' and '_' do not count, and the names that ExaBrick's
/// and ParaView's users know are aliases. Throws Error listing the names.
std::vector<ColorPoint> colorMap(std::string_view name);

} // namespace brickwall
