// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "PlotAxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brickwall {
namespace {

/// The least and the largest of those that a logarithmic axis can show; none: 1 and 1.
std::pair<double, double> positiveRange(const std::vector<double>& values)
{
    double lo = std::numeric_limits<double>::infinity(), hi = 0.0;
    for (const double v : values)
        if (v > 0.0 && std::isfinite(v)) {
            lo = std::min(lo, v);
            hi = std::max(hi, v);
        }
    return hi > 0.0 ? std::pair(lo, hi) : std::pair(1.0, 1.0);
}

} // namespace

double LogAxis::at(double value) const
{
    const double t = value > 0.0 ? std::log(value / lo) / std::log(hi / lo) : 0.0;
    return from + std::clamp(t, 0.0, 1.0) * (to - from);
}

std::pair<double, double> decadesAround(const std::vector<double>& values, double least)
{
    const auto [lo, hi] = positiveRange(values);
    const double first = std::floor(std::log10(std::max(lo, least)) + 1e-9);
    const double last = std::max(std::ceil(std::log10(hi) - 1e-9), first + 1.0);
    return {std::pow(10.0, first), std::pow(10.0, last)};
}

std::pair<double, double> rangeAround(const std::vector<double>& values)
{
    const auto [lo, hi] = positiveRange(values);
    const double room = std::max(1.2, std::pow(hi / lo, 0.06));
    return {lo / room, hi * room};
}

std::vector<PlotTick> decadeTicks(const LogAxis& axis)
{
    std::vector<PlotTick> ticks;
    const int first = static_cast<int>(std::ceil(std::log10(axis.lo) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(axis.hi) + 1e-9));
    for (int decade = first; decade <= last; ++decade)
        ticks.push_back({std::pow(10.0, decade), decade == 0 ? "1" : fmt::format("1e{}", decade)});
    return ticks;
}

std::vector<PlotTick> fineTicks(const LogAxis& axis)
{
    std::vector<PlotTick> ticks;
    for (int decade = static_cast<int>(std::floor(std::log10(axis.lo))); std::pow(10.0, decade) <= axis.hi; ++decade)
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double value = digit * std::pow(10.0, decade);
            if (value >= axis.lo && value <= axis.hi)
                ticks.push_back({value, fmt::format("{:g}", value)});
        }
    return ticks;
}

LabelPlaces::LabelPlaces(const SvgPoint& corner, double width, double height, double fontSize)
    : inside_{corner.x, corner.y, corner.x + width, corner.y + height}, fontSize_(fontSize)
{
}

void LabelPlaces::avoid(const SvgPoint& marker, double size)
{
    const double r = 0.5 * size;
    taken_.push_back({marker.x - r, marker.y - r, marker.x + r, marker.y + r});
}

bool LabelPlaces::isFree(const Room& room) const
{
    if (room.x0 < inside_.x0 || room.y0 < inside_.y0 || room.x1 > inside_.x1 || room.y1 > inside_.y1)
        return false;
    return std::none_of(taken_.begin(), taken_.end(), [&](const Room& t) {
        return room.x0 < t.x1 && t.x0 < room.x1 && room.y0 < t.y1 && t.y0 < room.y1;
    });
}

void LabelPlaces::place(const SvgPoint& point, const std::string& text, const std::string& color)
{
    const double width = 0.56 * fontSize_ * static_cast<double>(text.size()), height = 0.75 * fontSize_;
    constexpr double gap = 6.0; // from the point
    const double left = point.x - gap - width, right = point.x + gap, middle = point.x - 0.5 * width;
    const double above = point.y - gap, below = point.y + gap + height, level = point.y + 0.5 * height;
    for (const SvgPoint& at :
         {SvgPoint{right, above + 2}, SvgPoint{left, below - 2}, SvgPoint{right, level}, SvgPoint{left, level},
          SvgPoint{left, above + 2}, SvgPoint{right, below - 2}, SvgPoint{middle, above}, SvgPoint{middle, below}}) {
        const Room room{at.x - 1, at.y - height - 1, at.x + width + 1, at.y + 1};
        if (!isFree(room))
            continue;
        taken_.push_back(room);
        labels_.push_back({at, text, color});
        return;
    }
}

} // namespace brickwall
