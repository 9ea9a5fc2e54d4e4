// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// Surfaces of the Q criterion at a high value, where bricks and levels meet: one-sided differences at the edges of
// grids beside derivatives that see what is around.
#include "Exhibit.h"

#include "brickwall/core/model/BrickIndex.h"
#include "brickwall/core/model/Differentiate.h"
#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/tests/oracles/Flows.h"

#include <glm/ext/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

namespace brickwall::test {
namespace {

/// A vortex with a core of 8 voxels, aslant, through the middle of data that are fine at x < 16 and coarse beyond.
struct SlantedVortex
{
    oracles::Flow flow = oracles::burgersVortex();
    mat4d flowFromVoxel = glm::translate(
        glm::scale(glm::rotate(glm::rotate(mat4d(1.0), 0.5, vec3d(1, 0, 0)), 1.1, vec3d(0, 1, 0)), vec3d(0.125)),
        vec3d(-16.3, -15.4, -16.2));
    Model model;

    SlantedVortex()
    {
        std::vector<Brick> bricks = oracles::oneLevelBricks(vec3i(0), {16, 32, 32}, vec3i(8), 0);
        for (const Brick& brick : oracles::oneLevelBricks({8, 0, 0}, {8, 16, 16}, vec3i(4), 1))
            bricks.push_back(brick);
        model = oracles::modelOf(std::move(bricks), flow, flowFromVoxel);
    }

    double exactQ(const vec3d& voxel) const
    {
        return flow.value(FlowOperator::qCriterion, transformPoint(flowFromVoxel, voxel));
    }

    std::vector<float> values(const Executor& executor) const
    {
        std::array<std::span<const float>, 3> fields;
        for (std::size_t f = 0; f < 3; ++f)
            fields[f] = model.fields[f].values;
        Progress silent;
        return differentiate(FlowOperator::qCriterion, model.bricks, fields, flowFromVoxel, executor, silent);
    }

    /// As tools do that know one grid at a time: second order in a brick, one-sided at its faces.
    std::vector<float> valuesPerGrid() const
    {
        const glm::dmat3 worldFromGradient = glm::transpose(glm::dmat3(glm::inverse(flowFromVoxel)));
        std::vector<float> result;
        for (const Brick& brick : model.bricks)
            for (int z = 0; z < brick.size.z; ++z)
                for (int y = 0; y < brick.size.y; ++y)
                    for (int x = 0; x < brick.size.x; ++x) {
                        std::array<vec3d, 3> gradients;
                        for (int f = 0; f < 3; ++f)
                            gradients[f] =
                                worldFromGradient * gradientPerGrid(brick, {x, y, z}, model.fields[f].values);
                        result.push_back(float(flowValue(FlowOperator::qCriterion, gradients)));
                    }
        return result;
    }

private:
    static vec3d gradientPerGrid(const Brick& brick, const vec3i& c, const std::vector<float>& values)
    {
        vec3d gradient;
        for (int axis = 0; axis < 3; ++axis) {
            vec3i lower = c, upper = c;
            lower[axis] = std::max(c[axis] - 1, 0);
            upper[axis] = std::min(c[axis] + 1, brick.size[axis] - 1);
            const auto at = [&](const vec3i& p) {
                return double(values[brick.begin + p.x + brick.size.x * (p.y + std::uint64_t(brick.size.y) * p.z)]);
            };
            gradient[axis] = (at(upper) - at(lower)) / ((upper[axis] - lower[axis]) * brick.cellWidth());
        }
        return gradient;
    }
};

Frame pictureOf(const SlantedVortex& vortex, std::vector<float> q, float value, int pixels = 48)
{
    Field field{"Q", "", std::move(q), {}, {}};
    field.range = rangeOf(field.values);
    Scene scene = sceneOf(vortex.model.bricks, field, extinctionRamp(field.range, 0.0f, 0.0f));
    scene.surfaces = {{value, {0.9f, 0.6f, 0.3f}, 1.0f}};
    return renderOne(scene, lookAt({10.0, 30.0, 52.0}, vec3d(16.0), pixels, pixels, 38.0),
                     exhibitSettings(Method::bounded, 1e-3f, Shading::headlight));
}

/// The part of the pixels that differ by more than 0.1.
double differing(const Frame& a, const Frame& b)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.color.size(); ++i) {
        const vec4f d = glm::abs(a.color[i] - b.color[i]);
        count += std::max({d.r, d.g, d.b, d.a}) > 0.1f;
    }
    return double(count) / double(a.color.size());
}

/// The largest difference of two cells at the face of a brick that the exact values do not have.
double largestJump(const std::vector<Brick>& bricks, const std::vector<float>& q, const std::vector<float>& exact)
{
    std::vector<Box3i> boxes;
    std::vector<std::size_t> brickOf;
    for (std::size_t b = 0; b < bricks.size(); ++b)
        for (const Cell& cell : oracles::cellsOfBricks({&bricks[b], 1})) {
            boxes.push_back({cell.lower, cell.lower + (1 << cell.level)});
            brickOf.push_back(b);
        }
    const BrickIndex index(boxes);
    double most = 0.0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const vec3i axis : {vec3i(1, 0, 0), vec3i(0, 1, 0), vec3i(0, 0, 1)})
            index.overlapping({boxes[i].lower, boxes[i].upper + axis}, [&](std::uint32_t n, const Box3i&) {
                if (brickOf[n] != brickOf[i])
                    most = std::max(most, std::abs((double(q[n]) - q[i]) - (double(exact[n]) - exact[i])));
            });
    return most;
}

/// Those of docs/stability.md, into the folder that the environment variable BRICKWALL_STABILITY_PICTURES names.
void writePictures(const SlantedVortex& vortex, const std::vector<float>& ours, const std::vector<float>& perGrid,
                   float value)
{
    const char* folder = std::getenv("BRICKWALL_STABILITY_PICTURES");
    if (!folder)
        return;
    const vec3f white(1.0f);
    writePng(imageOver(pictureOf(vortex, ours, value, 400), white), std::string(folder) + "/q-ours.png");
    writePng(imageOver(pictureOf(vortex, perGrid, value, 400), white), std::string(folder) + "/q-per-grid.png");
}

TEST(Stability, QAtAHighValueWhereGridsMeet)
{
    const SlantedVortex vortex;
    const std::vector<float> exact =
        oracles::modelOf(vortex.model.bricks, [&](const vec3d& p) { return vortex.exactQ(p); }).fields[0].values;
    const std::vector<float> ours = vortex.values(Executor(1)), perGrid = vortex.valuesPerGrid();
    const float highest = rangeOf(exact).hi, value = 0.65f * highest;
    writePictures(vortex, ours, perGrid, value);
    const Frame truth = pictureOf(vortex, exact, value);
    const double inOurs = differing(pictureOf(vortex, ours, value), truth);
    const double inPerGrid = differing(pictureOf(vortex, perGrid, value), truth);
    EXPECT_GT(inPerGrid, 0.08);
    EXPECT_LT(inOurs, 0.35 * inPerGrid);
    const double jumpOfOurs = largestJump(vortex.model.bricks, ours, exact) / highest;
    const double jumpPerGrid = largestJump(vortex.model.bricks, perGrid, exact) / highest;
    EXPECT_GT(jumpPerGrid, 0.1);
    EXPECT_LT(jumpOfOurs, 0.35 * jumpPerGrid);
    RecordProperty("row", fmt::format("jumps: per grid {:.2g}, ours {:.2g}; pixels: {:.2g}, {:.2g}", jumpPerGrid,
                                      jumpOfOurs, inPerGrid, inOurs));
}

} // namespace
} // namespace brickwall::test
