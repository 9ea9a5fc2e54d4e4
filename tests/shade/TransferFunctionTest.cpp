// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferFunction.h"

#include "brickwall/core/base/Error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brickwall {
namespace {

TransferFunction ramp(Range range, float a0, float a1)
{
    TransferFunction tf;
    tf.range = range;
    tf.colors = {{0.0f, {0.0f, 0.2f, 1.0f}}, {1.0f, {1.0f, 0.6f, 0.0f}}};
    tf.opacity = {{0.0f, a0}, {1.0f, a1}};
    return tf;
}

void expectRefused(const TransferFunction& tf, const std::string& part)
{
    try {
        checkTransferFunction(tf, "here");
        FAIL() << "accepted; expected a message with " << part;
    } catch (const Error& e) {
        EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
        EXPECT_EQ(std::string(e.what()).rfind("here: ", 0), 0u) << e.what();
    }
}

} // namespace

TEST(TransferFunction, OpacityOfOneReferenceLengthComesOut)
{
    for (const float length : {0.5f, 1.0f, 7.0f}) {
        TransferFunction tf = ramp({2.0f, 4.0f}, 0.0f, 0.8f);
        tf.referenceLength = length;
        for (const double v : {2.0, 2.5, 3.0, 3.9, 4.0}) {
            const double a = 0.8 * (v - 2.0) / 2.0;
            EXPECT_NEAR(1.0 - std::exp(-extinctionAt(tf, v) * length), a, 1e-7) << v;
        }
    }
}

TEST(TransferFunction, ScaleMultipliesOpacityBeforeTheCapAndExtinctionWithoutOne)
{
    TransferFunction tf = ramp({0.0f, 1.0f}, 0.5f, 0.5f);
    tf.opacityScale = 1.5f;
    EXPECT_NEAR(extinctionAt(tf, 0.3), -std::log(0.25), 1e-6);
    tf.opacityScale = 100.0f;
    EXPECT_NEAR(extinctionAt(tf, 0.3), -std::log(1.0 - double(TransferFunction::opacityCap)), 1e-9);
    tf.kind = TransferFunction::Kind::extinction;
    EXPECT_DOUBLE_EQ(extinctionAt(tf, 0.3), 50.0);
}

TEST(TransferFunction, EndsBelongToTheRangeAndBeyondIsTransparent)
{
    TransferFunction tf = ramp({0.1f, 0.7f}, 0.5f, 0.5f);
    for (const Scale scale : {Scale::linear, Scale::logarithmic}) {
        tf.scale = scale;
        EXPECT_EQ(normalized(tf, tf.range.lo), 0.0);
        EXPECT_EQ(normalized(tf, tf.range.hi), 1.0);
        EXPECT_GT(extinctionAt(tf, tf.range.lo), 0.0);
        EXPECT_GT(extinctionAt(tf, tf.range.hi), 0.0);
        EXPECT_EQ(extinctionAt(tf, std::nextafter(tf.range.lo, 0.0f)), 0.0);
        EXPECT_EQ(extinctionAt(tf, std::nextafter(tf.range.hi, 1.0f)), 0.0);
    }
}

TEST(TransferFunction, LogarithmicScaleIsEvenInDecades)
{
    TransferFunction tf = ramp({1e-24f, 1e-16f}, 0.0f, 1.0f);
    tf.scale = Scale::logarithmic;
    for (int decade = 0; decade <= 8; ++decade)
        EXPECT_NEAR(normalized(tf, std::pow(10.0, decade - 24)), decade / 8.0, 1e-7);
    EXPECT_LT(normalized(tf, 0.0), 0.0);
    EXPECT_LT(normalized(tf, -1.0), 0.0);
    EXPECT_EQ(extinctionAt(tf, -1.0), 0.0);
}

TEST(TransferFunction, ColorsAreLinearBetweenPointsAndFlatBeyond)
{
    const TransferFunction tf = ramp({0.0f, 2.0f}, 0.0f, 1.0f);
    EXPECT_NEAR(colorAt(tf, 0.5).x, 0.25, 1e-7);
    EXPECT_NEAR(colorAt(tf, 0.5).y, 0.3, 1e-7);
    EXPECT_EQ(vec3f(colorAt(tf, -9.0)), tf.colors.front().color);
    EXPECT_EQ(vec3f(colorAt(tf, 9.0)), tf.colors.back().color);
}

TEST(TransferFunction, PointsAtEqualTMakeAStep)
{
    TransferFunction tf = ramp({0.0f, 1.0f}, 0.0f, 0.0f);
    tf.kind = TransferFunction::Kind::extinction;
    tf.opacity = {{0.25f, 1.0f}, {0.5f, 1.0f}, {0.5f, 3.0f}, {0.75f, 3.0f}};
    EXPECT_EQ(extinctionAt(tf, 0.0), 1.0);
    EXPECT_EQ(extinctionAt(tf, 0.4999), 1.0);
    EXPECT_EQ(extinctionAt(tf, 0.5), 3.0);
    EXPECT_EQ(extinctionAt(tf, 1.0), 3.0);
}

TEST(TransferTable, HasTheKnotsOfAnXfOnItsEntries)
{
    TransferFunction tf = ramp({0.0f, 1.0f}, 0.0f, 0.0f);
    tf.opacity.clear();
    for (int i = 0; i < 128; ++i)
        tf.opacity.push_back({float(i) / 127.0f, float((i * 37) % 101) / 101.0f});
    const TransferTable table = tabulate(tf);
    ASSERT_EQ(table.entries.size(), 1017u);
    for (std::size_t i = 0; i < 128; ++i)
        EXPECT_NEAR(1.0f - std::exp(-table.entries[8 * i].w), tf.opacity[i].value, 1e-5f);
}

TEST(TransferTable, OfARampIsTheRamp)
{
    TransferFunction tf = ramp({-1.0f, 1.0f}, 0.25f, 2.25f);
    tf.kind = TransferFunction::Kind::extinction;
    const TransferTable table = tabulate(tf, 5);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_FLOAT_EQ(table.entries[i].w, 0.25f + 0.5f * float(i));
        EXPECT_FLOAT_EQ(table.entries[i].x, 0.25f * float(i));
    }
}

TEST(CheckTransferFunction, NamesWhatIsWrong)
{
    const TransferFunction good = ramp({1.0f, 2.0f}, 0.0f, 1.0f);
    EXPECT_NO_THROW(checkTransferFunction(good, "here"));
    const auto with = [&](auto change) {
        TransferFunction tf = good;
        change(tf);
        return tf;
    };
    expectRefused(with([](auto& tf) { tf.range = {2.0f, 2.0f}; }), "lo < hi");
    expectRefused(with([](auto& tf) { tf.range = {NAN, 2.0f}; }), "lo < hi");
    expectRefused(with([](auto& tf) { tf.scale = Scale::logarithmic, tf.range.lo = 0.0f; }), "above 0");
    expectRefused(with([](auto& tf) { tf.colors.clear(); }), "at least one colour");
    expectRefused(with([](auto& tf) { tf.colors[1].t = 1.5f; }), "colour point 1");
    expectRefused(with([](auto& tf) { tf.colors[0].color.y = NAN; }), "colour point 0");
    expectRefused(with([](auto& tf) { tf.opacity.clear(); }), "at least one opacity");
    expectRefused(with([](auto& tf) { tf.opacity[0].t = 1.0f, tf.opacity[1].t = 0.5f; }), "opacity point 1");
    expectRefused(with([](auto& tf) { tf.opacity[1].value = 1.1f; }), "opacity point 1");
    expectRefused(with([](auto& tf) { tf.opacity[0].value = -0.1f; }), "opacity point 0");
    expectRefused(with([](auto& tf) { tf.referenceLength = 0.0f; }), "reference length");
    expectRefused(with([](auto& tf) { tf.opacityScale = INFINITY; }), "opacity scale");
    EXPECT_THROW(tabulate(with([](auto& tf) { tf.colors.clear(); })), Error);
    EXPECT_THROW(tabulate(good, 1), Error);
}

} // namespace brickwall
