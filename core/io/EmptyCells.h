// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"

#include <string_view>

namespace brickwall {

/// Makes cells empty in which a field has a value that is not finite: bricks that have such cells are carved into
/// bricks that have none, at the end of the list, and the fields' values and ranges follow. Says in the model's notes,
/// with `place`, how many cells that were. A model without such cells stays as it is. Throws Error if no cell is left,
/// and Cancelled.
void leaveOutNonFinite(Model& model, std::string_view place, const Executor& executor, Progress& progress);

} // namespace brickwall
