// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// Where bricks, levels and holes meet, and where eyes and rays lie on their faces.
#include "Exhibit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iterator>

namespace brickwall::test {
namespace {

Scene randomIn(const std::vector<Brick>& bricks)
{
    return sceneOf(bricks, oracles::randomField(bricks, 77), colorful({-1.0f, 1.0f}));
}

View outside()
{
    return lookAt({-14.0, 21.0, 29.0}, vec3d(8.0), 24, 24, 38.0);
}

/// A cube of 16 voxels of level 0 where `isCoarse`, by octant (bit per axis), says no, and of `level` where it says
/// yes.
template <class IsCoarse>
std::vector<Brick> octants(int level, const IsCoarse& isCoarse)
{
    std::vector<Brick> bricks;
    for (int octant = 0; octant < 8; ++octant) {
        const vec3i corner = 8 * vec3i(octant & 1, octant >> 1 & 1, octant >> 2);
        const int its = isCoarse(octant) ? level : 0;
        bricks.push_back({corner, vec3i(8 >> its), its, 0});
    }
    return numbered(bricks);
}

TEST(Stability, LevelJumps)
{
    for (const int level : {1, 2}) {
        const auto jump = fmt::format("{}:1", 1 << level);
        const auto face = [](int octant) { return (octant & 1) != 0; };
        const auto edge = [](int octant) { return (octant & 3) == 3; };
        const auto corner = [](int octant) { return octant == 7; };
        for (const auto& [name, bricks] :
             {std::pair("a face", octants(level, face)), std::pair("an edge", octants(level, edge)),
              std::pair("a corner", octants(level, corner))}) {
            // In the plane, along the edge and through the corner as well.
            const std::vector<View> views = {outside(), lookAlong({-3.0, 8.0, 8.0}, 0, 1.0),
                                             lookAlong({8.0, 8.0, -3.0}, 2, 1.0), lookAlong({8.0, 19.0, 5.25}, 1, -1.0),
                                             lookAt(vec3d(-6.0), vec3d(8.0), 1, 1)};
            const Errors e = show({fmt::format("level jump {} in {}", jump, name), randomIn(bricks), views});
            EXPECT_GT(e.midpoint, 1e-3);
        }
    }
}

TEST(Stability, HoleBetweenBricks)
{
    std::vector<Brick> bricks = cubeOfBricks(vec3i(0), 16, 4);
    std::erase_if(bricks, [](const Brick& b) { return b.lower.x == 4 || b.lower == vec3i(8, 8, 8); });
    bricks = numbered(bricks);
    show({"holes between bricks",
          randomIn(bricks),
          {outside(), lookAlong({-3.0, 4.5, 6.0}, 0, 1.0), lookAlong({4.25, 4.0, -3.0}, 2, 1.0)}});
    show({"holes between bricks, constant field",
          sceneOf(bricks, fieldOf(bricks, [](const vec3d&) { return 0.5; }), extinctionRamp({0.0f, 1.0f}, 0.0f, 0.3f)),
          {outside()}});
}

TEST(Stability, BrickOfOneCell)
{
    for (const int level : {0, 3}) {
        const auto alone = numbered({{vec3i(0), vec3i(1), level, 0}});
        const double w = 1 << level;
        const Scene scene = sceneOf(alone, fieldOf(alone, [](const vec3d&) { return 0.5; }),
                                    extinctionRamp({0.0f, 1.0f}, 0.0f, float(2.0 / w)));
        const Errors e = show({fmt::format("one cell of level {}", level),
                               scene,
                               {lookAt(w * vec3d(-1.0, 1.7, 2.4), w * vec3d(0.5), 24, 24, 38.0)}});
        EXPECT_GT(e.most, 0.7);
    }
    // A cell of every level in a row, which halve towards the end.
    const auto row = numbered({{vec3i(0), vec3i(1), 3, 0},
                               {{8, 0, 0}, vec3i(1), 2, 0},
                               {{12, 0, 0}, vec3i(1), 1, 0},
                               {{14, 0, 0}, vec3i(1), 0, 0}});
    show({"bricks of one cell of four levels in a row",
          randomIn(row),
          {lookAt({-14.0, 11.0, 19.0}, {7.0, 3.0, 3.0}, 24, 24, 38.0), lookAlong({-5.0, 0.5, 0.5}, 0, 1.0)}});
}

TEST(Stability, RaysInFacesAndAlongEdges)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    std::vector<View> views;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            for (const vec3d& through :
                 {vec3d(8.0), vec3d(8.0, 8.0, 5.25), vec3d(7.5), vec3d(8.5), vec3d(7.5, 8.5, 3.0), vec3d(0.0),
                  vec3d(0.0, 0.0, 9.1), vec3d(-0.25), vec3d(16.0)}) {
                vec3d eye = through;
                eye[axis] = sign > 0 ? -4.0 : 20.0;
                views.push_back(lookAlong(eye, axis, sign));
                views.back().name = fmt::format("along {}{} through {} {} {}", sign > 0 ? '+' : '-', "xyz"[axis],
                                                through.x, through.y, through.z);
            }
    show({"rays in planes of faces and along edges", randomIn(bricks), views});
    show(
        {"the same across levels", randomIn(octants(2, [](int octant) { return octant == 3 || octant == 5; })), views});
    Scene surfaces = randomIn(bricks);
    surfaces.surfaces = {{0.1f, {0.9f, 0.6f, 0.3f}, 0.5f}, {0.11f, {0.2f, 0.4f, 0.9f}, 0.5f}};
    show({"the same with surfaces", surfaces, views});
}

TEST(Stability, EyesInside)
{
    const Scene scene = randomIn(octants(1, [](int octant) { return octant == 3 || octant == 4; }));
    const std::pair<const char*, vec3d> eyes[] = {
        {"inside", {5.3, 9.2, 6.6}},         {"at a cell's centre", vec3d(4.5)},
        {"on a face", {8.0, 5.3, 9.1}},      {"on an edge", {8.0, 8.0, 5.3}},
        {"on a corner", vec3d(8.0)},         {"on the data's face", {0.0, 5.3, 7.1}},
        {"on the data's corner", vec3d(0.0)}};
    for (const auto& [name, eye] : eyes)
        show({fmt::format("eye {}", name),
              scene,
              {lookAt(eye, {12.0, 9.0, 11.0}, 24, 24, 90.0), lookAlong(eye, 0, 1.0), lookAlong(eye, 2, -1.0)}});
}

TEST(Stability, TwoSurfacesInCorners)
{
    Scene scene = randomIn(octants(2, [](int octant) { return octant == 3 || octant == 5; }));
    scene.transferFunction.opacityScale = 0.0f;
    for (const float value : {-0.3f, 0.0f, 0.3f})
        scene.surfaces.push_back({value, {0.9f, 0.6f, 0.3f}, 0.5f});
    show({"surfaces across levels",
          scene,
          {outside(), lookAt({8.0, 8.0, 8.0}, {12.0, 9.0, 11.0}, 24, 24, 90.0)},
          Shading::headlight});
}

} // namespace
} // namespace brickwall::test
