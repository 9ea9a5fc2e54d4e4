// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/DefaultTransferFunction.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/shade/CellSample.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace brickwall {
namespace {

/// A cube of `bricksPerSide`^3 bricks of 16^3 cells; value of the unit cube's point. Bricks off the middle are one
/// level coarser if `adaptive`, so that their cells weigh eight times as much.
Model cube(int bricksPerSide, bool adaptive, const std::function<float(const vec3d&)>& value)
{
    Model model;
    model.name = "cube";
    Field field;
    field.name = "density";
    constexpr int width = 16;
    const double side = double(bricksPerSide) * width;
    for (int z = 0; z < bricksPerSide; ++z)
        for (int y = 0; y < bricksPerSide; ++y)
            for (int x = 0; x < bricksPerSide; ++x) {
                const vec3i c = vec3i(x, y, z) * 2 + 1 - bricksPerSide;
                const int level = adaptive && std::max({std::abs(c.x), std::abs(c.y), std::abs(c.z)}) > 2 ? 1 : 0;
                const Brick brick{vec3i(x, y, z) * width, vec3i(width >> level), level, field.values.size()};
                model.bricks.push_back(brick);
                for (int i = 0; i < int(brick.cellCount()); ++i) {
                    const vec3i cell(i % brick.size.x, i / brick.size.x % brick.size.y,
                                     i / brick.size.x / brick.size.y);
                    const vec3d p = (vec3d(brick.lower) + (vec3d(cell) + 0.5) * double(brick.cellWidth())) / side;
                    field.values.push_back(value(p));
                }
            }
    field.range = rangeOf(field.values);
    model.cellCount = field.values.size();
    model.fields.push_back(std::move(field));
    return model;
}

double radius(const vec3d& p)
{
    const vec3d d = p - 0.5;
    return std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
}

/// Speed behind a body: the free stream, 1, nearly everywhere; slower in the wake, a little faster beside it.
float wake(const vec3d& p)
{
    const double r = std::hypot(p.y - 0.5, p.z - 0.5);
    const double slow = p.x > 0.3 ? std::exp(-r * r / 0.004) * std::exp(-(p.x - 0.3)) : 0.0;
    const double fast = 0.9 * std::exp(-(r - 0.15) * (r - 0.15) / 0.0005) * std::exp(-40.0 * (p.x - 0.3) * (p.x - 0.3));
    return float(1.0 - slow + fast);
}

float logNormal(const vec3d& p)
{
    const double wave = std::sin(17.0 * p.x) + std::sin(23.0 * p.y + 1.0) + std::sin(19.0 * p.z + 2.0) +
                        std::sin(31.0 * (p.x + p.y)) + std::sin(29.0 * (p.y - p.z));
    return float(1e-20 * std::exp(2.0 * wave));
}

float shells(const vec3d& p)
{
    const double r = radius(p);
    return float(0.1 + std::exp(-std::pow((r - 0.2) / 0.01, 2.0)) + 3.0 * std::exp(-std::pow((r - 0.4) / 0.01, 2.0)));
}

struct Kind
{
    const char* name;
    float (*value)(const vec3d&);
    float background;
};

constexpr Kind kinds[] = {{"wake", wake, 1.0f}, {"log-normal", logNormal, 1e-20f}, {"shells", shells, 0.1f}};

double diagonal(const Model& model)
{
    const vec3d e(voxelBounds(model.bricks).extent());
    return std::sqrt(e.x * e.x + e.y * e.y + e.z * e.z);
}

} // namespace

TEST(DefaultTransferFunction, IsNeitherEmptyNorAWallWhateverTheDataAndTheirResolution)
{
    for (const Kind& kind : kinds) {
        std::vector<double> depths;
        for (const int bricks : {2, 6})
            for (const bool adaptive : {false, true}) {
                const Model model = cube(bricks, adaptive, kind.value);
                const DefaultChoice choice = chooseTransferFunction(model, model.fields[0]);
                EXPECT_NO_THROW(checkTransferFunction(choice.tf, kind.name));
                depths.push_back(meanOpticalDepth(model, model.fields[0], choice.tf));
            }
        const auto [least, most] = std::minmax_element(depths.begin(), depths.end());
        EXPECT_LT(*most, defaultOpticalDepth + 0.1) << kind.name;
        EXPECT_GT(*least, 0.1) << kind.name;
        EXPECT_LT(*most, 1.5 * *least) << kind.name << ": much the same for every resolution";
    }
}

TEST(DefaultTransferFunction, DoesNotMakeASmallBodyInALargeDomainAWall)
{
    // A ball of 0.2 % of the volume had to make up the whole mean depth, and became opaque within a cell.
    const Model model =
        cube(8, true, [](const vec3d& p) { return float(1.0 / (1.0 + std::exp(60.0 * (radius(p) - 0.08)))); });
    const DefaultChoice choice = chooseTransferFunction(model, model.fields[0]);
    const double ballWidth = 0.16 * voxelBounds(model.bricks).extent().x;
    EXPECT_LT(extinctionAt(choice.tf, 0.95) * ballWidth, 15.0);
    EXPECT_GT(extinctionAt(choice.tf, 0.95) * ballWidth, 0.2);
}

TEST(DefaultTransferFunction, MakesTheBackgroundNearlyTransparentWhereverItIs)
{
    for (const Kind& kind : kinds) {
        const Model model = cube(6, true, kind.value);
        const DefaultChoice choice = chooseTransferFunction(model, model.fields[0]);
        EXPECT_LT(extinctionAt(choice.tf, kind.background) * diagonal(model), 0.3) << kind.name;
        const double rare =
            std::max(extinctionAt(choice.tf, choice.tf.range.lo), extinctionAt(choice.tf, choice.tf.range.hi));
        EXPECT_GT(rare * diagonal(model), 3.0) << kind.name;
    }
}

TEST(DefaultTransferFunction, WeighsCellsByVolume)
{
    // By cells most are in the middle, by volume most are outside.
    const Model model = cube(6, true, [](const vec3d& p) { return radius(p) < 0.17 ? 5.0f : 1.0f; });
    const DefaultChoice choice = chooseTransferFunction(model, model.fields[0]);
    EXPECT_LT(extinctionAt(choice.tf, 1.0), 0.1 * extinctionAt(choice.tf, 5.0));
}

TEST(DefaultTransferFunction, IsLogarithmicForDecadesAndSaysSo)
{
    const Model model = cube(4, false, logNormal);
    const DefaultChoice choice = chooseTransferFunction(model, model.fields[0]);
    EXPECT_EQ(choice.tf.scale, Scale::logarithmic);
    EXPECT_NE(choice.explanation.find("density spans "), std::string::npos) << choice.explanation;
    EXPECT_NE(choice.explanation.find("decades: logarithmic range"), std::string::npos) << choice.explanation;
    const Model linear = cube(4, false, wake);
    EXPECT_EQ(chooseTransferFunction(linear, linear.fields[0]).tf.scale, Scale::linear);
    const Model negative = cube(4, false, [](const vec3d& p) { return logNormal(p) - 1e-23f; });
    EXPECT_EQ(chooseTransferFunction(negative, negative.fields[0]).tf.scale, Scale::linear);
}

TEST(DefaultTransferFunction, TakesThePreferredRange)
{
    Model model = cube(3, false, wake);
    model.fields[0].preferredRange = {0.5f, 1.25f};
    EXPECT_EQ(chooseTransferFunction(model, model.fields[0]).tf.range, (Range{0.5f, 1.25f}));
}

TEST(DefaultTransferFunction, LeavesOutFewOutliersAndSaysSo)
{
    Model model = cube(4, false, wake);
    model.fields[0].values[12345] = 1e6f;
    model.fields[0].range = rangeOf(model.fields[0].values);
    const DefaultChoice choice = chooseTransferFunction(model, model.fields[0]);
    EXPECT_LT(choice.tf.range.hi, 3.0f);
    EXPECT_NE(choice.explanation.find("without"), std::string::npos) << choice.explanation;
}

TEST(DefaultTransferFunction, ShowsAConstantFieldAsHaze)
{
    for (const float constant : {0.0f, 3.5f, -1e20f}) {
        const Model model = cube(2, false, [&](const vec3d&) { return constant; });
        const DefaultChoice choice = chooseTransferFunction(model, model.fields[0]);
        EXPECT_NO_THROW(checkTransferFunction(choice.tf, "constant"));
        EXPECT_NEAR(meanOpticalDepth(model, model.fields[0], choice.tf), defaultOpticalDepth, 0.1) << constant;
    }
}

TEST(DefaultTransferFunction, IsTheSameEveryTime)
{
    const Model model = cube(4, true, shells);
    const DefaultChoice a = chooseTransferFunction(model, model.fields[0]);
    const DefaultChoice b = chooseTransferFunction(model, model.fields[0]);
    EXPECT_EQ(a.explanation, b.explanation);
    ASSERT_EQ(a.tf.opacity.size(), b.tf.opacity.size());
    for (std::size_t i = 0; i < a.tf.opacity.size(); ++i)
        EXPECT_EQ(a.tf.opacity[i].value, b.tf.opacity[i].value);
}

TEST(DefaultTransferFunction, OfNothingIsAnError)
{
    Model model;
    EXPECT_THROW(chooseTransferFunction(model, Field{}), Error);
}

TEST(SampleCells, StandForTheWholeVolumeAndMeetTheMean)
{
    const Model model = cube(6, true, shells);
    double volume = 0.0;
    double sum = 0.0;
    for (const SampledCell& s : sampleCells(model, model.fields[0], ~std::uint64_t(0))) {
        volume += s.volume;
        sum += s.volume * s.value;
    }
    EXPECT_DOUBLE_EQ(volume, 96.0 * 96.0 * 96.0);
    double sampledVolume = 0.0;
    double sampledSum = 0.0;
    const auto sample = sampleCells(model, model.fields[0], 20000);
    EXPECT_LT(sample.size(), 41000u);
    for (const SampledCell& s : sample) {
        sampledVolume += s.volume;
        sampledSum += s.volume * s.value;
    }
    EXPECT_NEAR(sampledVolume / volume, 1.0, 0.02);
    EXPECT_NEAR(sampledSum / sampledVolume, sum / volume, 0.02 * sum / volume);
}

} // namespace brickwall
