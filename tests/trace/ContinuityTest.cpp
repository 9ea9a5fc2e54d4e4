// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// The reconstructed field across levels, as rays see it: by the production code, on both sides of every boundary.
#include "brickwall/core/io/Sample.h"
#include "brickwall/core/simd/Target.h"
#include "brickwall/core/trace/SamplePoints.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/RandomLayout.h"
#include "brickwall/tests/oracles/ReferenceReconstruction.h"

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace brickwall {
namespace {

using oracles::Random;
using oracles::ReferenceReconstruction;

/// Where N / D are both next to nothing, at the end of the data, rounding says what B is.
constexpr double leastWeight = 0.01;

struct Data
{
    Executor executor{1};
    Progress silent;
    Model model;
    RegionTree tree;
    PaddedField padded;
    ReferenceReconstruction reference;

    explicit Data(Model itsModel)
        : model(std::move(itsModel)),
          tree(buildRegions(model.bricks, executor, silent)),
          padded(padField(model.fields[0], model.bricks, tree, executor, silent)),
          reference(model, model.fields[0])
    {
    }

    /// B and its gradient in voxel space.
    std::vector<PointSample> sample(const std::vector<vec3d>& voxels) const
    {
        std::vector<PointSample> samples(voxels.size());
        samplePoints(tree, padded, mat4d(1.0), voxels, samples, executor);
        return samples;
    }

    double range() const { return double(padded.range.hi) - padded.range.lo; }

    /// Around a random cell of any level.
    vec3d point(Random& random) const
    {
        const Brick& brick = model.bricks[std::size_t(random.below(int(model.bricks.size())))];
        const vec3d cells = vec3d(random.real(), random.real(), random.real()) * (vec3d(brick.size) + 0.8) - 0.4;
        return vec3d(brick.lower) + cells * double(brick.cellWidth());
    }
};

Model randomModel(const oracles::RandomLayoutConfig& config)
{
    Model model = oracles::modelOf(oracles::randomLayout(config), [](const vec3d&) { return 0.0; });
    model.fields[0] = oracles::randomField(model.bricks, config.seed + 100);
    return model;
}

Model sampleModel(const std::string& name)
{
    const Executor executor;
    Progress silent;
    const auto set = openSample(name);
    Model model = set->load(std::vector{set->defaultField()}, executor, silent);
    model.worldFromVoxel = mat4d(1.0);
    return model;
}

/// Every place where a ray passes from one region to another.
void appendCrossings(const RegionTree& tree, const vec3d& org, const vec3d& dir, std::vector<vec3d>& places)
{
    for (const Region& region : tree.regions) {
        double t0 = -1e30, t1 = 1e30;
        for (int axis = 0; axis < 3; ++axis) {
            const double a = (0.5 * region.lower[axis] - org[axis]) / dir[axis];
            const double b = (0.5 * region.upper[axis] - org[axis]) / dir[axis];
            t0 = std::max(t0, std::min(a, b));
            t1 = std::min(t1, std::max(a, b));
        }
        if (t0 < t1)
            places.push_back(org + t0 * dir); // where it leaves, it enters the next one
    }
}

struct Jumps
{
    double largest = 0.0; ///< of B, as a share of its range
    vec3d where{0.0};
    std::size_t crossings = 0, acrossLevels = 0;
};

Jumps jumpsAlongRays(const Data& data, int rays)
{
    Random random(21);
    Jumps jumps;
    for (int i = 0; i < rays; ++i) {
        const vec3d org = data.point(random), dir = glm::normalize(data.point(random) - org);
        std::vector<vec3d> places, sides;
        appendCrossings(data.tree, org, dir, places);
        constexpr double apart = 1e-9; // voxels: more than a double's rounding, less than what B changes over
        for (const vec3d& place : places) {
            sides.push_back(place - apart * dir);
            sides.push_back(place + apart * dir);
        }
        const std::vector<PointSample> samples = data.sample(sides);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const PointSample &before = samples[2 * k], &after = samples[2 * k + 1];
            const std::int64_t from = findRegion(data.tree, 2.0 * sides[2 * k]);
            const std::int64_t to = findRegion(data.tree, 2.0 * sides[2 * k + 1]);
            if (from < 0 || to < 0 || from == to || !before.valid || !after.valid ||
                data.reference.atVoxel(places[k]).weight < leastWeight)
                continue;
            const Region &a = data.tree.regions[std::size_t(from)], &b = data.tree.regions[std::size_t(to)];
            ++jumps.crossings;
            jumps.acrossLevels += a.finestLevel != b.finestLevel || a.coarsestLevel != b.coarsestLevel;
            const double jump = std::abs(double(after.value) - before.value) / data.range();
            if (jump > jumps.largest) {
                jumps.largest = jump;
                jumps.where = places[k];
            }
        }
    }
    return jumps;
}

/// With every instruction set of this machine, as each rounds in its own way.
void expectContinuous(const Data& data, int rays)
{
    for (const std::string& target : laneTargets()) {
        SCOPED_TRACE(target);
        chooseLaneTarget(target);
        const Jumps jumps = jumpsAlongRays(data, rays);
        EXPECT_LE(jumps.largest, 1e-6) << "at voxel " << jumps.where.x << ' ' << jumps.where.y << ' ' << jumps.where.z;
        EXPECT_GT(jumps.crossings, std::size_t(rays));
        EXPECT_GT(jumps.acrossLevels, 0u);
        testing::Test::RecordProperty("largest jump", fmt::format("{:.2g}", jumps.largest));
    }
    chooseLaneTarget("");
}

/// The largest sine of the angle between the gradient and central differences, away from kinks.
double largestTurn(const Data& data, int points)
{
    Random random(22);
    std::vector<vec3d> places;
    while (places.size() < std::size_t(points)) {
        const vec3d p = data.point(random);
        const auto here = data.reference.atVoxel(p);
        if (here.valid && here.kinkDistance > 0.01 && here.weight > 0.05)
            places.push_back(p);
    }
    const std::vector<PointSample> samples = data.sample(places);
    double most = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        constexpr double h = 1e-4;
        vec3d difference;
        for (int axis = 0; axis < 3; ++axis) {
            vec3d low = places[i], high = places[i];
            low[axis] -= h;
            high[axis] += h;
            difference[axis] = (data.reference.atVoxel(high).value - data.reference.atVoxel(low).value) / (2.0 * h);
        }
        if (glm::length(difference) < 1e-3 * data.range()) // has no direction in floats
            continue;
        const vec3d a = glm::normalize(difference), b = glm::normalize(vec3d(samples[i].gradient));
        most = std::max(most, glm::dot(a, b) > 0.0 ? glm::length(glm::cross(a, b)) : 1.0);
    }
    return most;
}

TEST(Continuity, AcrossRegionsOfRandomLayouts)
{
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        SCOPED_TRACE(fmt::format("layout {}", seed));
        expectContinuous(Data(randomModel({.seed = seed, .jump = 0.5, .hole = seed % 2 == 0 ? 0.15 : 0.0})), 300);
    }
}

TEST(Continuity, AcrossRegionsOfNestedLevels)
{
    Model model = oracles::modelOf(oracles::nestedLevels(4, 4, 4), [](const vec3d&) { return 0.0; });
    model.fields[0] = oracles::randomField(model.bricks, 3);
    expectContinuous(Data(model), 300);
}

TEST(Continuity, AcrossRegionsOfSamples)
{
    for (const char* name : {"sample:wake:60k", "sample:cloud:60k", "sample:impact:60k"}) {
        SCOPED_TRACE(name);
        expectContinuous(Data(sampleModel(name)), 200);
    }
}

TEST(Continuity, GradientsPointWhereDifferencesDo)
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed)
        EXPECT_LT(largestTurn(Data(randomModel({.seed = seed, .jump = 0.5})), 2000), 1e-4) << "layout " << seed;
    for (const char* name : {"sample:wake:60k", "sample:cloud:60k", "sample:impact:60k"})
        EXPECT_LT(largestTurn(Data(sampleModel(name)), 2000), 1e-4) << name;
}

} // namespace
} // namespace brickwall
