// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferShapes.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/shade/TransferFunctionFile.h"
#include "brickwall/tests/common/ErrorOf.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brickwall::test {
namespace {

TransferFunction withOpacity(const std::vector<OpacityPoint>& points, const Range& range, Scale scale)
{
    TransferFunction tf;
    tf.range = range;
    tf.scale = scale;
    tf.colors = {{0.0f, vec3f(1.0f)}};
    tf.opacity = points;
    return tf;
}

double opacityAt(const TransferFunction& tf, double value)
{
    return -std::expm1(-extinctionAt(tf, value));
}

/// The formula as it is written.
double windowAt(const OpacityWindow& w, double value)
{
    const double x = (value - w.center) / w.width;
    return std::abs(x) <= 2.0 ? w.opacity * std::min(1.0, 1.6 * std::exp(-0.5 * x * x)) : 0.0;
}

void expectWindow(const OpacityWindow& window, const Range& range, Scale scale)
{
    const TransferFunction tf = withOpacity(opacityPoints(window, range, scale), range, scale);
    checkTransferFunction(tf, "window");
    double most = 0.0;
    for (int i = 0; i <= 4000; ++i) {
        const double t = i / 4000.0;
        const double value =
            scale == Scale::linear ? std::lerp(range.lo, range.hi, t) : range.lo * std::pow(range.hi / range.lo, t);
        const double x = std::abs(value - window.center) / window.width;
        if (std::abs(x - 2.0) > 1e-3) // there are steps
            most = std::max(most, std::abs(opacityAt(tf, value) - windowAt(window, value)));
    }
    EXPECT_LT(most, 2.5e-4);
}

TEST(OpacityWindow, IsTheGaussianThatIsCutOffAboveAndAtBothEnds)
{
    expectWindow({0.5, 0.1, 0.8f}, {0.0f, 1.0f}, Scale::linear);
    expectWindow({0.5, 0.1, 0.8f}, {-10.0f, 30.0f}, Scale::linear);
    expectWindow({3.0, 1.0, 0.9f}, {0.5f, 100.0f}, Scale::logarithmic);
}

TEST(OpacityWindow, ThatTheRangeCutsIsTheSameInside)
{
    expectWindow({0.1, 0.2, 0.8f}, {0.0f, 1.0f}, Scale::linear);
    expectWindow({0.85, 0.1, 0.8f}, {0.0f, 1.0f}, Scale::linear);
    expectWindow({0.5, 10.0, 0.8f}, {0.0f, 1.0f}, Scale::linear);
    expectWindow({5.0, 0.1, 0.8f}, {0.0f, 1.0f}, Scale::linear);
    const OpacityWindow window{1000.0, 0.03, 0.8f};
    expectWindow(window, rangeOf(window), Scale::linear);
}

TEST(FlatAround, HasEachPointsColourAroundItAndBeyondTheEnds)
{
    TransferFunction tf;
    tf.opacity = {{0.0f, 0.0f}};
    const std::vector<ColorPoint> points{{0.2f, {1, 0, 0}}, {0.6f, {0, 1, 0}}, {0.8f, {0, 0, 1}}};
    tf.colors = flatAround(points, 0.1f);
    checkTransferFunction(tf, "flat");
    for (const auto& [t, c] : points)
        for (const double aside : {-0.049, 0.0, 0.049})
            EXPECT_EQ(vec3f(colorAt(tf, t + aside)), c) << t;
    for (const double t : {-5.0, 0.0, 0.1})
        EXPECT_EQ(vec3f(colorAt(tf, t)), points[0].color);
    EXPECT_EQ(vec3f(colorAt(tf, 2.0)), points[2].color);
    EXPECT_NEAR(colorAt(tf, 0.4).x, 0.5, 1e-6) << "half way, linear in between";
    EXPECT_NEAR(colorAt(tf, 0.325).x, 0.75, 1e-6);
    EXPECT_EQ(flatAround(points, 0.0f).size(), 6u);
}

TEST(FlatAround, StepsHalfWayWhereNeighboursMeet)
{
    TransferFunction tf;
    tf.opacity = {{0.0f, 0.0f}};
    tf.colors = flatAround(std::vector<ColorPoint>{{0.25f, {1, 0, 0}}, {0.75f, {0, 1, 0}}}, 1.0f);
    checkTransferFunction(tf, "flat");
    EXPECT_EQ(vec3f(colorAt(tf, 0.499)), vec3f(1, 0, 0));
    EXPECT_EQ(vec3f(colorAt(tf, 0.501)), vec3f(0, 1, 0));
}

TransferFunction read(const std::string& json)
{
    const std::string path = scratchFile("shapes.json");
    writeWholeFile(path, json);
    return readTransferFunction(path, {}, {});
}

TEST(JsonFile, SaysInWhichColourAnotherFieldIs)
{
    const TransferFunction tf = read(R"({"range": [0, 1], "opacity": [[0, 0], [1, 1]], "color_field": "the \"speed\"",
        "color_range": [1, 100], "color_scale": "log", "colors": [[0, 0, 0, 0], [1, 1, 1, 1]]})");
    EXPECT_EQ(tf.colorField, (ColorField{"the \"speed\"", {1.0f, 100.0f}, Scale::logarithmic}));
    EXPECT_NEAR(colorAt(tf, 10.0).x, 0.5, 1e-6);
    EXPECT_NEAR(opacityAt(tf, 0.5), 0.5, 1e-6);
    const TransferFunction back = transferFunctionOf(toJson(tf), "again");
    EXPECT_EQ(back.colorField, tf.colorField);
    EXPECT_EQ(toJson(back), toJson(tf));
}

TEST(JsonFile, HasReadyMadeShapes)
{
    const TransferFunction tf = read(R"({"opacity_window": {"center": 0.05, "width": 0.01, "opacity": 0.5},
        "colors": [[0.25, 1, 0, 0], [0.75, 0, 1, 0]], "color_flat": 0.2})");
    EXPECT_NEAR(tf.range.lo, 0.03, 1e-8);
    EXPECT_NEAR(tf.range.hi, 0.07, 1e-8);
    for (const double v : {0.031, 0.0365, 0.05, 0.062, 0.069})
        EXPECT_NEAR(opacityAt(tf, v), windowAt({0.05, 0.01, 0.5f}, v), 2e-4) << v;
    EXPECT_EQ(vec3f(colorAt(tf, 0.0435)), vec3f(1, 0, 0)) << "t = 0.34, of the neighbourhood of 0.25";
    const TransferFunction back = transferFunctionOf(toJson(tf), "again");
    EXPECT_EQ(back.range, tf.range);
    for (const double v : {0.031, 0.0365, 0.05, 0.062, 0.069})
        EXPECT_NEAR(extinctionAt(back, v), extinctionAt(tf, v), 1e-6);
}

TEST(JsonFile, RefusesShapesThatMakeNoSense)
{
    const auto expectRefused = [](const std::string& json, const std::string& part) {
        const std::string message = errorOf([&] { read(json); });
        EXPECT_NE(message.find(part), std::string::npos) << message << " for " << json;
    };
    const std::string window = R"("opacity_window": {"center": 0.5, "width": 0.1})", jet = R"("colors": "jet")";
    expectRefused("{" + jet + R"(, "opacity_window": {"center": 0.5}})", "'width'");
    expectRefused("{" + jet + R"(, "opacity_window": {"center": 0.5, "width": 0}})", "above 0");
    expectRefused("{" + jet + R"(, "opacity_window": {"center": 0.5, "width": 1, "opacity": 2}})", "[0, 1]");
    expectRefused("{" + jet + R"(, "opacity_window": {"center": 0.5, "width": 1, "sigma": 2}})", "unknown key 'sigma'");
    expectRefused("{" + jet + R"(, "opacity_window": [0.5, 1]})", "an object");
    expectRefused("{" + jet + ", " + window + R"(, "range": [0, 1], "opacity": [[0, 0]]})", "either");
    expectRefused("{" + jet + ", " + window + R"(, "color_flat": 2})", "color_flat");
    expectRefused("{" + jet + ", " + window + R"(, "color_flat": "wide"})", "color_flat");
    expectRefused("{" + window + R"(, "colors": [[0.5, 1, 1, 1], [0.2, 0, 0, 0]], "color_flat": 0.1})", "ascend");
    expectRefused("{" + jet + ", " + window + R"(, "color_range": [0, 1]})", "belongs to 'color_field'");
    expectRefused("{" + jet + ", " + window + R"(, "color_scale": "log"})", "belongs to 'color_field'");
    expectRefused("{" + jet + ", " + window + R"(, "color_field": "a"})", "'color_range'");
    expectRefused("{" + jet + ", " + window + R"(, "color_field": 1, "color_range": [0, 1]})", "color_field");
    expectRefused("{" + jet + ", " + window + R"(, "color_field": "", "color_range": [0, 1]})", "color_field");
    expectRefused("{" + jet + ", " + window + R"(, "color_field": "a", "color_range": [1, 1]})", "lo < hi");
    expectRefused("{" + jet + ", " + window + R"(, "color_field": "a", "color_range": [0, 1], "color_scale": "log"})",
                  "above 0");
}

} // namespace
} // namespace brickwall::test
