// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/Expression.h"
#include "brickwall/core/model/FlowOperators.h"

#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// What a FlowCall means among certain fields: the operator, and the one or three fields that it is of.
struct FlowTerm
{
    FlowOperator op;
    std::vector<std::string> fields;
};

/// The calls of an expression, whose definition is `text`, among fields of these names. Vectors are found by the names
/// of their components (VectorFields.h). Throws TextError at `place`, which points at the argument, for a vector or a
/// field that is not there, and says which are.
std::vector<FlowTerm> flowTerms(const Expression& expression, const std::string& text,
                                std::span<const std::string> known, const std::string& place);

} // namespace brickwall
