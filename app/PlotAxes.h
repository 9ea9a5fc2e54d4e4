// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "SvgWriter.h"

#include <string>
#include <utility>
#include <vector>

namespace brickwall {

/// A logarithmic scale from value `lo` at coordinate `from` to `hi` at `to`; what lies outside is drawn at the ends.
struct LogAxis
{
    double lo = 1.0;
    double hi = 10.0;
    double from = 0.0;
    double to = 1.0;

    double at(double value) const;
};

struct PlotTick
{
    double value;
    std::string label; ///< empty: a small tick
};

/// Full decades around the positive ones of these values, at least one and not below `least`.
std::pair<double, double> decadesAround(const std::vector<double>& values, double least);
/// A tighter range around positive values, with some room at both ends.
std::pair<double, double> rangeAround(const std::vector<double>& values);

/// One per decade, labelled "1e-3".
std::vector<PlotTick> decadeTicks(const LogAxis& axis);
/// 1, 2, 5 per decade, labelled "0.5", "200".
std::vector<PlotTick> fineTicks(const LogAxis& axis);

/// A small text beside a point, with the room it takes.
struct PlotLabel
{
    SvgPoint at; ///< of the base line's start
    std::string text;
    std::string color;
};

/// Finds places for labels so that they overlap neither each other nor markers, the first ones having the choice. Where
/// there is no room a label is left out.
class LabelPlaces
{
public:
    LabelPlaces(const SvgPoint& corner, double width, double height, double fontSize);

    void avoid(const SvgPoint& marker, double size);
    void place(const SvgPoint& point, const std::string& text, const std::string& color);
    const std::vector<PlotLabel>& labels() const { return labels_; }

private:
    struct Room
    {
        double x0, y0, x1, y1;
    };
    bool isFree(const Room& room) const;

    Room inside_;
    double fontSize_;
    std::vector<Room> taken_;
    std::vector<PlotLabel> labels_;
};

} // namespace brickwall
