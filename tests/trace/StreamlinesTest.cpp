// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// Lines whose form is known, on one level and across levels.
#include "brickwall/core/trace/Streamlines.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/Flows.h"
#include "brickwall/tests/oracles/RandomLayout.h"

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace brickwall {
namespace {

using namespace oracles;

constexpr double pi = std::numbers::pi;

Flow constantFlow(const vec3d& velocity)
{
    return {"constant", [=](const vec3d&) { return velocity; }, {}};
}

/// [-1, 1] in so many voxels.
mat4d worldOf(int voxels)
{
    return glm::scale(glm::translate(mat4d(1.0), vec3d(-1.0)), vec3d(2.0 / voxels));
}

std::vector<Streamline> trace(const Model& model, const std::vector<vec3d>& seeds, const StreamlineConfig& config,
                              int threads = 1)
{
    Progress silent;
    return traceStreamlines(VectorSampler(model, {0, 1, 2}), 1.0, seeds, config, Executor(threads), silent);
}

Streamline traceOne(const Model& model, const vec3d& seed, StreamlineConfig config, bool backward = false)
{
    config.backward = backward;
    const auto lines = trace(model, {seed}, config);
    return lines.empty() ? Streamline{} : lines[0];
}

std::vector<Brick> randomLevels(std::uint64_t seed)
{
    RandomLayoutConfig config;
    config.seed = seed;
    config.hole = 0.0;
    return randomLayout(config);
}

/// Ten turns around the middle end where they began, to 1e-4 of the radius.
void expectCircle(const std::vector<Brick>& bricks, const std::string& what)
{
    const Model model = modelOf(bricks, solidRotation(), worldOf(32));
    for (const double radius : {0.21, 0.5, 0.83}) {
        StreamlineConfig config;
        config.length = 10.0 * 2.0 * pi * radius;
        const vec3d seed(0.0, radius, 0.13);
        for (const bool backward : {false, true}) {
            config.forward = !backward;
            const Streamline line = traceOne(model, seed, config, backward);
            ASSERT_GT(line.points.size(), 50u);
            const vec3d other = backward ? line.points.front() : line.points.back();
            EXPECT_LT(glm::distance(other, seed), 1e-4 * radius) << what << ", radius " << radius;
            EXPECT_EQ(backward ? line.begin : line.end, StreamlineEnd::length);
            for (const vec3d& p : line.points)
                ASSERT_NEAR(std::hypot(p.x, p.y), radius, 1e-4 * radius) << what;
        }
    }
}

TEST(Streamlines, InACircleReturnToTheirStart)
{
    expectCircle(uniformBlocks(vec3i(4), 8), "one level");
}

TEST(Streamlines, InACircleReturnToTheirStartAcrossLevels)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
        expectCircle(randomLevels(seed), "levels " + std::to_string(seed));
}

TEST(Streamlines, StayWithinAnErrorThatTheToleranceSays)
{
    const Model model = modelOf(uniformBlocks(vec3i(4), 8), solidRotation(), worldOf(32));
    const vec3d seed(0.5, 0.0, 0.0);
    const auto error = [&](double tolerance) {
        StreamlineConfig config;
        config.tolerance = tolerance;
        config.longestStep = 1e9;
        config.length = 10.0 * pi;
        return glm::distance(traceOne(model, seed, config).points.back(), seed);
    };
    EXPECT_LT(error(1e-8), 0.01 * error(1e-4));
    EXPECT_LT(error(1e-4), 1e-2);
}

/// In the plane z = 0 Taylor and Green's flow goes along the contours of sin x sin y.
TEST(Streamlines, FollowTheStreamFunctionToSecondOrderOfTheCells)
{
    const auto drift = [](int width) {
        const std::vector<Brick> bricks = nestedLevels(2, 4, width);
        const int voxels = voxelBounds(bricks).extent().x;
        const mat4d world = glm::scale(glm::translate(mat4d(1.0), vec3d(0.0, 0.0, -pi / 2)), vec3d(pi / voxels));
        const Model model = modelOf(bricks, taylorGreenFlow(), world);
        StreamlineConfig config;
        config.length = 6.0;
        double most = 0.0;
        for (const double x : {0.4, 0.8, 1.2})
            for (const vec3d& p : traceOne(model, {x, pi / 2, 0.0}, config).points)
                most = std::max(most, std::abs(std::sin(p.x) * std::sin(p.y) - std::sin(x)));
        return most;
    };
    const double coarse = drift(4), fine = drift(8);
    EXPECT_LT(coarse, 0.1);
    EXPECT_GT(coarse / fine, 3.0);
}

TEST(Streamlines, EndAtTheEdgeOfTheDataAndAtHoles)
{
    std::vector<Brick> bricks = uniformBlocks({4, 1, 1}, 4);
    bricks.erase(bricks.begin() + 2); // nothing from 8 to 12
    const Model model = modelOf(bricks, constantFlow({1.0, 0.0, 0.0}), mat4d(1.0));
    const Streamline line = traceOne(model, {3.3, 1.7, 2.2}, {}, true);
    EXPECT_EQ(line.begin, StreamlineEnd::edge);
    EXPECT_EQ(line.end, StreamlineEnd::edge);
    EXPECT_NEAR(line.points.front().x, 0.0, 2e-3);
    EXPECT_NEAR(line.points.back().x, 8.0, 2e-3);
    EXPECT_EQ(line.points[line.seed], vec3d(3.3, 1.7, 2.2));
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        EXPECT_GT(line.points[i].x, line.points[i - 1].x);
        EXPECT_EQ(line.points[i].y, 1.7);
    }
    const Streamline behind = traceOne(model, {13.0, 1.0, 1.0}, {}, true);
    EXPECT_NEAR(behind.points.front().x, 12.0, 2e-3);
    EXPECT_TRUE(trace(model, {vec3d(10.0, 1.0, 1.0), vec3d(-5.0), vec3d(1e30), vec3d(std::nan(""))}, {}).empty());
}

TEST(Streamlines, EndWhereNothingMoves)
{
    const Flow sink{"sink", [](const vec3d& p) { return -p; }, {}};
    const Streamline line = traceOne(modelOf(uniformBlocks(vec3i(2), 8), sink, worldOf(16)), {0.6, -0.4, 0.3}, {});
    EXPECT_EQ(line.end, StreamlineEnd::stagnation);
    EXPECT_LT(glm::length(line.points.back()), 1e-5);
    const Model still = modelOf(uniformBlocks(vec3i(1), 4), constantFlow(vec3d(0.0)), mat4d(1.0));
    const Streamline point = traceOne(still, vec3d(2.0), {}, true);
    EXPECT_EQ(point.points.size(), 1u);
    EXPECT_EQ(point.begin, StreamlineEnd::stagnation);
}

TEST(Streamlines, HaveTheLengthAndTheStepsThatWereAskedFor)
{
    const Model model = modelOf(uniformBlocks(vec3i(4), 8), solidRotation(), worldOf(32));
    StreamlineConfig config;
    config.length = 0.7;
    const Streamline line = traceOne(model, {0.5, 0.0, 0.0}, config, true);
    const vec3d expected(0.5 * std::cos(1.4), 0.5 * std::sin(1.4), 0.0);
    EXPECT_LT(glm::distance(line.points.back(), expected), 1e-5);
    EXPECT_LT(glm::distance(line.points.front(), expected * vec3d(1, -1, 1)), 1e-5);
    config.length = 0.0;
    config.steps = 17;
    const Streamline steps = traceOne(model, {0.5, 0.0, 0.0}, config);
    EXPECT_EQ(steps.points.size(), 18u);
    EXPECT_EQ(steps.end, StreamlineEnd::steps);
    config.tolerance = 0.0;
    EXPECT_THROW(traceOne(model, {0.5, 0.0, 0.0}, config), Error);
}

TEST(Streamlines, AreTheSameWithAnyNumberOfThreadsAndCanBeStopped)
{
    const Model model = modelOf(randomLevels(5), abcFlow(), worldOf(32));
    const auto seeds = scatteredSeeds({vec3d(-0.9), vec3d(0.9)}, 20);
    StreamlineConfig config;
    config.steps = 30;
    const auto one = trace(model, seeds, config, 1), three = trace(model, seeds, config, 3);
    ASSERT_EQ(one.size(), 20u);
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_EQ(one[i].points, three[i].points);
    Progress stopped;
    stopped.cancel();
    EXPECT_THROW(traceStreamlines(VectorSampler(model, {0, 1, 2}), 1.0, seeds, config, Executor(2), stopped),
                 Cancelled);
}

TEST(VectorSampler, IsExactForLinearVectorsAcrossLevelsAndContinuousForOthers)
{
    Random random(4);
    const auto bricks = randomLevels(2);
    const Model linear = modelOf(bricks, solidRotation(), worldOf(32)),
                curved = modelOf(bricks, abcFlow(), worldOf(32));
    const VectorSampler ofLinear(linear, {0, 1, 2}), ofCurved(curved, {0, 1, 2});
    VectorSampler::Memo memo, memoOfCurved;
    for (int i = 0; i < 3000; ++i) {
        vec3d p = 2.0 * vec3d(random.real(), random.real(), random.real()) - 1.0;
        if (i % 3 == 0) // in a plane of faces and centres
            p[i % 9 / 3] = double(random.below(64)) / 32.0 - 1.0;
        EXPECT_LT(glm::distance(ofLinear.at(p, memo)->value, vec3d(-p.y, p.x, 0.0)), 2e-6);
        const vec3d q = p + 1e-7 * (0.5 - vec3d(random.real(), random.real(), random.real()));
        const auto here = ofCurved.at(p, memoOfCurved), there = ofCurved.at(q, memoOfCurved);
        ASSERT_TRUE(here.has_value());
        EXPECT_LT(there ? glm::distance(here->value, there->value) : 0.0, 2e-6);
    }
}

TEST(Tubes, AreClosedAndHaveTheirRadius)
{
    Streamline line;
    for (int i = 0; i <= 40; ++i)
        line.points.push_back({std::cos(0.1 * i), std::sin(0.1 * i), 0.05 * i});
    line.points.push_back(line.points.back()); // twice
    Streamline dot;
    dot.points = {vec3d(5.0)};
    constexpr double radius = 0.03;
    constexpr int sides = 8;
    const TriangleMesh mesh = tubesAround(std::vector{line, dot}, radius, sides);
    EXPECT_EQ(mesh.vertices.size(), 41u * sides);
    std::map<std::pair<int, int>, int> edges;
    double volume = 0.0, length = 0.0;
    for (const vec3i& t : mesh.triangles) {
        for (int i = 0; i < 3; ++i)
            ++edges[{t[i], t[(i + 1) % 3]}];
        const vec3d p(mesh.vertices[t[0]]), q(mesh.vertices[t[1]]), r(mesh.vertices[t[2]]);
        volume += glm::dot(p, glm::cross(q, r)) / 6.0;
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first})); // outward all around
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        EXPECT_NEAR(glm::distance(vec3d(mesh.vertices[v]), line.points[v / sides]), radius, 1e-6);
    for (int i = 0; i < 40; ++i)
        length += glm::distance(line.points[i], line.points[i + 1]);
    const double section = 0.5 * sides * std::sin(2.0 * pi / sides) * radius * radius;
    EXPECT_NEAR(std::abs(volume), section * length, 0.02 * section * length);
    EXPECT_GT(volume, 0.0);
    const TriangleMesh thereAndBack =
        tubesAround(std::vector<Streamline>{{{vec3d(0), vec3d(1, 0, 0), vec3d(0)}, 0, {}, {}}}, 0.1, 3);
    for (const vec3f& v : thereAndBack.vertices)
        EXPECT_TRUE(std::isfinite(v.x + v.y + v.z));
}

TEST(Seeds, FillTheirBox)
{
    const Box3d box{{1, 2, 3}, {2, 4, 6}};
    const auto scattered = scatteredSeeds(box, 64), gridded = griddedSeeds(box, {2, 1, 3});
    ASSERT_EQ(scattered.size(), 64u);
    ASSERT_EQ(gridded.size(), 6u);
    EXPECT_EQ(gridded[1], vec3d(1.75, 3.0, 3.5));
    vec3d sum(0.0);
    for (const vec3d& p : scattered) {
        EXPECT_TRUE(box.contains(p));
        sum += p;
    }
    EXPECT_LT(glm::distance(sum / 64.0, vec3d(1.5, 3.0, 4.5)), 0.1);
    const auto fewer = scatteredSeeds(box, 10);
    EXPECT_TRUE(std::equal(fewer.begin(), fewer.end(), scattered.begin()));
}

} // namespace
} // namespace brickwall
