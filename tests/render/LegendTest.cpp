// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Legend.h"

#include "brickwall/core/shade/ColorMaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

namespace brickwall {
namespace {

TransferFunction over(Range range, Scale scale = Scale::linear, const char* map = "Cool Warm")
{
    TransferFunction tf;
    tf.range = range;
    tf.scale = scale;
    tf.colors = colorMap(map);
    tf.opacity = {{0.0f, 0.5f}};
    return tf;
}

std::vector<std::string> labelsOf(const TransferFunction& tf, int most)
{
    std::vector<std::string> labels;
    for (const Tick& tick : ticksOf(tf, most))
        labels.push_back(tick.label);
    return labels;
}

Image plain(int width, int height, std::uint8_t grey)
{
    return {width, height, std::vector<std::uint8_t>(std::size_t(4) * width * height, grey)};
}

} // namespace

TEST(Ticks, AreRoundValuesInsideTheRange)
{
    EXPECT_EQ(labelsOf(over({0.0f, 1.0f}), 6), (std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"}));
    EXPECT_EQ(labelsOf(over({-1.3f, 1.3f}), 5), (std::vector<std::string>{"-1", "-0.5", "0", "0.5", "1"}));
    EXPECT_EQ(labelsOf(over({1e-24f, 1e-16f}, Scale::logarithmic), 5),
              (std::vector<std::string>{"1e-24", "1e-22", "1e-20", "1e-18", "1e-16"}));
    EXPECT_EQ(labelsOf(over({0.5f, 20.0f}, Scale::logarithmic), 5), (std::vector<std::string>{"5", "10", "15", "20"}));
}

TEST(Ticks, AreFewEnoughDistinctAndInOrder)
{
    const Range ranges[] = {{0, 1},           {101325.0f, 101326.0f}, {-3e7f, 1e-3f}, {1e-30f, 2e-30f},
                            {0.999f, 1.001f}, {-5.0f, -4.0f},         {1.0f, 1e6f},   {0.0f, 3e38f}};
    for (const Range& range : ranges)
        for (const int most : {2, 3, 7, 12})
            for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
                if (scale == Scale::logarithmic && !(range.lo > 0.0f))
                    continue;
                const auto ticks = ticksOf(over(range, scale), most);
                std::set<std::string> labels;
                double before = -1.0;
                for (const Tick& tick : ticks) {
                    EXPECT_GE(tick.t, 0.0);
                    EXPECT_LE(tick.t, 1.0);
                    EXPECT_GT(tick.t, before);
                    EXPECT_NEAR(std::stod(tick.label), tick.value, 1e-2 * std::abs(tick.value) + 1e-37);
                    before = tick.t;
                    labels.insert(tick.label);
                }
                EXPECT_LE(int(ticks.size()), most);
                EXPECT_GE(ticks.size(), 1u) << range.lo << ' ' << range.hi << ' ' << most;
                EXPECT_EQ(labels.size(), ticks.size()) << range.lo << ' ' << range.hi << ' ' << most;
            }
}

TEST(Legend, ShowsTheMapsColorsWithTheLargestValueOnTop)
{
    Image image = plain(400, 400, 0);
    drawLegend(image, over({0.0f, 1.0f}), "speed", "m/s");
    int firstRed = -1;
    int firstBlue = -1;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const std::uint8_t* p = &image.rgba[image.index(x, y)];
            if (firstRed < 0 && p[0] > 170 && p[1] < 40 && p[2] < 80)
                firstRed = y;
            if (firstBlue < 0 && p[0] < 80 && p[1] < 100 && p[2] > 180)
                firstBlue = y;
        }
    EXPECT_GT(firstRed, 0);
    EXPECT_GT(firstBlue, firstRed + 100);
}

TEST(Legend, HasBrightLettersOnADarkPanelWhateverIsBehind)
{
    for (const int behind : {0, 128, 255}) {
        Image image = plain(300, 300, std::uint8_t(behind));
        drawLegend(image, over({0.0f, 1.0f}), "density", "");
        int bright = 0;
        int dark = 0;
        for (int y = 150; y < 290; ++y)
            for (int x = 250; x < 290; ++x) { // the labels
                const int green = image.rgba[image.index(x, y) + 1];
                bright += green > 250;
                dark += green < 90;
            }
        EXPECT_GT(bright, 30) << behind;
        EXPECT_GT(dark, 5 * bright) << behind;
    }
}

TEST(Legend, SurvivesImagesAndTitlesOfAnySize)
{
    const std::string title(3000, 'W');
    for (const auto& [width, height] : {std::pair{1, 1}, {7, 300}, {300, 7}, {200, 200}, {4000, 300}})
        for (const std::string& name : {std::string(),
                                        std::string("gr\xc3\xb6\xc3\x9f"
                                                    "e\n"),
                                        title}) {
            Image image = plain(width, height, 255);
            drawLegend(image, over({1e-24f, 1e-16f}, Scale::logarithmic), name, "g/cm^3");
            EXPECT_EQ(image.rgba.size(), std::size_t(4) * width * height);
        }
}

TEST(Legend, MakesATransparentImageOpaqueOnlyWhereItIs)
{
    Image image{400, 400, std::vector<std::uint8_t>(4 * 400 * 400, 0)};
    drawLegend(image, over({0.0f, 1.0f}), "speed", "m/s");
    EXPECT_EQ(image.rgba[image.index(10, 10) + 3], 0);
    EXPECT_GT(image.rgba[image.index(385, 385) + 3], 150);
}

} // namespace brickwall
