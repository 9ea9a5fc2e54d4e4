// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/BorderGradients.h"
#include "brickwall/core/model/FlowOperators.h"
#include "brickwall/core/model/Model.h"

#include <span>
#include <vector>

namespace brickwall {

/// The value of an operator at every cell's centre, from derivatives per world unit of componentsOf(op) fields with one
/// finite value per cell; components of a vector are along the axes of the world. In the order of the fields' values.
///
/// Derivatives are central differences of cells of one level, whatever bricks they are in; where a cell lacks one of
/// its six neighbours, BorderGradients. Both are of second order, so that nothing is lost where levels meet or data
/// end.
///
/// Deterministic, whatever the executor. Memory beyond the result: an index of the bricks (about 36 bytes each) and
/// 300 kB per thread. Progress is advanced by cells; the stage is begun by the caller. Throws Cancelled.
std::vector<float> differentiate(FlowOperator op, std::span<const Brick> bricks, FieldValues fields,
                                 const mat4d& worldFromVoxel, const Executor& executor, Progress& progress);

} // namespace brickwall
