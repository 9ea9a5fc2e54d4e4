// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/trace/ReferenceIntegrator.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/RandomLayout.h"

#include <glm/geometric.hpp>

#include <utility>
#include <vector>

namespace brickwall {

inline constexpr std::array<double, 6> plainMetric{1, 1, 1, 0, 0, 0};

/// A model ready for the reference integrator.
struct ReferenceScene
{
    explicit ReferenceScene(Model m) : model(std::move(m))
    {
        const Executor executor(1);
        Progress silent;
        regions = buildRegions(model.bricks, executor, silent);
        field = padField(model.fields[0], model.bricks, regions, executor, silent);
    }

    ReferenceIntegrator with(const TransferFunction& tf, std::span<const IsoSurface> surfaces = {}) const
    {
        return {regions, field, tf, surfaces, plainMetric, false};
    }

    Model model;
    RegionTree regions;
    PaddedField field;
};

/// The ray from a to b, whole.
inline ReferenceRay between(const vec3d& a, const vec3d& b)
{
    const double length = glm::length(b - a);
    return {a, (b - a) / length, 0.0, length};
}

/// Rays from one side of the supports' bounds to the other.
inline ReferenceRay randomRay(const RegionTree& regions, oracles::Random& random)
{
    vec3d a(random.real(), random.real(), random.real()), b(random.real(), random.real(), random.real());
    const int axis = random.below(3);
    a[axis] = 0.0;
    b[axis] = 1.0;
    const vec3d lower = 0.5 * vec3d(regions.bounds.lower), extent = 0.5 * vec3d(regions.bounds.extent());
    return between(lower + a * extent, lower + b * extent);
}

/// Along an axis instead, in planes of faces and of cell centres.
inline ReferenceRay snapped(ReferenceRay ray, int axis)
{
    ray.org = glm::round(2.0 * ray.org) * 0.5;
    ray.dir = vec3d(0.0);
    ray.dir[axis] = 1.0;
    return ray;
}

/// From its end to its start.
inline ReferenceRay backwards(const ReferenceRay& ray)
{
    return {ray.org + ray.tFar * ray.dir, -ray.dir, 0.0, ray.tFar};
}

/// Random values on a random layout.
inline Model randomModel(std::uint64_t seed)
{
    Model model = oracles::modelOf(oracles::randomLayout({.seed = seed}), [](const vec3d&) { return 0.0; });
    model.fields[0] = oracles::randomField(model.bricks, seed + 100);
    return model;
}

/// Extinction from `points` over [lo, hi]; colour white.
inline TransferFunction extinctionOver(float lo, float hi, std::vector<OpacityPoint> points)
{
    TransferFunction tf;
    tf.range = {lo, hi};
    tf.colors = {{0.0f, vec3f(1.0f)}};
    tf.opacity = std::move(points);
    tf.kind = TransferFunction::Kind::extinction;
    return tf;
}

} // namespace brickwall
