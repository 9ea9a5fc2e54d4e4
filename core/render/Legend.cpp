// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Legend.h"

#include "brickwall/core/render/LegendText.h"
#include "brickwall/core/shade/Srgb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

constexpr vec3i white{255, 255, 255};
constexpr vec3i black{0, 0, 0};

double valueAt(const TransferFunction& tf, double t)
{
    const double lo = tf.range.lo;
    const double hi = tf.range.hi;
    return tf.scale == Scale::linear ? std::lerp(lo, hi, t) : lo * std::pow(hi / lo, t);
}

Tick tickAt(const TransferFunction& tf, double value, int digits)
{
    const std::string label = fmt::format("{:.{}g}", value, digits);
    return {value, std::clamp(normalized(tf, value), 0.0, 1.0), label};
}

/// 1, 2, 5, 10, 20, ...
double roundStep(int index)
{
    constexpr double steps[] = {1.0, 2.0, 5.0};
    return steps[((index % 3) + 3) % 3] * std::pow(10.0, std::floor(index / 3.0));
}

std::vector<Tick> linearTicks(const TransferFunction& tf, int most)
{
    const double lo = tf.range.lo;
    const double hi = tf.range.hi;
    const double slack = 1e-9 * (hi - lo);
    int index = 3 * int(std::floor(std::log10((hi - lo) / most))) - 3;
    const auto countOf = [&](double step) {
        return std::floor((hi + slack) / step) - std::ceil((lo - slack) / step) + 1.0;
    };
    while (countOf(roundStep(index)) > most)
        ++index;
    const double step = roundStep(index);
    const double first = std::ceil((lo - slack) / step);
    const double largest = std::max(std::abs(lo), std::abs(hi));
    const int digits = std::clamp(int(std::ceil(std::log10(largest / step))) + 1, 2, 12);
    std::vector<Tick> ticks;
    for (int i = 0; i < int(countOf(step)); ++i)
        ticks.push_back(tickAt(tf, (first + i) * step + 0.0, digits)); // + 0.0: no "-0"
    return ticks;
}

std::vector<Tick> decadeTicks(const TransferFunction& tf, int most)
{
    const double slack = 1e-6;
    const int first = int(std::ceil(std::log10(double(tf.range.lo)) - slack));
    const int last = int(std::floor(std::log10(double(tf.range.hi)) + slack));
    int step = 1;
    while ((last - first) / step + 1 > most)
        ++step;
    std::vector<Tick> ticks;
    for (int e = first; e <= last; e += step)
        ticks.push_back(tickAt(tf, std::pow(10.0, e), 3));
    return ticks;
}

std::string shortened(std::string text, int width)
{
    if (textWidth(text) <= width)
        return text;
    while (!text.empty() && textWidth(text + "..") > width)
        text.pop_back();
    return text + "..";
}

/// Where things are, in pixels; all sizes are multiples of the font's pixel.
struct Layout
{
    int pixel;               ///< of the font
    int x, y, width, height; ///< of the panel
    int barX, barY, barWidth, barHeight;
};

Layout layoutOf(const Image& image, int contentWidth, int barHeight)
{
    Layout l{};
    l.pixel = std::max(1, int(std::lround(std::min(image.width, image.height) / 360.0)));
    const int pad = 6 * l.pixel;
    l.barWidth = 12 * l.pixel;
    l.barHeight = barHeight;
    l.width = contentWidth * l.pixel + 2 * pad;
    l.height = 2 * pad + textLineHeight * l.pixel + textCapHeight * l.pixel + l.barHeight;
    l.x = image.width - l.width - pad;
    l.y = image.height - l.height - pad;
    l.barX = l.x + pad;
    l.barY = l.y + pad + textLineHeight * l.pixel + textCapHeight / 2 * l.pixel;
    return l;
}

void drawBar(Image& image, const TransferFunction& tf, const Layout& l)
{
    fillRect(image, l.barX - l.pixel, l.barY - l.pixel, l.barWidth + 2 * l.pixel, l.barHeight + 2 * l.pixel, white,
             1.0f);
    for (int row = 0; row < l.barHeight; ++row) {
        const vec3f color(colorAt(tf, valueAt(tf, 1.0 - (row + 0.5) / l.barHeight)));
        const auto byte = [](float linear) { return int(std::lround(255.0f * srgbFromLinear(linear))); };
        fillRect(image, l.barX, l.barY + row, l.barWidth, 1, {byte(color.x), byte(color.y), byte(color.z)}, 1.0f);
    }
}

} // namespace

std::vector<Tick> ticksOf(const TransferFunction& tf, int most)
{
    most = std::max(most, 2);
    if (tf.scale == Scale::logarithmic && double(tf.range.hi) / tf.range.lo >= 100.0)
        return decadeTicks(tf, most);
    return linearTicks(tf, most);
}

void drawLegend(Image& image, const TransferFunction& tf, const std::string& title, const std::string& unit)
{
    const int pixel = std::max(1, int(std::lround(std::min(image.width, image.height) / 360.0)));
    const int barHeight = image.height * 2 / 5;
    const std::vector<Tick> ticks = ticksOf(tf, std::max(3, barHeight / (2 * textLineHeight * pixel)));
    constexpr int labelOffset = 18; // the bar, its tick and a gap
    int labels = 0;
    for (const Tick& tick : ticks)
        labels = std::max(labels, labelOffset + textWidth(tick.label));
    const std::string scale = tf.scale == Scale::logarithmic ? " (log)" : "";
    const std::string full = title + (unit.empty() ? "" : " [" + unit + "]") + scale;
    const std::string line = shortened(full, std::max(labels, image.width / pixel - 24));

    const Layout l = layoutOf(image, std::max(labels, textWidth(line)), barHeight);
    fillRect(image, l.x, l.y, l.width, l.height, black, 0.7f);
    drawText(image, l.barX, l.y + 6 * l.pixel, l.pixel, line, white);
    drawBar(image, tf, l);
    for (const Tick& tick : ticks) {
        const int y = l.barY + int(std::lround((1.0 - tick.t) * l.barHeight));
        fillRect(image, l.barX + l.barWidth, y - l.pixel / 2, 4 * l.pixel, std::max(1, l.pixel), white, 1.0f);
        drawText(image, l.barX + labelOffset * l.pixel, y - textCapHeight * l.pixel / 2, l.pixel, tick.label, white);
    }
}

} // namespace brickwall
