// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// The image is a continuous function of the scene: a small change of anything changes no pixel by more than the
// tolerance allows.
#include "Exhibit.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brickwall::test {
namespace {

constexpr float tolerance = 1e-3f;

/// What is perturbed, with what it is made of.
struct Parts
{
    std::vector<Brick> bricks = threeLevels(5);
    Field field = fieldOf(bricks, waves);
    TransferFunction tf = colorful({-1.0f, 1.0f});
    std::vector<IsoSurface> surfaces;
    vec3d eye{-20.0, 40.0, 55.0};
    Shading shading = Shading::off;
};

struct Nudge
{
    const char* amount;
    float (*apply)(float);
    double mostChange; ///< of a pixel of the reference: these scenes change continuously, but for surfaces' silhouettes
};

const Nudge nudges[] = {
    {"1 ulp", [](float x) { return std::nextafter(x, std::numeric_limits<float>::infinity()); }, 1e-3},
    {"1e-7", [](float x) { return x + 1e-7f; }, 1e-3},
    {"1e-3", [](float x) { return x + 1e-3f; }, 0.3},
};

Frame rendered(const Parts& parts, Method method)
{
    Scene scene = sceneOf(parts.bricks, parts.field, parts.tf);
    scene.surfaces = parts.surfaces;
    return renderOne(scene, lookAt(parts.eye, vec3d(16.0), 16, 16, 38.0),
                     exhibitSettings(method, tolerance, parts.shading));
}

/// No pixel of bounded jumps by more than twice the tolerance plus what the reference changes there.
void expectContinuous(const Parts& parts, const Parts& nudged, double mostChange, const std::string& what)
{
    const Frame before = rendered(parts, Method::bounded), after = rendered(nudged, Method::bounded);
    const Frame exactBefore = rendered(parts, Method::reference), exactAfter = rendered(nudged, Method::reference);
    double beyond = 0.0;
    for (std::size_t i = 0; i < before.color.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            const double jump = std::abs(double(after.color[i][c]) - before.color[i][c]);
            const double exact = std::abs(double(exactAfter.color[i][c]) - exactBefore.color[i][c]);
            beyond = std::max(beyond, jump - exact);
        }
    EXPECT_LE(beyond, 2.0 * tolerance) << what;
    if (parts.surfaces.empty()) {
        EXPECT_LE(difference(exactBefore, exactAfter), mostChange) << what;
    }
}

Parts withValues(Parts parts, const Nudge& nudge)
{
    for (std::size_t i = 0; i < parts.field.values.size(); i += 3)
        parts.field.values[i] = nudge.apply(parts.field.values[i]);
    parts.field.range = rangeOf(parts.field.values);
    return parts;
}

Parts withPoints(Parts parts, const Nudge& nudge)
{
    const auto move = [&](auto& points) {
        for (auto& p : points)
            if (p.t > 0.0f && p.t < 1.0f)
                p.t = nudge.apply(p.t);
    };
    move(parts.tf.opacity);
    move(parts.tf.colors);
    return parts;
}

Parts withEye(Parts parts, const Nudge& nudge)
{
    for (int axis = 0; axis < 3; ++axis)
        parts.eye[axis] = nudge.apply(float(parts.eye[axis]));
    return parts;
}

Parts withSurfaces(Parts parts, const Nudge& nudge)
{
    for (IsoSurface& surface : parts.surfaces)
        surface.value = nudge.apply(surface.value);
    return parts;
}

void sweep(const Parts& parts)
{
    for (const Nudge& nudge : nudges) {
        const auto expect = [&](const Parts& nudged, const char* what) {
            expectContinuous(parts, nudged, nudge.mostChange, fmt::format("{} by {}", what, nudge.amount));
        };
        expect(withValues(parts, nudge), "every third value");
        expect(withPoints(parts, nudge), "the points of the transfer function");
        expect(withEye(parts, nudge), "the eye");
        if (!parts.surfaces.empty())
            expect(withSurfaces(parts, nudge), "the surfaces' values");
    }
}

TEST(StabilitySweep, Volume)
{
    sweep({});
}

TEST(StabilitySweep, LitVolume)
{
    Parts parts;
    parts.shading = Shading::headlight;
    sweep(parts);
}

TEST(StabilitySweep, ThinShell)
{
    Parts parts;
    parts.tf = spike({-1.0f, 1.0f}, 0.2f, 0.02f, 5.0f);
    sweep(parts);
}

TEST(StabilitySweep, Surfaces)
{
    Parts parts;
    parts.surfaces = {{0.1f, {0.9f, 0.6f, 0.3f}, 0.5f}, {0.4f, {0.2f, 0.4f, 0.9f}, 0.8f}};
    parts.shading = Shading::headlight;
    sweep(parts);
}

TEST(StabilitySweep, SurfacesAlone)
{
    Parts parts;
    parts.field = oracles::randomField(parts.bricks, 5);
    parts.tf.opacityScale = 0.0f;
    parts.surfaces = {{0.1f, {0.9f, 0.6f, 0.3f}, 0.5f}, {0.4f, {0.2f, 0.4f, 0.9f}, 0.8f}};
    sweep(parts);
}

} // namespace
} // namespace brickwall::test
