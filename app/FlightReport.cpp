// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Flight.h"
#include "PlotAxes.h"
#include "SvgWriter.h"

#include "brickwall/core/base/WholeFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace brickwall {
namespace {

constexpr double left = 70, panelWidth = 800, panelHeight = 150, panelGap = 34, top = 64;
constexpr const char* heldColor = "#1f5fa8";
constexpr const char* earlierColor = "#d9730d";

void appendCsv(std::string& csv, const char* rule, const std::vector<FlightFrame>& frames)
{
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const FlightFrame& f = frames[i];
        fmt::format_to(std::back_inserter(csv), "{},{},{:.4f},{:.3f},{:.3f},{:.6g},{:.6g},{},{:.4g},{},{}\n", rule, i,
                       f.time, 1e3 * f.renderSeconds, 1e3 * f.sleepSeconds, f.levers.tolerance, f.levers.dt,
                       f.levers.imageEighths, f.admitted, f.rmsError ? fmt::format("{:.4g}", *f.rmsError) : "",
                       f.unreachable ? 1 : 0);
    }
}

using Quantity = std::function<double(const FlightFrame&)>;

/// Panels one above the other, with the flight's time to the right.
class FlightPicture
{
public:
    explicit FlightPicture(const FlownFlight& flown)
        : flown_(flown), svg_(left + panelWidth + 30, top + 4 * (panelHeight + panelGap) + 20)
    {
        svg_.rect({0, 0}, left + panelWidth + 30, top + 4 * (panelHeight + panelGap) + 20, "#ffffff",
                  {.color = "none"});
        svg_.text({left, 22},
                  fmt::format("{}, {}, {} x {}: {:g} frames per second to be held", flown.data, flown.wanted,
                              flown.options.size.width, flown.options.size.height, flown.options.fps),
                  {.size = 15, .bold = true});
        svg_.text({left, 42}, "frame time controller", {.size = 12, .color = heldColor});
        if (!flown.earlier.empty())
            svg_.text({left + 170, 42}, "rule of the earlier plugin (midpoint)", {.size = 12, .color = earlierColor});
    }

    std::string drawn()
    {
        const double target = 1e3 / flown_.options.fps;
        const auto milliseconds = [](const FlightFrame& f) { return 1e3 * (f.renderSeconds + f.sleepSeconds); };
        beginPanel("time per frame, ms (dashed: target +- 20 %)", milliseconds, milliseconds);
        for (const double part : {0.8, 1.0, 1.2})
            svg_.line({left, y_.at(part * target)}, {left + panelWidth, y_.at(part * target)},
                      {.color = part == 1.0 ? "#333333" : "#999999", .dashes = "4 3"});
        drawBoth(milliseconds, milliseconds);

        const bool steps = flown_.wanted.rfind("bounded", 0) != 0;
        const Quantity dt = [](const FlightFrame& f) { return f.levers.dt; };
        const Quantity accuracy = steps ? dt : [](const FlightFrame& f) { return f.levers.tolerance; };
        beginPanel(steps ? "dt" : "tolerance; dt of the earlier plugin", accuracy, dt);
        drawBoth(accuracy, dt);

        const Quantity scale = [](const FlightFrame& f) { return double(f.levers.imageEighths); };
        beginPanel("image scale, eighths", 1.8, 9.0);
        for (int eighths = 2; eighths <= 8; ++eighths)
            tick({double(eighths), fmt::format("{}", eighths)});
        drawBoth(scale, scale);

        const Quantity error = [](const FlightFrame& f) { return f.rmsError.value_or(0.0); };
        beginPanel("RMS error of the picture against the wanted one", error, error);
        drawBoth(error, error);
        svg_.text({left + panelWidth / 2, y_.from + 34}, "seconds", {.size = 12, .anchor = "middle"});
        return svg_.finished();
    }

private:
    void beginPanel(const std::string& title, const Quantity& held, const Quantity& earlier)
    {
        std::vector<double> values;
        for (const FlightFrame& frame : flown_.frames)
            values.push_back(held(frame));
        for (const FlightFrame& frame : flown_.earlier)
            values.push_back(earlier(frame));
        const auto [lo, hi] = rangeAround(values);
        beginPanel(title, lo, std::max(hi, 2.0 * lo));
        for (const PlotTick& fine : fineTicks(y_))
            tick(fine);
    }

    void beginPanel(const std::string& title, double lo, double hi)
    {
        const double y = top + panel_++ * (panelHeight + panelGap);
        y_ = {lo, hi, y + panelHeight, y};
        svg_.text({left, y - 5}, title, {.size = 12});
        for (double t = 0.0; t <= flown_.seconds; t += flown_.seconds > 20.0 ? 5.0 : 1.0) {
            svg_.line({x(t), y}, {x(t), y + panelHeight}, {.color = "#e8e8e8"});
            svg_.text({x(t), y + panelHeight + 14}, fmt::format("{:g}", t), {.size = 10, .anchor = "middle"});
        }
        svg_.rect({left, y}, panelWidth, panelHeight, "none", {.color = "#555555"});
    }

    void tick(const PlotTick& at)
    {
        svg_.line({left, y_.at(at.value)}, {left + panelWidth, y_.at(at.value)}, {.color = "#e8e8e8"});
        svg_.text({left - 6, y_.at(at.value) + 4}, at.label, {.size = 10, .anchor = "end"});
    }

    void drawBoth(const Quantity& held, const Quantity& earlier)
    {
        draw(flown_.earlier, earlier, earlierColor);
        draw(flown_.frames, held, heldColor);
    }

    /// Frames without a value are left out.
    void draw(const std::vector<FlightFrame>& frames, const Quantity& quantity, const char* color)
    {
        std::vector<SvgPoint> line;
        for (const FlightFrame& frame : frames)
            if (const double value = quantity(frame); value > 0.0 && std::isfinite(value))
                line.push_back({x(frame.time), y_.at(value)});
        if (line.size() > 1)
            svg_.polyline(line, {.color = color, .width = 1.3});
    }

    double x(double time) const { return left + panelWidth * std::clamp(time / flown_.seconds, 0.0, 1.0); }

    const FlownFlight& flown_;
    SvgWriter svg_;
    LogAxis y_;
    int panel_ = 0;
};

} // namespace

void writeFlightCsv(const std::string& path, const FlownFlight& flown)
{
    std::string csv = "rule,frame,time_s,render_ms,sleep_ms,tolerance,dt,image_eighths,admitted_error,rms_error,"
                      "unreachable\n";
    appendCsv(csv, "held", flown.frames);
    appendCsv(csv, "earlier", flown.earlier);
    writeWholeFile(path, csv);
}

void writeFlightSvg(const std::string& path, const FlownFlight& flown)
{
    writeWholeFile(path, FlightPicture(flown).drawn());
}

} // namespace brickwall
