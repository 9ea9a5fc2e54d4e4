// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace brickwall {

/// What is computed from the first derivatives of a field at a point.
///
/// qCriterion is (|Omega|^2 - |S|^2) / 2 in Frobenius norms, of the antisymmetric and the symmetric part of a
/// velocity's gradient (Hunt, Wray, Moin 1988): above 0 where rotation outweighs strain. lambda2 is the middle
/// eigenvalue of S S + Omega Omega (Jeong and Hussain 1995): below 0 in a vortex.
enum class FlowOperator { qCriterion, lambda2, vorticityMagnitude, divergence, gradientMagnitude };

/// What they are called where fields are defined, in the order of the enumeration.
inline constexpr std::array<std::string_view, 5> flowOperatorNames{"qcriterion", "lambda2", "vorticity_magnitude",
                                                                   "divergence", "gradient_magnitude"};

std::optional<FlowOperator> flowOperatorNamed(std::string_view name);

/// How many fields an operator is of: 3, the components of a vector, or 1.
constexpr std::size_t componentsOf(FlowOperator op)
{
    return op == FlowOperator::gradientMagnitude ? 1 : 3;
}

/// The value for these derivatives: gradients[i] is the gradient of component i; those behind componentsOf(op) are not
/// looked at.
double flowValue(FlowOperator op, const std::array<vec3d, 3>& gradients);

} // namespace brickwall
