// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/SamplePoints.h"

#include "brickwall/core/io/Sample.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/RandomLayout.h"
#include "brickwall/tests/oracles/RealFiles.h"
#include "brickwall/tests/oracles/ReferenceReconstruction.h"

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace brickwall {
namespace {

using oracles::AffineField;
using oracles::Random;
using oracles::ReferenceReconstruction;

/// The product's view of the first field of a model.
struct Prepared
{
    Executor executor;
    Progress silent;
    RegionTree tree;
    PaddedField padded;

    explicit Prepared(const Model& model)
        : tree(buildRegions(model.bricks, executor, silent)),
          padded(padField(model.fields[0], model.bricks, tree, executor, silent))
    {
    }

    std::vector<PointSample> sample(const Model& model, const std::vector<vec3d>& world) const
    {
        std::vector<PointSample> samples(world.size());
        samplePoints(tree, padded, model.worldFromVoxel, world, samples, executor);
        return samples;
    }
};

/// World points around random leaf cells of all sizes alike, a half cell beyond the cell's faces included, so that
/// small cells, level boundaries and the rim of the data get their share.
std::vector<vec3d> pointsAround(const Model& model, std::size_t count, std::uint64_t seed)
{
    Random random(seed);
    std::vector<vec3d> points(count);
    for (vec3d& p : points) {
        const Brick& brick = model.bricks[std::size_t(random.below(int(model.bricks.size())))];
        const vec3d extent = vec3d(brick.size) + 1.2;
        const vec3d cells = vec3d(random.real(), random.real(), random.real()) * extent - 0.6;
        p = transformPoint(model.worldFromVoxel, vec3d(brick.lower) + cells * double(brick.cellWidth()));
    }
    return points;
}

/// How far the product is from its twin.
struct Deviation
{
    double value = 0.0;       ///< largest, as a share of the field's range; at the rim times D / 0.05
    double gradient = 0.0;    ///< largest away from kinks, in ranges per finest cell width; the same
    std::size_t validity = 0; ///< points where the two disagree on whether there is data
    std::size_t compared = 0;
    vec3d worst{0.0};
};

Deviation deviation(const Model& model, std::size_t count, std::uint64_t seed)
{
    const Prepared prepared(model);
    const ReferenceReconstruction reference(model, model.fields[0]);
    const std::vector<vec3d> points = pointsAround(model, count, seed);
    const std::vector<PointSample> samples = prepared.sample(model, points);
    const double range = std::max(double(model.fields[0].range.hi) - model.fields[0].range.lo, 1e-300);
    const double voxelWidth = std::cbrt(std::abs(glm::determinant(glm::dmat3(model.worldFromVoxel))));
    const auto perLevel = cellsPerLevel(model.bricks);
    const double finest =
        voxelWidth *
        std::ldexp(1.0, int(std::ranges::find_if(perLevel, [](auto n) { return n > 0; }) - perLevel.begin()));
    Deviation d;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto twin = reference.at(points[i]);
        // Where the supports end D is 0, and rounding decides on which side a point lies.
        if (twin.valid != samples[i].valid) {
            d.validity += twin.weight > 1e-6 || samples[i].valid ? 1 : 0;
            continue;
        }
        if (!twin.valid)
            continue;
        ++d.compared;
        // Towards the rim of the data D runs to 0, and the rounding of a position counts one over it as much.
        const double certain = std::min(1.0, twin.weight / 0.05);
        const double value = std::abs(samples[i].value - twin.value) / range * certain;
        if (value > d.value) {
            d.value = value;
            d.worst = points[i];
        }
        if (twin.kinkDistance > 1e-3 && twin.weight > 1e-2)
            d.gradient = std::max(d.gradient, glm::length(vec3d(samples[i].gradient) - twin.gradient) / range * finest *
                                                  certain);
    }
    return d;
}

void expectTwin(const Model& model, std::size_t count)
{
    const Deviation d = deviation(model, count, 7);
    EXPECT_LT(d.value, 1e-5) << "at world " << d.worst.x << ' ' << d.worst.y << ' ' << d.worst.z;
    EXPECT_LT(d.gradient, 1e-3);
    EXPECT_EQ(d.validity, 0u);
    EXPECT_GT(d.compared, count / 2);
    testing::Test::RecordProperty("value deviation", fmt::format("{:.2g}", d.value));
    testing::Test::RecordProperty("gradient deviation", fmt::format("{:.2g}", d.gradient));
}

/// The default field.
Model loaded(const std::unique_ptr<DataSet>& set)
{
    const Executor executor;
    Progress silent;
    const std::vector<std::string> fields{set->defaultField()};
    return set->load(fields, executor, silent);
}

const std::string shared = BRICKWALL_SOURCE_DIR "/../shared/data/";

/// A format that nobody reads yet is no failure of the reconstruction; a file that its reader refuses is one.
void expectTwinOfFile(const std::string& file, std::size_t count)
{
    if (!std::filesystem::exists(shared + file))
        GTEST_SKIP() << "needs " << file << " in ../shared/data";
    std::unique_ptr<DataSet> set;
    try {
        set = openDataSet(shared + file);
    } catch (const Error& error) {
        if (std::string(error.what()).find("of no format") == std::string::npos)
            throw;
        GTEST_SKIP() << "no reader for " << file;
    }
    if (set->fieldNames().empty())
        GTEST_SKIP() << file << " has no field";
    expectTwin(loaded(set), count);
}

class ReconstructionOfSample : public testing::TestWithParam<std::string>
{
};

TEST_P(ReconstructionOfSample, IsThatOfTheTwin)
{
    expectTwin(loaded(openSample(GetParam())), 100000);
}

TEST_P(ReconstructionOfSample, IsThatOfTheTwinLong)
{
    expectTwin(loaded(openSample(GetParam())), 1000000);
}

INSTANTIATE_TEST_SUITE_P(Samples, ReconstructionOfSample,
                         testing::Values("sample:wake:300k", "sample:cloud:300k", "sample:impact:300k"),
                         [](const auto& info) { return info.param.substr(7, info.param.rfind(':') - 7); });

class ReconstructionOfFile : public testing::TestWithParam<std::string>
{
};

TEST_P(ReconstructionOfFile, IsThatOfTheTwin)
{
    expectTwinOfFile(GetParam(), 100000);
}

TEST_P(ReconstructionOfFile, IsThatOfTheTwinLong)
{
    expectTwinOfFile(GetParam(), 1000000);
}

INSTANTIATE_TEST_SUITE_P(Files, ReconstructionOfFile, testing::ValuesIn(oracles::realFiles), [](const auto& info) {
    std::string name = info.param;
    std::ranges::replace_if(
        name, [](unsigned char c) { return !std::isalnum(c); }, '_');
    return name;
});

TEST(Reconstruction, IsThatOfTheTwinOnRaggedLayouts)
{
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        std::vector<Brick> bricks = oracles::randomLayout({.seed = seed});
        Model model = oracles::modelOf(bricks, [](const vec3d&) { return 0.0; });
        model.fields[0] = oracles::randomField(model.bricks, seed + 100);
        expectTwin(model, 10000);
    }
}

TEST(Reconstruction, OfATransformedModelHasWorldGradients)
{
    const mat4d world = glm::rotate(glm::scale(glm::translate(mat4d(1.0), vec3d(40.0, -3.0, 7.0)), vec3d(0.01)), 0.7,
                                    vec3d(1.0, 2.0, -1.0));
    Model model = oracles::modelOf(
        oracles::randomLayout({.seed = 5}), [](const vec3d& p) { return p.x * p.y; }, world);
    expectTwin(model, 10000);
}

TEST(Reconstruction, OfAnAffineFieldOnOneLevelIsItself)
{
    for (int level : {0, 3}) {
        SCOPED_TRACE(level);
        const AffineField affine{2.0, vec3d(0.5, -0.25, 0.125) / double(1 << level)};
        const vec3i size(19, 16, 13);
        const Model model = oracles::modelOf(oracles::oneLevelBricks(vec3i(-3), size, vec3i(7, 8, 5), level), affine);
        const Prepared prepared(model);
        Random random(3);
        std::vector<vec3d> points(20000);
        for (vec3d& p : points) // inside the outermost cell centres all eight cells are there
            p = (vec3d(-2.5) + vec3d(random.real(), random.real(), random.real()) * vec3d(size - 1)) *
                double(1 << level);
        const std::vector<PointSample> samples = prepared.sample(model, points);
        const double rounding = 8.0 * 1.2e-7 * std::max(std::abs(model.fields[0].range.lo), model.fields[0].range.hi);
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_TRUE(samples[i].valid);
            ASSERT_NEAR(samples[i].value, affine(points[i]), rounding);
            ASSERT_LT(glm::length(vec3d(samples[i].gradient) - affine.gradient), rounding / (1 << level));
        }
    }
}

TEST(Reconstruction, OfAConstantIsThatConstantExactly)
{
    for (const float constant : {0.1f, -3.7e20f, 1e-30f})
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
            SCOPED_TRACE(testing::Message() << constant << ", layout " << seed);
            const Model model = oracles::modelOf(oracles::randomLayout({.seed = seed, .coarsestLevel = 3}),
                                                 [&](const vec3d&) { return double(constant); });
            const Prepared prepared(model);
            std::size_t valid = 0;
            for (const PointSample& s : prepared.sample(model, pointsAround(model, 20000, seed))) {
                valid += s.valid;
                if (s.valid) {
                    ASSERT_EQ(s.value, constant);
                    ASSERT_EQ(s.gradient, vec3f(0.0f));
                }
            }
            EXPECT_GT(valid, 10000u);
        }
}

} // namespace
} // namespace brickwall
