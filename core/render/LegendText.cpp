// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/LegendText.h"

#include <stb/stb_easy_font.h>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

/// The font has the printable characters of ASCII alone, and takes a text that it might change.
std::string printable(const std::string& text)
{
    std::string result = text;
    std::replace_if(
        result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
    return result;
}

/// As stb_easy_font writes it; four make an axis-aligned rectangle.
struct Vertex
{
    float x, y, z;
    unsigned char color[4];
};
static_assert(sizeof(Vertex) == 16);

} // namespace

int textWidth(const std::string& text)
{
    return stb_easy_font_width(printable(text).data());
}

void fillRect(Image& image, int x, int y, int width, int height, const vec3i& color, float opacity)
{
    for (int row = std::max(y, 0); row < std::min(y + height, image.height); ++row)
        for (int column = std::max(x, 0); column < std::min(x + width, image.width); ++column) {
            std::uint8_t* p = &image.rgba[image.index(column, row)];
            const float below = float(p[3]) / 255.0f * (1.0f - opacity);
            const float alpha = opacity + below;
            for (int c = 0; c < 3; ++c)
                p[c] = std::uint8_t(std::lround((float(color[c]) * opacity + float(p[c]) * below) / alpha));
            p[3] = std::uint8_t(std::lround(255.0f * alpha));
        }
}

void drawText(Image& image, int x, int y, int scale, const std::string& text, const vec3i& color)
{
    constexpr std::size_t verticesPerLetter = 4 * 24; // the library's own figure is 270 bytes on average
    std::string letters = printable(text);
    std::vector<Vertex> vertices(verticesPerLetter * (letters.size() + 1));
    const int quads = stb_easy_font_print(0.0f, 0.0f, letters.data(), nullptr, vertices.data(),
                                          int(vertices.size() * sizeof(Vertex)));
    for (int q = 0; q < quads; ++q) {
        const Vertex& lower = vertices[std::size_t(4 * q)];
        const Vertex& upper = vertices[std::size_t(4 * q + 2)];
        fillRect(image, x + int(lower.x) * scale, y + int(lower.y) * scale, int(upper.x - lower.x) * scale,
                 int(upper.y - lower.y) * scale, color, 1.0f);
    }
}

} // namespace brickwall
