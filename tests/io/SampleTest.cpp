// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Sample.h"

#include "brickwall/core/model/CheckModel.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace brickwall {
namespace {

Model loaded(const std::string& data, int threads = 0, std::vector<std::string> fields = {})
{
    const std::unique_ptr<DataSet> set = openSample(data);
    Progress silent;
    if (fields.empty())
        fields = {set->defaultField()};
    return set->load(fields, Executor(threads), silent);
}

std::string messageOf(const std::string& data)
{
    try {
        openSample(data);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

class SampleNamed : public testing::TestWithParam<const char*>
{
protected:
    std::string sized(const std::string& size) const { return fmt::format("sample:{}:{}", GetParam(), size); }
};

INSTANTIATE_TEST_SUITE_P(Samples, SampleNamed, testing::Values("wake", "cloud", "impact"),
                         [](const auto& info) { return info.param; });

TEST(Sample, LeavesOtherDataToOthers)
{
    EXPECT_EQ(openSample("wake"), nullptr);
    EXPECT_EQ(openSample("samples/wake.exa"), nullptr);
    EXPECT_EQ(openSample(""), nullptr);
}

TEST(Sample, SaysWhatExists)
{
    EXPECT_EQ(messageOf("sample:fog"),
              "sample:fog: expected sample:NAME[:SIZE] with a name of wake, cloud, impact, found 'fog'");
    EXPECT_NE(messageOf("sample:").find("wake, cloud, impact"), std::string::npos);
    for (const char* size : {"", "k", "500", "5000M", "-2M", "1e400", "nan", "20 M", "20G", "20MM", "20M:2"})
        EXPECT_NE(messageOf(fmt::format("sample:wake:{}", size)).find("500k, 1.5M or 100M"), std::string::npos) << size;
    try {
        loaded("sample:wake:50k", 1, {"speed", "colour"});
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "sample:wake:50k: expected a field of speed, u, v, w, pressure, found 'colour'");
    }
}

TEST_P(SampleNamed, IsTheSameOnOneAndTwoThreads)
{
    const Model one = loaded(sized("200k"), 1), two = loaded(sized("200k"), 2);
    ASSERT_EQ(one.bricks.size(), two.bricks.size());
    for (std::size_t i = 0; i < one.bricks.size(); ++i)
        ASSERT_EQ(std::memcmp(&one.bricks[i].lower, &two.bricks[i].lower, sizeof(vec3i) * 2 + sizeof(int)), 0) << i;
    EXPECT_EQ(one.fields[0].values, two.fields[0].values);
    EXPECT_EQ(one.fields[0].range, two.fields[0].range);
}

TEST_P(SampleNamed, StreamsWhatItLoads)
{
    const auto set = openDataSet(std::string("sample:") + GetParam() + ":60k");
    const auto names = set->fieldNames();
    Progress silent;
    const Model loaded = set->load(names, Executor(2), silent);
    const auto streamed = set->stream(names, Executor(2), silent);
    ASSERT_TRUE(streamed);
    ASSERT_EQ(streamed->model.bricks.size(), loaded.bricks.size());
    for (std::size_t f = 0; f < names.size(); ++f)
        for (std::size_t b = 0; b < loaded.bricks.size(); ++b) {
            const Brick& brick = loaded.bricks[b];
            ASSERT_EQ(streamed->model.bricks[b].lower, brick.lower);
            for (const std::uint64_t first : {std::uint64_t(0), brick.cellCount() / 3, brick.cellCount() - 1}) {
                std::vector<float> out(std::min<std::uint64_t>(brick.cellCount() - first, 700));
                streamed->values[f](b, first, out);
                for (std::size_t i = 0; i < out.size(); ++i)
                    ASSERT_EQ(out[i], loaded.fields[f].values[brick.begin + first + i]) << names[f] << ", brick " << b;
            }
        }
}

TEST_P(SampleNamed, HasAboutTheCellsThatWereAskedFor)
{
    for (const auto& [size, cells] : {std::pair{"50k", 50e3}, {"120k", 120e3}, {"400000", 400e3}}) {
        const Model model = loaded(sized(size));
        EXPECT_NEAR(double(model.cellCount), cells, 0.15 * cells);
        const auto perLevel = cellsPerLevel(model.bricks);
        EXPECT_EQ(std::accumulate(perLevel.begin(), perLevel.end(), std::uint64_t(0)), model.cellCount);
    }
}

TEST_P(SampleNamed, HasOnlyCellValuesOfItsFunctions)
{
    const std::string data = sized("100k");
    const ProceduralSet set = proceduralSample(data);
    std::vector<std::string> names;
    for (const ProceduralField& field : set.fields)
        names.push_back(field.name);
    EXPECT_EQ(openSample(data)->fieldNames(), names);
    const Model model = loaded(data, 0, names);
    EXPECT_NO_THROW(checkModel(model, data));
    for (std::size_t f = 0; f < names.size(); ++f) {
        ASSERT_EQ(model.fields[f].name, names[f]);
        for (std::size_t b = 0; b < model.bricks.size(); b += 3) {
            const Brick& brick = model.bricks[b];
            const vec3i cell(brick.size.x - 1, brick.size.y / 2, 0);
            const vec3d centre = vec3d(brick.lower) + (vec3d(cell) + 0.5) * double(brick.cellWidth());
            const float found =
                model.fields[f].values[brick.begin + cell.x + brick.size.x * (cell.y + brick.size.y * cell.z)];
            const double expected = set.fields[f].value(transformPoint(model.worldFromVoxel, centre));
            ASSERT_NEAR(found, expected, 1e-6 * std::abs(expected) + 1e-30) << names[f] << " in brick " << b;
        }
    }
}

TEST_P(SampleNamed, FillsItsDomainWithoutHoles)
{
    const Model model = loaded(sized("100k"));
    std::int64_t voxels = 0;
    for (const Brick& brick : model.bricks)
        voxels += volume(brick.box());
    EXPECT_EQ(voxels, volume(voxelBounds(model.bricks)));
    EXPECT_EQ(voxelBounds(model.bricks).lower, vec3i(0));
}

/// The level at a voxel, by search.
int levelAt(const Model& model, const vec3i& voxel)
{
    for (const Brick& brick : model.bricks)
        if (brick.box().contains(voxel))
            return brick.level;
    return -1;
}

TEST_P(SampleNamed, ChangesByAtMostOneLevelAcrossAFace)
{
    const Model model = loaded(sized("100k"));
    for (const Brick& brick : model.bricks)
        for (int side = 0; side < 6; ++side) {
            vec3i voxel = brick.lower + brick.box().extent() / 2;
            voxel[side / 2] = side % 2 == 0 ? brick.lower[side / 2] - 1 : brick.box().upper[side / 2];
            const int level = levelAt(model, voxel);
            if (level >= 0) {
                ASSERT_LE(std::abs(level - brick.level), 1);
            }
        }
}

TEST_P(SampleNamed, ReportsItsTimeAndCanBeCancelled)
{
    const auto start = std::chrono::steady_clock::now();
    const Model model = loaded(fmt::format("sample:{}", GetParam()));
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    RecordProperty("cells", std::to_string(model.cellCount));
    RecordProperty("seconds", std::to_string(seconds.count()));
    std::printf("%s: %.2f M cells, %zu bricks, %.2f s\n", GetParam(), double(model.cellCount) * 1e-6,
                model.bricks.size(), seconds.count());

    Progress stop;
    stop.cancel();
    const std::vector<std::string> none;
    EXPECT_THROW(openSample(sized("100k"))->load(none, Executor(), stop), Cancelled);
}

TEST(Sample, WakeHasFourLevelsAndABallAtRest)
{
    const Model model = loaded("sample:wake:500k", 0, {"speed", "u"});
    const auto perLevel = cellsPerLevel(model.bricks);
    ASSERT_EQ(perLevel.size(), 4u);
    EXPECT_GT(perLevel[0], model.cellCount / 10);
    EXPECT_EQ(model.fields[0].range.lo, 0.0f);
    EXPECT_NEAR(model.fields[0].range.hi, 1.4, 0.3);
    EXPECT_LT(model.fields[1].range.lo, -0.01f); // some air flows back behind the ball
    const ProceduralSet set = proceduralSample("sample:wake");
    EXPECT_EQ(set.fields[0].value({0.1, -0.2, 0.3}), 0.0);
    EXPECT_NEAR(set.fields[0].value({-2.0, 2.9, 2.9}), 1.0, 0.01);
    const Box3d world = worldBounds(model);
    EXPECT_NEAR(world.extent().x, 2.0 * world.extent().y, 1e-9);
}

TEST(Sample, CloudSpansEightDecadesOnFiveLevels)
{
    const Model model = loaded("sample:cloud");
    const auto perLevel = cellsPerLevel(model.bricks);
    ASSERT_EQ(perLevel.size(), 5u);
    EXPECT_GT(perLevel[0], model.cellCount / 10);
    const Range range = model.fields[0].range;
    EXPECT_GE(range.lo, 0.9e-24f);
    EXPECT_GE(std::log10(double(range.hi) / range.lo), 8.0);
    EXPECT_LT(range.hi, 1e-14f);
    // Spiky: most of the volume is within a decade of the thinnest gas, most of the mass in a few per mille of it.
    double thin = 0.0, dense = 0.0, all = 0.0, denseMass = 0.0, mass = 0.0;
    for (const Brick& brick : model.bricks)
        for (std::uint64_t i = 0; i < brick.cellCount(); ++i) {
            const double cell = std::ldexp(1.0, 3 * brick.level), v = model.fields[0].values[brick.begin + i];
            all += cell;
            mass += cell * v;
            thin += v < 1e-23 ? cell : 0.0;
            dense += v > 1e-19 ? cell : 0.0;
            denseMass += v > 1e-19 ? cell * v : 0.0;
        }
    EXPECT_GT(thin, 0.8 * all);
    EXPECT_LT(dense, 0.02 * all);
    EXPECT_GT(denseMass, 0.8 * mass);
}

/// Coarse on purpose: the last bit of a square root or of a contracted product may differ between machines.
TEST(Sample, IsTheSameAsEver)
{
    const Model model = loaded("sample:wake:100k");
    double sum = 0.0;
    for (const Brick& brick : model.bricks)
        for (std::uint64_t i = 0; i < brick.cellCount(); ++i)
            sum += std::ldexp(model.fields[0].values[brick.begin + i], 3 * brick.level);
    EXPECT_NEAR(double(model.cellCount), 104960.0, 3584.0); // a block more or less
    EXPECT_NEAR(sum / double(volume(voxelBounds(model.bricks))), 0.98535, 1e-3);
}

TEST(Sample, ImpactIsMostlyCoarseAndHasThinSkinsOnManyLevels)
{
    const Model model = loaded("sample:impact");
    const auto perLevel = cellsPerLevel(model.bricks);
    ASSERT_GE(perLevel.size(), 7u);
    EXPECT_GT(perLevel[0], model.cellCount / 5);
    const double all = double(volume(voxelBounds(model.bricks)));
    EXPECT_LT(double(perLevel[0]) / all, 0.002); // of the volume
    EXPECT_NEAR(model.fields[0].range.lo, 0.025f, 1e-6f);
    EXPECT_GT(model.fields[0].range.hi, 1.5f);
}

} // namespace
} // namespace brickwall
