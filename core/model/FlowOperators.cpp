// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/FlowOperators.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brickwall {
namespace {

using Gradients = std::array<vec3d, 3>;

double qCriterion(const Gradients& g)
{
    return -0.5 * (g[0].x * g[0].x + g[1].y * g[1].y + g[2].z * g[2].z) - g[0].y * g[1].x - g[0].z * g[2].x -
           g[1].z * g[2].y;
}

vec3d vorticity(const Gradients& g)
{
    return {g[2].y - g[1].z, g[0].z - g[2].x, g[1].x - g[0].y};
}

/// The middle eigenvalue of a symmetric matrix in closed form (Smith 1961), of the matrix less a third of its trace.
double middleEigenvalue(glm::dmat3 m)
{
    const double mean = (m[0][0] + m[1][1] + m[2][2]) / 3.0;
    for (int i = 0; i < 3; ++i)
        m[i][i] -= mean;
    double squares = 0.0;
    for (int i = 0; i < 3; ++i)
        squares += glm::dot(m[i], m[i]);
    const double p = std::sqrt(squares / 6.0);
    if (!(p > 0.0))
        return mean;
    const double r = std::clamp(0.5 * glm::determinant(m / p), -1.0, 1.0);
    // The largest is at angle phi in [0, pi/3], the middle one a third of a turn before it.
    const double phi = std::acos(r) / 3.0;
    return mean + 2.0 * p * std::cos(phi - 2.0 / 3.0 * std::numbers::pi);
}

double lambda2(const Gradients& g)
{
    const glm::dmat3 j(g[0], g[1], g[2]);
    const glm::dmat3 t = glm::transpose(j);
    const glm::dmat3 s = 0.5 * (j + t), omega = 0.5 * (j - t);
    return middleEigenvalue(s * s + omega * omega);
}

} // namespace

std::optional<FlowOperator> flowOperatorNamed(std::string_view name)
{
    const auto found = std::find(flowOperatorNames.begin(), flowOperatorNames.end(), name);
    if (found == flowOperatorNames.end())
        return {};
    return static_cast<FlowOperator>(found - flowOperatorNames.begin());
}

double flowValue(FlowOperator op, const Gradients& g)
{
    switch (op) {
    case FlowOperator::qCriterion:
        return qCriterion(g);
    case FlowOperator::lambda2:
        return lambda2(g);
    case FlowOperator::vorticityMagnitude:
        return glm::length(vorticity(g));
    case FlowOperator::divergence:
        return g[0].x + g[1].y + g[2].z;
    case FlowOperator::gradientMagnitude:
        return glm::length(g[0]);
    }
    return 0.0;
}

} // namespace brickwall
