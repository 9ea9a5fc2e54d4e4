// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/Srgb.h"

#include "brickwall/core/base/Error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brickwall {
namespace {

/// The display colour at t, as bytes.
vec3i bytesAt(const std::vector<ColorPoint>& points, float t)
{
    TransferFunction tf;
    tf.colors = points;
    const vec3d c = colorAt(tf, t);
    const auto byte = [](double l) { return int(std::lround(255.0 * double(srgbFromLinear(float(l))))); };
    return {byte(c.x), byte(c.y), byte(c.z)};
}

void expectNear(const vec3i& found, const vec3i& expected, int tolerance)
{
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(found[c], expected[c], tolerance) << "component " << c;
}

} // namespace

TEST(ColorMaps, AreValidFromEndToEnd)
{
    for (const std::string& name : colorMapNames()) {
        TransferFunction tf;
        tf.colors = colorMap(name);
        tf.opacity = {{0.0f, 1.0f}};
        EXPECT_NO_THROW(checkTransferFunction(tf, name));
        EXPECT_EQ(tf.colors.front().t, 0.0f) << name;
        EXPECT_EQ(tf.colors.back().t, 1.0f) << name;
    }
}

TEST(ColorMaps, HaveTheNamesOfExaBrickAndParaView)
{
    for (const char* name : {"Paraview Cool Warm",
                             "Rainbow",
                             "Matplotlib Plasma",
                             "Matplotlib Virdis",
                             "Samsel Linear Green",
                             "Samsel Linear YGB 1211g",
                             "Cool Warm Extended",
                             "Blackbody",
                             "Jet",
                             "Blue Gold",
                             "Ice Fire",
                             "Nic Edge",
                             "Covise",
                             "HSV",
                             "Cool to Warm",
                             "Cool to Warm (Extended)",
                             "Black-Body Radiation",
                             "Viridis (matplotlib)",
                             "Linear Green (Gr4L)",
                             "Linear YGB 1211g",
                             "erdc_iceFire_H",
                             "nic_Edge",
                             "Grayscale",
                             "inferno",
                             "MAGMA",
                             "cool_warm"})
        EXPECT_NO_THROW(colorMap(name)) << name;
    EXPECT_EQ(colorMap("Matplotlib Virdis").size(), colorMap("viridis").size());
}

TEST(ColorMaps, UnknownNameListsTheKnownOnes)
{
    for (const char* name : {"", "no such map", "cool", "warm cooltowarm"})
        EXPECT_THROW(colorMap(name), Error) << name;
    try {
        colorMap("no such map");
    } catch (const Error& e) {
        for (const std::string& known : colorMapNames())
            EXPECT_NE(std::string(e.what()).find(known), std::string::npos) << known;
    }
}

TEST(ColorMaps, MeetPublishedColors)
{
    expectNear(bytesAt(colorMap("Cool Warm"), 0.0f), {59, 76, 192}, 1);
    expectNear(bytesAt(colorMap("Cool Warm"), 0.5f), {221, 221, 221}, 1);
    expectNear(bytesAt(colorMap("Cool Warm"), 1.0f), {180, 4, 38}, 1);
    expectNear(bytesAt(colorMap("Cool Warm"), 0.25f), {141, 176, 254}, 2);
    expectNear(bytesAt(colorMap("Viridis"), 0.5f), {33, 145, 140}, 2);
    expectNear(bytesAt(colorMap("Plasma"), 0.5f), {204, 71, 120}, 2);
    expectNear(bytesAt(colorMap("Inferno"), 0.25f), {87, 16, 110}, 3); // not a stop of ours
    expectNear(bytesAt(colorMap("Magma"), 0.25f), {81, 18, 124}, 3);
    expectNear(bytesAt(colorMap("Black-Body"), 0.4f), {230, 0, 0}, 1);
    expectNear(bytesAt(colorMap("Black-Body"), 0.6f), {230, 115, 0}, 1); // halfway in display values
    expectNear(bytesAt(colorMap("Grey"), 0.3f), {77, 77, 77}, 1);
}

TEST(ColorMaps, SequentialOnesGetSteadilyBrighter)
{
    for (const char* name :
         {"Viridis", "Plasma", "Inferno", "Magma", "Black-Body", "Samsel Linear Green", "Blue Gold", "Grey"}) {
        float before = -1.0f;
        for (const ColorPoint& p : colorMap(name)) {
            const float luminance = 0.2126f * p.color.x + 0.7152f * p.color.y + 0.0722f * p.color.z;
            EXPECT_GE(luminance, before - 0.004f) << name << " at " << p.t;
            before = luminance;
        }
    }
}

TEST(Srgb, IsItsOwnInverseAndMeetsKnownValues)
{
    EXPECT_EQ(linearFromSrgb(0.0f), 0.0f);
    EXPECT_NEAR(linearFromSrgb(1.0f), 1.0f, 1e-6f);
    EXPECT_NEAR(linearFromSrgb(0.5f), 0.21404f, 1e-5f);
    for (int i = 0; i <= 255; ++i) {
        const float s = float(i) / 255.0f;
        EXPECT_NEAR(srgbFromLinear(linearFromSrgb(s)), s, 1e-6f);
    }
    EXPECT_NEAR(linearFromSrgb(0.04045f), linearFromSrgb(0.040451f), 1e-6f); // the two branches meet
}

} // namespace brickwall
