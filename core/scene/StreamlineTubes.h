// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/model/Model.h"
#include "brickwall/core/scene/SceneOptions.h"

#include <vector>

namespace brickwall {

/// Limits of the options for streamlines, without a look at any data. Throws Error.
void checkStreamlines(const SceneOptions& options, const PlaceOfOption& placeOf);

/// Traces the streamlines that the options ask for through a data set, all of their vector's components of which are
/// read for it, and makes tubes of them, in world space; nothing without seeds. Says in a note how many lines there are
/// and where they end. Throws Error for a vector that is not there and for seeds of which none is in a cell.
std::vector<TriangleMesh> streamlineTubes(const SceneOptions& options, const DataSet& data, const Executor& executor,
                                          Progress& progress);

} // namespace brickwall
