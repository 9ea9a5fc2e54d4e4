// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// In the units of the picture, y downwards.
struct SvgPoint
{
    double x = 0.0;
    double y = 0.0;
};

struct SvgStroke
{
    std::string color = "#000000";
    double width = 1.0;
    std::string dashes = {}; ///< "4 3"; empty: a full line
};

struct SvgFont
{
    double size = 12.0;
    std::string color = "#222222";
    std::string anchor = "start"; ///< or middle, end
    bool bold = false;
    double degrees = 0.0; ///< clockwise about the text's point
};

enum class SvgMarker { circle, square, triangle, diamond, cross };

/// A picture of lines, markers and text as SVG 1.1, without anything but standard fonts. Text is escaped.
class SvgWriter
{
public:
    SvgWriter(double width, double height);

    void rect(const SvgPoint& corner, double width, double height, const std::string& fill, const SvgStroke& stroke);
    void line(const SvgPoint& from, const SvgPoint& to, const SvgStroke& stroke);
    void polyline(const std::vector<SvgPoint>& points, const SvgStroke& stroke);
    /// About `size` wide.
    void marker(SvgMarker shape, const SvgPoint& center, double size, const std::string& color);
    /// The text's point lies on its base line.
    void text(const SvgPoint& at, std::string_view text, const SvgFont& font);

    /// The whole file.
    std::string finished() const;

private:
    double width_, height_;
    std::string body_;
};

} // namespace brickwall
