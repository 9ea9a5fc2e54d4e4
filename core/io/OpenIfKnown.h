// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"

namespace brickwall {

/// As openDataSet, but null for data that exist and belong to no format: for hosts that ask other readers then.
std::unique_ptr<DataSet> openIfKnown(const std::string& data);

} // namespace brickwall
