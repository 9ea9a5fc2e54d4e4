// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Exhibit.h"

#include "brickwall/core/simd/Target.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace brickwall::test {
namespace {

struct Row
{
    std::string name;
    Errors errors;
};

std::vector<Row>& rows()
{
    static std::vector<Row> all;
    return all;
}

/// Writes the table when all tests are done.
class TableOfErrors : public testing::Environment
{
public:
    void TearDown() override
    {
        const char* file = std::getenv("BRICKWALL_STABILITY_TABLE");
        if (!file || rows().empty())
            return;
        std::ofstream out(file);
        out << "| exhibit | brightest | fixed | midpoint | bracket | preintegrated | bounded, 1/255 | bounded, 1e-3 | "
               "samples per pixel |\n|---|---|---|---|---|---|---|---|---|\n";
        for (const auto& [name, e] : rows())
            out << fmt::format(
                "| {} | {:.2f} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.1e} | {:.0f}, {:.0f} |\n", name,
                e.most, e.fixed, e.midpoint, e.bracket, e.preintegrated, e.bounded, e.boundedFine, e.samples,
                e.samplesOfFine);
        if (!out)
            ADD_FAILURE() << "cannot write " << file;
    }
};

const auto* const table = testing::AddGlobalTestEnvironment(new TableOfErrors);

struct Rendered
{
    std::vector<Frame> frames;
    std::vector<ViewStatistics> statistics;
};

Rendered render(const Exhibit& exhibit, const RenderSettings& settings)
{
    const Executor serial(1);
    Progress silent;
    Rendered rendered;
    rendered.frames = Renderer(exhibit.scene, serial).render(exhibit.views, settings, silent, &rendered.statistics);
    return rendered;
}

void expectFinite(const std::vector<Frame>& frames, const std::string& what)
{
    for (const Frame& frame : frames) {
        for (const vec4f& c : frame.color)
            ASSERT_TRUE(std::isfinite(c.r + c.g + c.b + c.a)) << what << ", view " << frame.view.name;
        for (const float depth : frame.depth)
            ASSERT_TRUE(depth >= 0.0f && depth <= 1.0f) << what << ", view " << frame.view.name;
    }
}

double largestDifference(const std::vector<Frame>& a, const std::vector<Frame>& b)
{
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        most = std::max(most, difference(a[i], b[i]));
    return most;
}

double brightest(const std::vector<Frame>& frames)
{
    float most = 0.0f;
    for (const Frame& frame : frames)
        for (const vec4f& c : frame.color)
            most = std::max({most, c.r, c.g, c.b, c.a});
    return most;
}

struct Kept
{
    double error = 0.0, samplesPerPixel = 0.0;
};

/// Of bounded: the tolerance kept, or more admitted and that kept.
Kept keptHere(const Exhibit& exhibit, float tolerance, const std::vector<Frame>& reference, const std::string& what)
{
    const Rendered rendered = render(exhibit, exhibitSettings(Method::bounded, tolerance, exhibit.shading));
    expectFinite(rendered.frames, what);
    double samples = 0.0, pixels = 0.0;
    std::string broken;
    for (std::size_t i = 0; i < rendered.frames.size(); ++i) {
        const ViewStatistics& s = rendered.statistics[i];
        const double kept = s.pixelsBeyond > 0 ? std::max(s.largestBound, tolerance) : tolerance;
        const double error = difference(rendered.frames[i], reference[i]);
        if (exhibit.keeps && !(error <= kept))
            broken += fmt::format("; view {} ({}): error {:.3g}, {} pixels beyond, largest bound {:.3g}", i, s.name,
                                  error, s.pixelsBeyond, s.largestBound);
        samples += double(s.counts.samples);
        pixels += double(s.rays);
    }
    EXPECT_EQ(broken, "") << what;
    return {largestDifference(rendered.frames, reference), samples / pixels};
}

/// With every instruction set of this machine, as each rounds in its own way. The largest error.
Kept kept(const Exhibit& exhibit, float tolerance, const std::vector<Frame>& reference)
{
    Kept result;
    for (const std::string& target : laneTargets()) {
        chooseLaneTarget(target);
        const std::string what = fmt::format("{}, bounded with {:.2g}, {}", exhibit.name, tolerance, target);
        const Kept here = keptHere(exhibit, tolerance, reference, what);
        result.error = std::max(result.error, here.error);
        result.samplesPerPixel = here.samplesPerPixel; // the same with all, up to rounding
    }
    chooseLaneTarget("");
    return result;
}

} // namespace

RenderSettings exhibitSettings(Method method, float dtOrTolerance, Shading shading)
{
    RenderSettings settings = settingsOf(0.5f, shading);
    settings.method = method;
    if (method == Method::bounded)
        settings.bounded.tolerance = dtOrTolerance;
    else if (method != Method::reference)
        settings.step.dt = dtOrTolerance;
    return settings;
}

TransferFunction spike(Range range, float value, float width, float peak)
{
    const float t = (value - range.lo) / (range.hi - range.lo), half = 0.5f * width / (range.hi - range.lo);
    TransferFunction tf = extinctionRamp(range, 0.0f, 0.0f);
    tf.opacity = {{0.0f, 0.0f}, {t - half, 0.0f}, {t, peak}, {t + half, 0.0f}, {1.0f, 0.0f}};
    tf.colors = {{0.0f, {1.0f, 0.5f, 0.2f}}, {1.0f, {0.2f, 0.6f, 1.0f}}};
    return tf;
}

Errors show(const Exhibit& exhibit)
{
    Errors errors;
    const auto reference = render(exhibit, exhibitSettings(Method::reference, 0.0f, exhibit.shading)).frames;
    expectFinite(reference, exhibit.name + ", reference");
    errors.most = brightest(reference);
    const auto errorOfSteps = [&](Method method) {
        const auto frames = render(exhibit, exhibitSettings(method, exhibit.dt, exhibit.shading)).frames;
        expectFinite(frames, exhibit.name + ", " + methodNames[std::size_t(method)]);
        return largestDifference(frames, reference);
    };
    errors.fixed = errorOfSteps(Method::fixed);
    errors.midpoint = errorOfSteps(Method::midpoint);
    errors.bracket = errorOfSteps(Method::bracket);
    errors.preintegrated = errorOfSteps(Method::preintegrated);
    const Kept coarse = kept(exhibit, 1.0f / 255.0f, reference), fine = kept(exhibit, 1e-3f, reference);
    errors.bounded = coarse.error;
    errors.boundedFine = fine.error;
    errors.samples = coarse.samplesPerPixel;
    errors.samplesOfFine = fine.samplesPerPixel;
    rows().push_back({exhibit.name, errors});
    return errors;
}

} // namespace brickwall::test
