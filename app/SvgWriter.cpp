// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "SvgWriter.h"

#include <fmt/format.h>

#include <iterator>

namespace brickwall {
namespace {

std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7f)
            result += '?'; // names may hold bytes that XML does not know
        else
            result += c;
    }
    return result;
}

std::string attributesOf(const SvgStroke& stroke)
{
    std::string text = fmt::format("stroke=\"{}\" stroke-width=\"{:g}\"", stroke.color, stroke.width);
    return stroke.dashes.empty() ? text : text + fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes);
}

std::string pointsOf(const std::vector<SvgPoint>& points)
{
    std::string text;
    for (const SvgPoint& p : points)
        fmt::format_to(std::back_inserter(text), "{}{:.2f},{:.2f}", text.empty() ? "" : " ", p.x, p.y);
    return text;
}

} // namespace

SvgWriter::SvgWriter(double width, double height) : width_(width), height_(height)
{
    rect({0, 0}, width, height, "#ffffff", {.color = "none"});
}

void SvgWriter::rect(const SvgPoint& corner, double width, double height, const std::string& fill,
                     const SvgStroke& stroke)
{
    body_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" {}/>\n",
                         corner.x, corner.y, width, height, fill, attributesOf(stroke));
}

void SvgWriter::line(const SvgPoint& from, const SvgPoint& to, const SvgStroke& stroke)
{
    polyline({from, to}, stroke);
}

void SvgWriter::polyline(const std::vector<SvgPoint>& points, const SvgStroke& stroke)
{
    body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", pointsOf(points), attributesOf(stroke));
}

void SvgWriter::marker(SvgMarker shape, const SvgPoint& c, double size, const std::string& color)
{
    const double r = 0.5 * size;
    std::vector<SvgPoint> corners;
    switch (shape) {
    case SvgMarker::circle:
        body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:g}\" fill=\"{}\"/>\n", c.x, c.y, r, color);
        return;
    case SvgMarker::cross:
        line({c.x - r, c.y - r}, {c.x + r, c.y + r}, {.color = color, .width = 2.0});
        line({c.x - r, c.y + r}, {c.x + r, c.y - r}, {.color = color, .width = 2.0});
        return;
    case SvgMarker::square:
        corners = {{c.x - r, c.y - r}, {c.x + r, c.y - r}, {c.x + r, c.y + r}, {c.x - r, c.y + r}};
        break;
    case SvgMarker::triangle:
        corners = {{c.x, c.y - 1.2 * r}, {c.x + 1.1 * r, c.y + 0.8 * r}, {c.x - 1.1 * r, c.y + 0.8 * r}};
        break;
    case SvgMarker::diamond:
        corners = {{c.x, c.y - 1.3 * r}, {c.x + 1.3 * r, c.y}, {c.x, c.y + 1.3 * r}, {c.x - 1.3 * r, c.y}};
        break;
    }
    body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", pointsOf(corners), color);
}

void SvgWriter::text(const SvgPoint& at, std::string_view text, const SvgFont& font)
{
    std::string extra;
    if (font.bold)
        extra += " font-weight=\"bold\"";
    if (font.degrees != 0.0)
        extra += fmt::format(" transform=\"rotate({:g} {:.2f} {:.2f})\"", font.degrees, at.x, at.y);
    body_ +=
        fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" fill=\"{}\" text-anchor=\"{}\"{}>{}</text>\n",
                    at.x, at.y, font.size, font.color, font.anchor, extra, escaped(text));
}

std::string SvgWriter::finished() const
{
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0:g}\" height=\"{1:g}\" "
                       "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">\n"
                       "{2}</svg>\n",
                       width_, height_, body_);
}

} // namespace brickwall
