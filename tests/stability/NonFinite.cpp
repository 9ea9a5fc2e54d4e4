// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// Values that are no numbers, and numbers next to zero, from a file to the picture.
#include "Exhibit.h"

#include "brickwall/core/io/DataSet.h"
#include "brickwall/tests/common/ErrorOf.h"
#include "brickwall/tests/common/ScratchFolder.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <limits>

namespace brickwall::test {
namespace {

View outside()
{
    return lookAt({-14.0, 21.0, 29.0}, vec3d(8.0), 24, 24, 38.0);
}

/// Two levels, in an .exa file of its own; `special` is the value of the cell (5, 2, 1), and of all of one brick.
std::string fileWith(float special)
{
    std::vector<Brick> bricks = cubeOfBricks(vec3i(0), 16, 4);
    std::erase_if(bricks, [](const Brick& b) { return b.lower.x >= 8; });
    bricks.push_back({{8, 0, 0}, {4, 8, 8}, 1, 0});
    bricks = numbered(bricks);
    const Model model = oracles::modelOf(bricks, [&](const vec3d& p) {
        const bool inBrick = p.x > 4.0 && p.x < 8.0 && p.y > 8.0 && p.y < 12.0 && p.z > 8.0 && p.z < 12.0;
        return inBrick || vec3i(p) == vec3i(5, 2, 1) ? double(special) : 1.5 + waves(p);
    });
    return oracles::writeExa(scratchFolder().string(), "t", model);
}

Model loaded(const std::string& file, NonFinite nonFinite)
{
    const auto set = openDataSet(file);
    Progress silent;
    return set->load(set->fieldNames(), Executor(2), silent, nonFinite);
}

TEST(Stability, ValuesThatAreNotFiniteAreAnErrorOrEmpty)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const float special : {std::numeric_limits<float>::quiet_NaN(), infinity, -infinity}) {
        const std::string file = fileWith(special);
        const std::string error = errorOf([&] { loaded(file, NonFinite::error); });
        for (const char* part : {"t.f.scalars", "'f'", std::isnan(special) ? "nan" : "inf", "voxel (5,2,1)"})
            EXPECT_NE(error.find(part), std::string::npos) << error;

        const Model model = loaded(file, NonFinite::empty);
        EXPECT_EQ(model.cellCount, 8u * 16 * 16 + 4 * 8 * 8 - 1 - 64);
        ASSERT_EQ(model.notes.size(), 1u);
        EXPECT_NE(model.notes[0].find("65 cells without a finite value left out, in 2 bricks"), std::string::npos)
            << model.notes[0];
        EXPECT_GE(model.fields[0].range.lo, 0.5f);
        EXPECT_LE(model.fields[0].range.hi, 2.5f);
        for (const Brick& brick : model.bricks)
            EXPECT_FALSE(brick.box().contains(vec3i(5, 2, 1)) || brick.box().contains(vec3i(6, 10, 10)));
        show({fmt::format("cells of {} made empty", special),
              sceneOf(model.bricks, model.fields[0], colorful({0.5f, 2.5f})),
              {outside()}});
    }
}

TEST(Stability, NothingLeftIsAnError)
{
    const Model model = oracles::modelOf(cubeOfBricks(vec3i(0), 8, 4), [](const vec3d&) { return std::nan(""); });
    const std::string file = oracles::writeExa(scratchFolder().string(), "t", model);
    EXPECT_NE(errorOf([&] { loaded(file, NonFinite::empty); }).find("expected cells with finite values, found none"),
              std::string::npos);
}

TEST(Stability, DenormalsInAFileAreValues)
{
    const float denormal = std::numeric_limits<float>::denorm_min();
    const Model model = loaded(fileWith(denormal), NonFinite::empty);
    EXPECT_TRUE(model.notes.empty());
    EXPECT_EQ(model.fields[0].range.lo, denormal);
    show({"denormal values among others",
          sceneOf(model.bricks, model.fields[0], colorful({0.0f, 2.5f})),
          {outside()},
          Shading::headlight});
}

} // namespace
} // namespace brickwall::test
