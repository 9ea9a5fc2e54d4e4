// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/ImageFiles.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/shade/Srgb.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace brickwall {
namespace {

using test::scratchFile;
using Pixel = std::array<int, 4>;

Frame frameOf(int width, int height, const vec4f& color)
{
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.color.assign(std::size_t(width) * height, color);
    frame.depth.assign(frame.color.size(), 1.0f);
    return frame;
}

Frame noise(int width, int height)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> value(-1.0f, 3.0f);
    Frame frame = frameOf(width, height, vec4f(0.0f));
    for (vec4f& c : frame.color)
        c = {value(random), value(random) * 1e-12f, value(random) * 1e12f, value(random)};
    for (float& d : frame.depth)
        d = value(random);
    return frame;
}

Pixel pixelOf(const Image& image, int x, int y)
{
    const std::uint8_t* p = &image.rgba[image.index(x, y)];
    return {p[0], p[1], p[2], p[3]};
}

} // namespace

TEST(Images, HaveTheFramesTopRowFirst)
{
    Frame frame = frameOf(3, 2, vec4f(0.0f, 0.0f, 0.0f, 1.0f));
    frame.color[frame.index(0, 1)] = {1.0f, 0.0f, 0.0f, 1.0f}; // red: upper left
    frame.color[frame.index(2, 0)] = {0.0f, 1.0f, 0.0f, 1.0f}; // green: lower right
    const std::string path = scratchFile("corners.png");
    writePng(imageOver(frame, vec3f(0.0f)), path);
    const Image image = readPng(path);
    ASSERT_EQ(image.width, 3);
    ASSERT_EQ(image.height, 2);
    EXPECT_EQ(pixelOf(image, 0, 0), (Pixel{255, 0, 0, 255}));
    EXPECT_EQ(pixelOf(image, 2, 1), (Pixel{0, 255, 0, 255}));
    EXPECT_EQ(pixelOf(image, 1, 0), (Pixel{0, 0, 0, 255}));
}

TEST(Images, ComposePremultipliedInLinearLightAndEncodeAsSrgb)
{
    // half-covered red over white: 0.5 + 0.5 * 1 and 0.5 * 1 in linear light; 0.5 is 188 in sRGB
    const Frame frame = frameOf(1, 1, {0.5f, 0.0f, 0.0f, 0.5f});
    EXPECT_EQ(pixelOf(imageOver(frame, vec3f(1.0f)), 0, 0), (Pixel{255, 188, 188, 255}));
    EXPECT_EQ(pixelOf(imageOver(frame, vec3f(0.0f)), 0, 0), (Pixel{188, 0, 0, 255}));
}

TEST(Images, ThatKeepAlphaAreNotPremultiplied)
{
    const Image image = imageOf(frameOf(1, 1, {0.25f, 0.0f, 0.25f, 0.25f}));
    EXPECT_EQ(pixelOf(image, 0, 0), (Pixel{255, 0, 255, 64}));
    EXPECT_EQ(pixelOf(imageOf(frameOf(1, 1, vec4f(0.0f))), 0, 0), (Pixel{0, 0, 0, 0}));
}

TEST(Images, ShowEveryByteOfSrgb)
{
    for (int i = 0; i <= 255; ++i) {
        const Frame frame = frameOf(1, 1, vec4f(linearFromSrgb(float(i) / 255.0f), 0.0f, 0.0f, 1.0f));
        EXPECT_EQ(pixelOf(imageOver(frame, vec3f(0.0f)), 0, 0)[0], i);
    }
}

TEST(Images, ShowNanAsMagentaAndCutOffWhatADisplayCannotShow)
{
    EXPECT_EQ(pixelOf(imageOver(frameOf(1, 1, {0.0f, NAN, 0.0f, 1.0f}), vec3f(0.0f)), 0, 0), (Pixel{255, 0, 255, 255}));
    EXPECT_EQ(pixelOf(imageOver(frameOf(1, 1, {7.0f, -1.0f, INFINITY, 1.0f}), vec3f(0.0f)), 0, 0),
              (Pixel{255, 0, 255, 255}));
}

TEST(Png, ComesBackAsWritten)
{
    Image image{37, 11, std::vector<std::uint8_t>(4 * 37 * 11)};
    for (std::size_t i = 0; i < image.rgba.size(); ++i)
        image.rgba[i] = std::uint8_t(i * 7919 % 251);
    const std::string path = scratchFile("round.png");
    writePng(image, path);
    EXPECT_EQ(readPng(path).rgba, image.rgba);
}

TEST(Png, HasAlphaOnlyIfAPixelNeedsIt)
{
    constexpr std::size_t colorType = 25; // in the IHDR chunk: 2 is RGB, 6 is RGBA
    const std::string path = scratchFile("alpha.png");
    Image image{2, 2, std::vector<std::uint8_t>(16, 255)};
    writePng(image, path);
    EXPECT_EQ(int(readWholeFile(path)[colorType]), 2);
    image.rgba[7] = 254;
    writePng(image, path);
    EXPECT_EQ(int(readWholeFile(path)[colorType]), 6);
}

TEST(Exr, ComesBackBitForBit)
{
    const Frame frame = noise(61, 17);
    const std::string path = scratchFile("round.exr");
    writeExr(frame, path);
    const Frame back = readExr(path);
    ASSERT_EQ(back.width, 61);
    ASSERT_EQ(back.height, 17);
    EXPECT_EQ(back.color, frame.color);
    EXPECT_EQ(back.depth, frame.depth);
}

TEST(ImageFiles, ThatCannotBeWrittenOrReadSayWhichAndWhy)
{
    const std::string nowhere = "/no/such/folder/file";
    const auto expectMessage = [&](auto action, const std::string& path, const std::string& part) {
        try {
            action();
            FAIL() << "accepted; expected a message with " << part;
        } catch (const Error& e) {
            EXPECT_EQ(std::string(e.what()).rfind(path, 0), 0u) << e.what();
            EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
        }
    };
    const std::string reason = "No such file or directory";
    expectMessage([&] { writePng(imageOf(noise(2, 2)), nowhere); }, nowhere, reason);
    expectMessage([&] { writeExr(noise(2, 2), nowhere); }, nowhere, reason);
    expectMessage([&] { readPng(nowhere); }, nowhere, reason);
    expectMessage([&] { readExr(nowhere); }, nowhere, reason);

    const std::string text = scratchFile("text");
    writeWholeFile(text, "no image at all");
    expectMessage([&] { readPng(text); }, text, "PNG");
    expectMessage([&] { readExr(text); }, text, "EXR");
    expectMessage([&] { writeExr(Frame{}, text); }, text, "0 x 0");
    expectMessage([&] { writePng(Image{}, text); }, text, "0 x 0");
}

TEST(ImageFiles, ThatAreCutShortAreRefused)
{
    const std::string path = scratchFile("cut");
    writeExr(noise(40, 40), path);
    const std::string exr = readWholeFile(path);
    writePng(imageOf(noise(40, 40)), path);
    const std::string png = readWholeFile(path);
    for (int part = 0; part < 8; ++part) {
        writeWholeFile(path, exr.substr(0, exr.size() * part / 8));
        EXPECT_THROW(readExr(path), Error) << part;
        writeWholeFile(path, png.substr(0, png.size() * part / 8));
        EXPECT_THROW(readPng(path), Error) << part;
    }
}

} // namespace brickwall
