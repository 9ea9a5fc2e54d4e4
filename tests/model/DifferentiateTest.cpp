// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// Derivatives at cells' centres on flows that know their own: inside of levels, where these meet and where data end.
#include "brickwall/core/model/Differentiate.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/Flows.h"
#include "brickwall/tests/oracles/RandomLayout.h"
#include "brickwall/tests/oracles/ReferenceReconstruction.h"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace brickwall {
namespace {

using namespace oracles;

constexpr std::array<FlowOperator, 4> ofVectors{FlowOperator::qCriterion, FlowOperator::lambda2,
                                                FlowOperator::vorticityMagnitude, FlowOperator::divergence};

/// [-half, half] in so many voxels.
mat4d worldOf(int voxels, double half = 3.0)
{
    return glm::scale(glm::translate(mat4d(1.0), vec3d(-half)), vec3d(2.0 * half / voxels));
}

std::vector<float> derive(FlowOperator op, const Model& model, int threads = 1)
{
    std::vector<std::span<const float>> fields;
    for (const Field& field : model.fields)
        fields.push_back(field.values);
    Progress silent;
    return differentiate(op, model.bricks, fields, model.worldFromVoxel, Executor(threads), silent);
}

/// A cell with what came out for it and what its flow says.
struct CellResult
{
    Box3i box; ///< voxels
    int level;
    double value, exact;

    double error() const { return std::abs(value - exact); }
};

std::vector<CellResult> resultsOf(FlowOperator op, const Flow& flow, const std::vector<Brick>& bricks,
                                  const mat4d& worldFromVoxel)
{
    const Model model = modelOf(bricks, flow, worldFromVoxel);
    const std::vector<float> values = derive(op, model);
    std::vector<CellResult> results;
    for (const Cell& cell : cellsOfBricks(model.bricks)) {
        const int width = 1 << cell.level;
        const vec3d world = transformPoint(worldFromVoxel, vec3d(cell.lower) + 0.5 * width);
        results.push_back(
            {{cell.lower, cell.lower + width}, cell.level, values[results.size()], flow.value(op, world)});
    }
    return results;
}

/// All cells but those in the outermost layer of a cube from 0 to `voxels`.
bool isInner(const CellResult& cell, int voxels)
{
    const Box3i& b = cell.box;
    return std::min({b.lower.x, b.lower.y, b.lower.z}) > 0 && std::max({b.upper.x, b.upper.y, b.upper.z}) < voxels;
}

double largestInside(FlowOperator op, const Flow& flow, int voxels, int level, double half)
{
    double most = 0.0;
    const auto bricks = uniformBlocks(vec3i(voxels >> (level + 2)), 4, level);
    for (const CellResult& cell : resultsOf(op, flow, bricks, worldOf(voxels, half)))
        if (isInner(cell, voxels))
            most = std::max(most, cell.error());
    return most;
}

TEST(Differentiate, IsOfSecondOrderInsideOfALevel)
{
    for (const Flow& flow : flows())
        for (const FlowOperator op : ofVectors) {
            if (op == FlowOperator::divergence && flow.name != "Burgers vortex")
                continue; // differences of the others cancel exactly
            const double coarse = largestInside(op, flow, 16, 0, 1.5), fine = largestInside(op, flow, 32, 0, 1.5);
            EXPECT_GT(coarse, 0.0);
            EXPECT_GT(coarse / fine, 3.4) << flow.name << ", operator " << int(op);
            EXPECT_LT(coarse / fine, 4.6) << flow.name << ", operator " << int(op);
        }
}

TEST(Differentiate, IsOfSecondOrderWhereLevelsMeetAndDataEnd)
{
    for (const Flow& flow : flows()) {
        const auto largest = [&](int width) {
            const std::vector<Brick> bricks = nestedLevels(3, 4, width);
            double most = 0.0;
            for (const CellResult& cell :
                 resultsOf(FlowOperator::qCriterion, flow, bricks, worldOf(voxelBounds(bricks).extent().x)))
                most = std::max(most, cell.error());
            return most;
        };
        EXPECT_GT(largest(4) / largest(8), 3.0) << flow.name;
    }
}

/// Q of every flow on layouts with jumps of 2:1 and 4:1. All bounds are errors inside of one level.
TEST(Differentiate, ErrsWhereLevelsMeetByAtMostFourTimesTheErrorInsideOfTheCoarser)
{
    constexpr int voxels = 48;
    constexpr double half = 2.25;
    for (const Flow& flow : flows()) {
        std::array<double, 3> inside;
        for (int level = 0; level < 3; ++level)
            inside[level] = largestInside(FlowOperator::qCriterion, flow, voxels, level, half);
        RandomLayoutConfig config;
        config.rootBlocks = vec3i(3);
        config.hole = 0.0;
        config.seed = 7;
        const auto cells = resultsOf(FlowOperator::qCriterion, flow, randomLayout(config), worldOf(voxels, half));
        std::vector<Box3i> boxes;
        for (const CellResult& cell : cells)
            boxes.push_back(cell.box);
        const BrickIndex index(boxes);
        std::uint64_t pairs = 0;
        double worstError = 0.0, worstJump = 0.0;
        for (const CellResult& cell : cells)
            if (isInner(cell, voxels))
                index.overlapping({cell.box.lower - 1, cell.box.upper + 1}, [&](std::uint32_t n, const Box3i&) {
                    const CellResult& other = cells[n];
                    if (other.level == cell.level || !isInner(other, voxels))
                        return;
                    const double coarser = inside[std::size_t(std::max(cell.level, other.level))];
                    const double jump = std::abs((cell.value - other.value) - (cell.exact - other.exact));
                    worstError = std::max(worstError, cell.error() / coarser);
                    worstJump = std::max(worstJump, jump / coarser);
                    ++pairs;
                });
        EXPECT_GT(pairs, 10000u);
        EXPECT_LE(worstError, 4.0) << flow.name;
        EXPECT_LE(worstJump, 4.0) << flow.name;
        RecordProperty(flow.name, std::to_string(worstError) + " " + std::to_string(worstJump));
    }
}

/// Why it is done as it is (docs/decisions/0032).
TEST(Differentiate, DifferencesOfBItselfAreWrongByAQuarterBesideACoarserLevel)
{
    std::vector<Brick> bricks = oneLevelBricks(vec3i(0), vec3i(8), vec3i(8), 0);
    bricks.push_back({{8, 0, 0}, vec3i(4), 1, 0});
    const Model model = modelOf(bricks, AffineField{0.0, {1.0, 0.0, 0.0}});
    const ReferenceReconstruction b(model, model.fields[0]);
    const vec3d centre(7.5, 4.5, 4.5), step(1.0, 0.0, 0.0);
    EXPECT_NEAR((b.atVoxel(centre + step).value - b.atVoxel(centre - step).value) / 2.0, 1.25, 1e-6);
    for (const float slope : derive(FlowOperator::gradientMagnitude, model))
        EXPECT_NEAR(slope, 1.0f, 1e-4f);
}

/// A polynomial of degree two as a velocity: with its gradients.
Flow quadraticFlow()
{
    return {"quadratic",
            [](const vec3d& p) {
                return vec3d(p.x * p.y - p.z * p.z, 2.0 * p.x - p.y * p.z + 1.0, p.x * p.x + 0.5 * p.y * p.y + p.z);
            },
            [](const vec3d& p) {
                return std::array{vec3d(p.y, p.x, -2.0 * p.z), vec3d(2.0, -p.z, -p.y), vec3d(2.0 * p.x, p.y, 1.0)};
            }};
}

TEST(Differentiate, IsExactForQuadraticFieldsAlsoBesideHolesLevelsAndTheEnd)
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        RandomLayoutConfig config;
        config.seed = seed;
        const auto bricks = randomLayout(config);
        for (const FlowOperator op : ofVectors)
            for (const CellResult& cell : resultsOf(op, quadraticFlow(), bricks, worldOf(32)))
                ASSERT_NEAR(cell.value, cell.exact, 2e-3) << "seed " << seed << ", operator " << int(op);
    }
}

TEST(Differentiate, IsPerWorldUnitAlongTheAxesOfTheWorld)
{
    const mat4d turned =
        glm::scale(glm::rotate(glm::translate(mat4d(1.0), vec3d(1.0, 2.0, -1.0)), 0.7, vec3d(1.0, 2.0, 0.5)),
                   vec3d(0.1, 0.2, -0.05));
    const auto bricks = randomLayout({});
    for (const FlowOperator op : ofVectors)
        for (const CellResult& cell : resultsOf(op, quadraticFlow(), bricks, turned))
            ASSERT_NEAR(cell.value, cell.exact, 3e-3 * (1.0 + std::abs(cell.exact))) << "operator " << int(op);
}

TEST(Differentiate, OfAScalarIsTheLengthOfItsGradient)
{
    const Model model =
        modelOf(randomLayout({}), AffineField{3.0, {1.0, 2.0, -2.0}}, glm::scale(mat4d(1.0), vec3d(0.5)));
    for (const float value : derive(FlowOperator::gradientMagnitude, model))
        ASSERT_NEAR(value, 6.0f, 1e-3f);
}

TEST(Differentiate, DoesNotSeeHowALevelIsCutIntoBricks)
{
    const Flow flow = abcFlow();
    const auto valuesByPlace = [&](const std::vector<Brick>& bricks) {
        std::map<std::array<int, 3>, double> values;
        for (const CellResult& cell : resultsOf(FlowOperator::qCriterion, flow, bricks, worldOf(24)))
            values[{cell.box.lower.x, cell.box.lower.y, cell.box.lower.z}] = cell.value;
        return values;
    };
    EXPECT_EQ(valuesByPlace(uniformBlocks(vec3i(1), 24)),
              valuesByPlace(oneLevelBricks(vec3i(0), vec3i(24), {5, 3, 1}, 0)));
    // Longer than what is worked on at a time, in every direction.
    const auto rod = [&](const vec3i& size) {
        return resultsOf(FlowOperator::qCriterion, quadraticFlow(), oneLevelBricks(vec3i(0), size, size, 0),
                         worldOf(100));
    };
    for (const vec3i size : {vec3i(130, 3, 3), vec3i(3, 35, 3), vec3i(3, 3, 35)})
        for (const CellResult& cell : rod(size))
            ASSERT_NEAR(cell.value, cell.exact, 1e-2);
}

TEST(Differentiate, OfDataThatAreThinIsOfFirstOrderOrNothing)
{
    const AffineField affine{1.0, {2.0, -3.0, 6.0}};
    const auto gradients = [&](const vec3i& size) {
        return derive(FlowOperator::gradientMagnitude, modelOf(oneLevelBricks(vec3i(0), size, size, 0), affine));
    };
    for (const float value : gradients({2, 2, 2}))
        EXPECT_NEAR(value, 7.0f, 2e-2f);
    for (const float value : gradients({5, 1, 4})) // a slice: as if it went on like that
        EXPECT_NEAR(value, std::sqrt(40.0f), 1e-3f);
    EXPECT_EQ(gradients({1, 1, 1})[0], 0.0f);
}

TEST(Differentiate, IsTheSameWithAnyNumberOfThreads)
{
    const Model model = modelOf(randomLayout({}), abcFlow(), worldOf(32));
    EXPECT_EQ(derive(FlowOperator::lambda2, model, 1), derive(FlowOperator::lambda2, model, 3));
}

TEST(Differentiate, CanBeStopped)
{
    const Model model = modelOf(randomLayout({}), abcFlow(), worldOf(32));
    Progress stopped;
    stopped.cancel();
    const std::span<const float> u = model.fields[0].values;
    EXPECT_THROW(differentiate(FlowOperator::gradientMagnitude, model.bricks, FieldValues(&u, 1), mat4d(1.0),
                               Executor(2), stopped),
                 Cancelled);
}

} // namespace
} // namespace brickwall
