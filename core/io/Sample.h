// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/ProceduralSet.h"

#include <memory>
#include <string>

namespace brickwall {

/// Data without a file: `sample:NAME[:SIZE]`, NAME one of wake, cloud, impact (ProceduralSet.h says what they are),
/// SIZE about the number of leaf cells wanted, 50k to 2000M ("500k", "1.5M", "20000"); each name has its own default
/// of 1.5M or 2M. Null unless `data` starts with "sample:"; unknown names and sizes are an Error that lists those there
/// are.
///
/// The same grid and values whatever the executor. Loading makes the grid anew each time; that takes about as long as
/// sampling one field.
std::unique_ptr<DataSet> openSample(const std::string& data);

/// The functions behind a sample, for whoever wants to compare. `data` has to start with "sample:".
ProceduralSet proceduralSample(const std::string& data);

} // namespace brickwall
