// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/ImageFiles.h"

#include "brickwall/core/shade/Srgb.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

std::uint8_t byteOf(float v)
{
    return std::uint8_t(std::lround(255.0f * std::clamp(v, 0.0f, 1.0f)));
}

std::uint8_t displayByte(float linear)
{
    return byteOf(srgbFromLinear(std::clamp(linear, 0.0f, 1.0f)));
}

bool hasNan(const vec4f& c)
{
    return std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z) || std::isnan(c.w);
}

/// `toStraight` gives linear RGB, not premultiplied, and alpha for a pixel of the frame.
template <class ToStraight>
Image convert(const Frame& frame, ToStraight toStraight)
{
    Image image{frame.width, frame.height, std::vector<std::uint8_t>(frame.color.size() * 4)};
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            const vec4f& source = frame.color[frame.index(x, frame.height - 1 - y)];
            const vec4f c = hasNan(source) ? vec4f(1.0f, 0.0f, 1.0f, 1.0f) : toStraight(source);
            std::uint8_t* p = &image.rgba[image.index(x, y)];
            p[0] = displayByte(c.x);
            p[1] = displayByte(c.y);
            p[2] = displayByte(c.z);
            p[3] = byteOf(c.w);
        }
    return image;
}

} // namespace

Image imageOver(const Frame& frame, const vec3f& background)
{
    return convert(frame, [&](const vec4f& c) { return vec4f(vec3f(c) + (1.0f - c.w) * background, 1.0f); });
}

Image imageOf(const Frame& frame)
{
    return convert(frame, [](const vec4f& c) { return c.w > 0.0f ? vec4f(vec3f(c) / c.w, c.w) : vec4f(0.0f); });
}

} // namespace brickwall
