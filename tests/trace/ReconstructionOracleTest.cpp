// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/RandomLayout.h"
#include "brickwall/tests/oracles/ReferenceIntegral.h"
#include "brickwall/tests/oracles/ReferenceReconstruction.h"

#include <gtest/gtest.h>

#include <cmath>

// The judges are judged: closed forms and finite differences, no product code.
namespace brickwall {
namespace {

using oracles::BoxRay;
using oracles::ReferenceReconstruction;

TEST(ReconstructionOracle, GradientIsTheDifferenceQuotient)
{
    Model model = oracles::modelOf(oracles::randomLayout({.seed = 3}), [](const vec3d&) { return 0.0; });
    model.fields[0] = oracles::randomField(model.bricks, 9);
    const ReferenceReconstruction twin(model, model.fields[0]);
    const vec3d extent = voxelBounds(model.bricks).extent();
    oracles::Random random(4);
    int compared = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3d p = vec3d(random.real(), random.real(), random.real()) * extent;
        const auto here = twin.at(p);
        if (!here.valid || here.kinkDistance < 1e-3 || here.weight < 0.05)
            continue;
        ++compared;
        for (int axis = 0; axis < 3; ++axis) {
            const double h = 1e-5;
            vec3d a = p, b = p;
            a[axis] -= h;
            b[axis] += h;
            ASSERT_NEAR(here.gradient[axis], (twin.at(b).value - twin.at(a).value) / (2.0 * h), 1e-4);
        }
    }
    EXPECT_GT(compared, 1000);
}

TEST(ReconstructionOracle, EndsHalfACellBeyondTheData)
{
    const Model model =
        oracles::modelOf(oracles::oneLevelBricks(vec3i(0), vec3i(2), vec3i(2), 1), [](const vec3d& p) { return p.x; });
    const ReferenceReconstruction twin(model, model.fields[0]);
    EXPECT_TRUE(twin.at({-0.999, 2.0, 2.0}).valid);
    EXPECT_FALSE(twin.at({-1.0, 2.0, 2.0}).valid);
    EXPECT_FALSE(twin.at({2.0, 2.0, 5.001}).valid);
    EXPECT_EQ(twin.at({2.0, 2.0, 2.0}).value, 2.0);
    EXPECT_EQ(twin.at({2.0, 2.0, 2.0}).weight, 1.0);
    EXPECT_EQ(twin.at({-0.5, 2.0, 2.0}).value, 1.0); // nothing but the first cells reaches here
}

TEST(ReconstructionOracle, RayLengthsInABoxAreThoseOfGeometry)
{
    const Box3d box{vec3d(1.0), vec3d(3.0)};
    const vec3d diagonal(0.5);
    EXPECT_NEAR(BoxRay(box, vec3d(0.0), diagonal).length(diagonal), 2.0 * std::sqrt(3.0), 1e-12);
    const vec3d along(0.0, 0.0, -4.0);
    EXPECT_NEAR(BoxRay(box, {2.0, 2.0, 2.5}, along).length(along), 1.5, 1e-12); // from inside
    EXPECT_EQ(BoxRay(box, {2.0, 2.0, 0.0}, along).length(along), 0.0);          // behind the origin
    EXPECT_EQ(BoxRay(box, {0.0, 2.0, 5.0}, along).length(along), 0.0);          // beside it
}

TEST(ReconstructionOracle, OpacityIsThatPerReferenceLength)
{
    const double sigma = oracles::extinctionOf(0.3, 2.0);
    EXPECT_NEAR(oracles::constantOpacity(sigma, 2.0), 0.3, 1e-15);
    EXPECT_NEAR(oracles::constantOpacity(sigma, 6.0), 1.0 - 0.7 * 0.7 * 0.7, 1e-15);
    EXPECT_NEAR(oracles::constantRadiance({1.0, 0.5, 0.0}, sigma, 2.0).y, 0.15, 1e-15);
}

} // namespace
} // namespace brickwall
