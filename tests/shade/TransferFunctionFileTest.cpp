// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferFunctionFile.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/TransferIntegral.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>

namespace brickwall {
namespace {

using test::scratchFile;
std::string xfBytes(const std::vector<float>& values)
{
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

TransferFunction read(const std::string& content, const std::string& name = "tf")
{
    const std::string path = scratchFile(name);
    writeWholeFile(path, content);
    return readTransferFunction(path, colorMap("Cool Warm"), {2.0f, 3.0f});
}

void expectRefused(const std::string& content, const std::string& part)
{
    const std::string path = scratchFile("refused");
    try {
        read(content, "refused");
        FAIL() << "accepted; expected a message with " << part;
    } catch (const Error& e) {
        EXPECT_EQ(std::string(e.what()).rfind(path, 0), 0u) << e.what();
        EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
}

/// ExaBrick's meteor function: a bump at 8..10 and a plateau up to 94 (a part of it; the rest is 0 here).
std::vector<float> meteor()
{
    std::vector<float> values(128, 0.0f);
    values[8] = values[9] = 0.0972222f;
    values[10] = 0.0763889f;
    for (std::size_t i = 40; i <= 94; ++i)
        values[i] = 0.0138889f;
    return values;
}

const char* minimal = R"({"range": [0, 1], "colors": [[0, 0, 0, 0], [1, 1, 1, 1]], "opacity": [[0, 0], [1, 1]]})";

} // namespace

TEST(XfFile, PutsItsOpacitiesOnTheTableAndTakesColorsAndRangeFromOutside)
{
    const TransferFunction tf = read(xfBytes(meteor()));
    EXPECT_EQ(tf.range, (Range{2.0f, 3.0f}));
    EXPECT_EQ(tf.colors.size(), colorMap("Cool Warm").size());
    EXPECT_EQ(tf.kind, TransferFunction::Kind::opacity);
    EXPECT_EQ(tf.referenceLength, 1.0f);
    ASSERT_EQ(tf.opacity.size(), 128u);
    const TransferTable table = tabulate(tf);
    const auto opacityOf = [&](std::size_t i) { return 1.0f - std::exp(-table.entries[8 * i].w); };
    EXPECT_NEAR(opacityOf(7), 0.0f, 1e-6f);
    EXPECT_NEAR(opacityOf(9), 0.0972222f, 1e-6f);
    EXPECT_NEAR(opacityOf(10), 0.0763889f, 1e-6f);
    EXPECT_NEAR(opacityOf(94), 0.0138889f, 1e-6f);
    EXPECT_NEAR(opacityOf(95), 0.0f, 1e-6f);
}

TEST(XfFile, MayEndFullyOpaque)
{
    // As ExaBrick's DR01 function: nothing up to 37, a plateau from 99 (here to 126), 1 at the end.
    std::vector<float> values(128, 0.0f);
    values[38] = 0.0347222f;
    values[39] = 0.0208333f;
    std::fill(values.begin() + 99, values.end(), 0.673611f);
    values[127] = 1.0f;
    const TransferFunction tf = read(xfBytes(values));
    const TransferTable table = tabulate(tf);
    EXPECT_EQ(integrate(tf).largestExtinction({2.0f, 2.0f + 37.0f / 127.0f - 1e-5f}), 0.0f);
    EXPECT_NEAR(1.0f - std::exp(-table.entries[8 * 38].w), 0.0347222f, 1e-6f);
    EXPECT_NEAR(1.0f - std::exp(-table.entries[8 * 99].w), 0.673611f, 1e-6f);
    EXPECT_NEAR(table.entries.back().w, -std::log(1.0 - double(TransferFunction::opacityCap)), 1e-5);
}

TEST(XfFile, OfAnotherSizeIsRefusedWithTheSize)
{
    expectRefused(xfBytes(std::vector<float>(127, 0.0f)), "508 bytes");
    expectRefused(xfBytes(std::vector<float>(129, 0.0f)), "516 bytes");
    expectRefused("", "0 bytes");
}

TEST(XfFile, ValueThatIsNoOpacityIsRefusedWithItsByte)
{
    for (const float bad : {-0.1f, 1.5f, NAN, INFINITY}) {
        std::vector<float> values = meteor();
        values[3] = bad;
        expectRefused(xfBytes(values), "byte 12:");
    }
}

TEST(XfFile, MayBeginWithTheByteOfABrace)
{
    std::vector<float> values = meteor();
    const unsigned bits = 0x3e00007bu; // 0.125, its lowest byte '{'
    std::memcpy(&values[0], &bits, sizeof bits);
    EXPECT_EQ(read(xfBytes(values)).opacity[0].value, values[0]);
}

TEST(JsonFile, GivesRangeScaleColorsAndOpacity)
{
    const TransferFunction tf = read(R"(
        {"range": [1e-24, 1e-16], "scale": "log", "reference_length": 4, "opacity_scale": 0.5,
         "colors": [[0, 0, 0.5, 1], [1, 1, 0, 0]], "opacity": [[0, 0], [0.5, 0.25], [1, 1]]})");
    EXPECT_EQ(tf.range, (Range{1e-24f, 1e-16f}));
    EXPECT_EQ(tf.scale, Scale::logarithmic);
    EXPECT_EQ(tf.referenceLength, 4.0f);
    EXPECT_EQ(tf.opacityScale, 0.5f);
    EXPECT_NEAR(tf.colors[0].color.y, 0.2140f, 1e-4f); // sRGB 0.5 in linear
    EXPECT_EQ(tf.opacity[1].t, 0.5f);
    EXPECT_EQ(tf.opacity[1].value, 0.25f);
}

TEST(JsonFile, MayNameAColorMapAndGiveExtinction)
{
    const TransferFunction tf = read(R"({"range": [0, 2], "colors": "viridis", "extinction": [[0, 0], [1, 7]]})");
    EXPECT_EQ(tf.colors.size(), colorMap("viridis").size());
    EXPECT_EQ(tf.kind, TransferFunction::Kind::extinction);
    EXPECT_DOUBLE_EQ(extinctionAt(tf, 1.0), 3.5);
}

TEST(JsonFile, ComesBackAsWritten)
{
    for (const auto kind : {TransferFunction::Kind::opacity, TransferFunction::Kind::extinction}) {
        TransferFunction tf;
        tf.range = {1.17e-20f, 3.3333333e-7f};
        tf.scale = Scale::logarithmic;
        tf.colors = colorMap("Nic Edge");
        tf.kind = kind;
        tf.opacity = {{0.0f, 0.1f}, {0.33333334f, 1e-7f}, {0.33333334f, 0.9f}, {1.0f, 0.0f}};
        tf.referenceLength = kind == TransferFunction::Kind::opacity ? 0.7f : 1.0f;
        tf.opacityScale = 1.3f;
        const std::string path = scratchFile("round");
        writeTransferFunction(tf, path);
        const TransferFunction back = readTransferFunction(path, {}, {});
        EXPECT_EQ(back.range, tf.range);
        EXPECT_EQ(back.scale, tf.scale);
        EXPECT_EQ(back.kind, tf.kind);
        EXPECT_EQ(back.referenceLength, tf.referenceLength);
        EXPECT_EQ(back.opacityScale, tf.opacityScale);
        ASSERT_EQ(back.opacity.size(), tf.opacity.size());
        for (std::size_t i = 0; i < tf.opacity.size(); ++i) {
            EXPECT_EQ(back.opacity[i].t, tf.opacity[i].t);
            EXPECT_EQ(back.opacity[i].value, tf.opacity[i].value);
        }
        ASSERT_EQ(back.colors.size(), tf.colors.size());
        for (std::size_t i = 0; i < tf.colors.size(); ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(back.colors[i].color[c], tf.colors[i].color[c], 1e-6f);
    }
}

TEST(JsonFile, IsRefusedWithThePlace)
{
    EXPECT_NO_THROW(read(minimal));
    expectRefused("{\n\"range\": [0, 1],\n\"colors\" [[0,0,0,0]]\n}", ":3: ");
    expectRefused("{\"range\": [0, 1e999]}", "number overflow");
    expectRefused("{", ":1: ");
    expectRefused(R"({"range": [0, 1], "colours": "jet", "opacity": [[0, 0]]})", "unknown key 'colours'");
    expectRefused(R"({"range": [0, 1], "range": [0, 2], "colors": "jet", "opacity": [[0, 0]]})",
                  "'range' is given twice");
    expectRefused(R"({"colors": "jet", "opacity": [[0, 0]]})", "'range'");
    expectRefused(R"({"range": [0, "x"], "colors": "jet", "opacity": [[0, 0]]})", "range: ");
    expectRefused(R"({"range": [0, 1], "colors": "jet"})", "either 'opacity' or 'extinction'");
    expectRefused(R"({"range": [0, 1], "colors": "jet", "opacity": [[0, 0]], "extinction": [[0, 0]]})", "either");
    expectRefused(R"({"range": [0, 1], "colors": [[0, 0, 0]], "opacity": [[0, 0]]})", "colors[0]");
    expectRefused(R"({"range": [0, 1], "colors": [[0, 0, 0, 255]], "opacity": [[0, 0]]})", "colors[0]");
    expectRefused(R"({"range": [0, 1], "colors": "jet", "opacity": [[0, 0], [1]]})", "opacity[1]");
    expectRefused(R"({"range": [0, 1], "colors": "jet", "opacity": [[0, 2]]})", "opacity point 0");
    expectRefused(R"({"range": [0, 1], "scale": "log", "colors": "jet", "opacity": [[0, 0]]})", "above 0");
    expectRefused(R"({"range": [0, 1], "scale": "cubic", "colors": "jet", "opacity": [[0, 0]]})", "scale: ");
    expectRefused(R"({"range": [1, 1], "colors": "jet", "opacity": [[0, 0]]})", "lo < hi");
    expectRefused(R"({"range": [0, 1e300], "colors": "jet", "opacity": [[0, 0]]})", "lo < hi");
    expectRefused(R"({"range": [0, 1], "colors": "jet", "extinction": [[0, 0]], "reference_length": 2})", "belongs");
}

TEST(JsonFile, WithAnUnknownColorMapNamesTheFile)
{
    expectRefused(R"({"range": [0, 1], "colors": "no such map", "opacity": [[0, 0]]})", "Viridis");
}

} // namespace brickwall
