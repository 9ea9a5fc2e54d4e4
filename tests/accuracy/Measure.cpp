// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Measure.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace brickwall::test {
namespace {

/// A scene with the views from which it is looked at.
struct Shown
{
    std::unique_ptr<const Renderer> renderer;
    std::vector<View> views;

    std::vector<Frame> render(const RenderSettings& settings, std::vector<ViewStatistics>* statistics = nullptr) const
    {
        Progress silent;
        return renderer->render(views, settings, silent, statistics);
    }
};

/// Two triangles across the middle, a third as wide as the data.
TriangleMesh quad(const vec3d& center, double diagonal)
{
    const vec3d u = glm::normalize(vec3d(1.0, 0.2, -0.6)) * (0.16 * diagonal);
    const vec3d v = glm::normalize(vec3d(-0.1, 1.0, 0.3)) * (0.16 * diagonal);
    return {{vec3f(center - u - v), vec3f(center + u - v), vec3f(center + u + v), vec3f(center - u + v)},
            {{0, 1, 2}, {0, 2, 3}}};
}

std::vector<Shown> shownOf(const Subject& s, const TransferFunction& tf, int size, const Executor& executor)
{
    const vec3d center = 0.5 * (s.bounds.lower + s.bounds.upper);
    const double d = glm::length(s.bounds.upper - s.bounds.lower);
    const auto camera = [&](const char* name, const vec3d& eye, const vec3d& at, double fov) {
        return viewOfCamera(name, center + eye * d, center + at * d, {0, 1, 0}, fov, size, size, 0.001 * d, 10.0 * d);
    };
    Scene scene{s.regions, s.field, nullptr, tf, s.worldFromVoxel, {}};
    std::vector<Shown> shown;
    shown.push_back({std::make_unique<Renderer>(scene, executor),
                     {camera("outside", {0.6, 0.45, 0.7}, {0, 0, 0}, 40.0),
                      camera("inside", {0.1, 0.05, 0.2}, {-0.2, 0.1, 0.0}, 80.0)}});
    const TriangleMesh mesh = quad(center, d);
    scene.triangles = std::make_shared<TriangleScene>(std::span(&mesh, 1));
    scene.surfaces = {{valueAt(s.standard, s.quantile(0.3)), {0.9f, 0.5f, 0.1f}, 0.3f},
                      {valueAt(s.standard, s.quantile(0.8)), {0.2f, 0.7f, 0.9f}, 0.5f}};
    shown.push_back(
        {std::make_unique<Renderer>(scene, executor), {camera("surfaces", {-0.7, 0.3, 0.65}, {0, 0, 0}, 40.0)}});
    return shown;
}

double errorOf(const vec4f& a, const vec4f& b)
{
    double most = 0.0;
    for (int c = 0; c < 4; ++c) {
        const double e = std::abs(double(a[c]) - b[c]);
        most = std::isnan(e) ? INFINITY : std::max(most, e);
    }
    return most;
}

std::string text(const vec4f& c)
{
    return fmt::format("({:.7g} {:.7g} {:.7g} {:.7g})", c.r, c.g, c.b, c.a);
}

/// Adds what one view shows. So many pixels as are `tolerated` may be over without being admitted.
void compare(const Frame& ours, const Frame& reference, float tolerance, const ViewStatistics& statistics,
             std::uint64_t tolerated, Kept& kept)
{
    double largest = 0.0, squares = 0.0;
    std::size_t worst = 0;
    std::uint64_t over = 0;
    for (std::size_t i = 0; i < ours.color.size(); ++i) {
        const double error = errorOf(ours.color[i], reference.color[i]);
        for (int c = 0; c < 4; ++c)
            squares += std::pow(double(ours.color[i][c]) - reference.color[i][c], 2) / 4.0;
        over += error > tolerance;
        kept.differing += error > 0.0;
        if (error > largest) {
            largest = error;
            worst = i;
        }
    }
    const double pixels = double(kept.pixels), added = double(ours.color.size());
    kept.rms = std::sqrt((kept.rms * kept.rms * pixels + squares) / (pixels + added));
    kept.pixels += ours.color.size();
    kept.largest = std::max(kept.largest, largest);
    kept.over += over;
    kept.admitted += statistics.pixelsBeyond;
    if (over > statistics.pixelsBeyond + tolerated)
        kept.broken += fmt::format("\n  E {:.4g}, view {}: {} pixels over, {} admitted (largest bound {:.3g}); pixel "
                                   "{},{} of {}: off by {:.3g} = {:.2f} E, is {}, reference {}",
                                   tolerance, statistics.name, over, statistics.pixelsBeyond, statistics.largestBound,
                                   worst % std::size_t(ours.width), worst / std::size_t(ours.width), ours.width,
                                   largest, largest / tolerance, text(ours.color[worst]), text(reference.color[worst]));
    if (statistics.pixelsBeyond > 0 && statistics.beyondBecause.empty())
        kept.broken += fmt::format("\n  E {:.4g}, view {}: does not say why {} pixels are beyond", tolerance,
                                   statistics.name, statistics.pixelsBeyond);
}

} // namespace

KeptOfShading measure(const Subject& subject, const TransferFunction& tf, Shading shading, int size)
{
    const Executor executor;
    RenderSettings settings;
    settings.shading = shading;
    const std::uint64_t tolerated = unadmittedPixels * std::uint64_t(size) * std::uint64_t(size) / 1024;
    KeptOfShading kept;
    for (const Shown& shown : shownOf(subject, tf, size, executor)) {
        settings.method = Method::reference;
        const std::vector<Frame> reference = shown.render(settings);
        for (const Frame& frame : reference)
            for (const vec4f& c : frame.color)
                kept.opacity = std::max(kept.opacity, double(c.a));
        settings.method = Method::bounded;
        for (std::size_t e = 0; e < tolerances.size(); ++e) {
            settings.bounded.tolerance = tolerances[e];
            std::vector<ViewStatistics> statistics;
            const std::vector<Frame> ours = shown.render(settings, &statistics);
            for (std::size_t v = 0; v < ours.size(); ++v)
                compare(ours[v], reference[v], tolerances[e], statistics[v], tolerated, kept.of[e]);
        }
    }
    return kept;
}

} // namespace brickwall::test
