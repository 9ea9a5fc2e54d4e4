// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/FlowOperators.h"
#include "brickwall/tests/oracles/Flows.h"
#include "brickwall/tests/oracles/RandomLayout.h"

#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace brickwall {
namespace {

using namespace oracles;
using Gradients = std::array<vec3d, 3>;

Gradients randomGradients(Random& random)
{
    Gradients g;
    for (vec3d& component : g)
        for (int axis = 0; axis < 3; ++axis)
            component[axis] = 2.0 * random.real() - 1.0;
    return g;
}

glm::dmat3 squaresOf(const Gradients& g)
{
    const glm::dmat3 j(g[0], g[1], g[2]), t = glm::transpose(j), s = 0.5 * (j + t), omega = 0.5 * (j - t);
    return s * s + omega * omega;
}

TEST(FlowOperators, AreFoundByTheirNames)
{
    for (std::size_t i = 0; i < flowOperatorNames.size(); ++i)
        EXPECT_EQ(flowOperatorNamed(flowOperatorNames[i]), static_cast<FlowOperator>(i));
    EXPECT_FALSE(flowOperatorNamed("qCriterion"));
    EXPECT_FALSE(flowOperatorNamed(""));
}

TEST(FlowOperators, OfSolidRotationShearAndStrainAreTheTextbooks)
{
    const Gradients rotation{vec3d(0, -1, 0), vec3d(1, 0, 0), vec3d(0)};
    EXPECT_DOUBLE_EQ(flowValue(FlowOperator::qCriterion, rotation), 1.0);
    EXPECT_NEAR(flowValue(FlowOperator::lambda2, rotation), -1.0, 1e-7); // an angle at its end
    EXPECT_DOUBLE_EQ(flowValue(FlowOperator::vorticityMagnitude, rotation), 2.0);
    EXPECT_DOUBLE_EQ(flowValue(FlowOperator::divergence, rotation), 0.0);
    const Gradients shear{vec3d(0, 3, 0), vec3d(0), vec3d(0)};
    EXPECT_DOUBLE_EQ(flowValue(FlowOperator::qCriterion, shear), 0.0);
    EXPECT_NEAR(flowValue(FlowOperator::lambda2, shear), 0.0, 1e-7);
    const Gradients strain{vec3d(1, 0, 0), vec3d(0, 1, 0), vec3d(0, 0, -2)};
    EXPECT_DOUBLE_EQ(flowValue(FlowOperator::qCriterion, strain), -3.0);
    EXPECT_NEAR(flowValue(FlowOperator::lambda2, strain), 1.0, 1e-7);
    EXPECT_DOUBLE_EQ(flowValue(FlowOperator::gradientMagnitude, {vec3d(2, 3, 6), vec3d(0), vec3d(0)}), 7.0);
    EXPECT_EQ(flowValue(FlowOperator::lambda2, {vec3d(0), vec3d(0), vec3d(0)}), 0.0);
}

TEST(FlowOperators, QIsHalfOfRotationLessStrain)
{
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const Gradients g = randomGradients(random);
        double omega = 0.0, strain = 0.0;
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) {
                omega += std::pow(0.5 * (g[r][c] - g[c][r]), 2);
                strain += std::pow(0.5 * (g[r][c] + g[c][r]), 2);
            }
        EXPECT_NEAR(flowValue(FlowOperator::qCriterion, g), 0.5 * (omega - strain), 1e-14);
    }
}

TEST(FlowOperators, Lambda2IsTheMiddleEigenvalue)
{
    Random random(2);
    for (int i = 0; i < 1000; ++i) {
        const Gradients g = randomGradients(random);
        const glm::dmat3 m = squaresOf(g);
        const double middle = flowValue(FlowOperator::lambda2, g);
        EXPECT_NEAR(glm::determinant(m - glm::dmat3(middle)), 0.0, 1e-13) << i;
        // The other two are the roots of what is left: on either side of it.
        const double sum = m[0][0] + m[1][1] + m[2][2] - middle;
        const double minors = m[0][0] * m[1][1] + m[0][0] * m[2][2] + m[1][1] * m[2][2] - m[0][1] * m[1][0] -
                              m[0][2] * m[2][0] - m[1][2] * m[2][1];
        const double product = minors - middle * sum;
        const double root = std::sqrt(std::max(0.25 * sum * sum - product, 0.0));
        EXPECT_LE(0.5 * sum - root, middle + 1e-12) << i;
        EXPECT_GE(0.5 * sum + root, middle - 1e-12) << i;
    }
}

/// What the oracles say of themselves, against differences of their velocity.
TEST(FlowOracles, KnowTheirDerivatives)
{
    constexpr double h = 1e-5;
    Random random(3);
    std::vector<Flow> all = flows();
    all.push_back(solidRotation());
    for (const Flow& flow : all)
        for (int i = 0; i < 200; ++i) {
            const vec3d p = 4.0 * vec3d(random.real(), random.real(), random.real()) - 2.0;
            const Gradients g = flow.gradients(i == 0 ? vec3d(0.0) : p);
            for (int axis = 0; axis < 3; ++axis) {
                vec3d step(0.0);
                step[axis] = h;
                const vec3d q = i == 0 ? vec3d(0.0) : p;
                const vec3d slope = (flow.velocity(q + step) - flow.velocity(q - step)) / (2.0 * h);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(g[c][axis], slope[c], 1e-8) << flow.name;
            }
        }
}

} // namespace
} // namespace brickwall
