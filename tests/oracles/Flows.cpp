// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/Flows.h"

#include "brickwall/tests/oracles/Fields.h"

#include <cmath>
#include <utility>

namespace brickwall::oracles {
namespace {

/// (1 - exp(-s)) / s and its derivative.
struct Core
{
    double value, slope;

    explicit Core(double s)
    {
        if (s < 1e-3) {
            value = 1.0 - s / 2.0 + s * s / 6.0;
            slope = -0.5 + s / 3.0 - s * s / 8.0;
        } else {
            value = -std::expm1(-s) / s;
            slope = (std::exp(-s) * (1.0 + s) - 1.0) / (s * s);
        }
    }
};

} // namespace

Flow taylorGreenFlow()
{
    using std::cos, std::sin;
    return {"Taylor-Green",
            [](const vec3d& p) { return vec3d(sin(p.x) * cos(p.y) * cos(p.z), -cos(p.x) * sin(p.y) * cos(p.z), 0.0); },
            [](const vec3d& p) {
                const vec3d s(sin(p.x), sin(p.y), sin(p.z)), c(cos(p.x), cos(p.y), cos(p.z));
                return std::array{vec3d(c.x * c.y * c.z, -s.x * s.y * c.z, -s.x * c.y * s.z),
                                  vec3d(s.x * s.y * c.z, -c.x * c.y * c.z, c.x * s.y * s.z), vec3d(0.0)};
            }};
}

Flow abcFlow()
{
    using std::cos, std::sin;
    constexpr double a = 1.0, b = 0.8, c = 0.6;
    return {"ABC",
            [](const vec3d& p) {
                return vec3d(a * sin(p.z) + c * cos(p.y), b * sin(p.x) + a * cos(p.z), c * sin(p.y) + b * cos(p.x));
            },
            [](const vec3d& p) {
                return std::array{vec3d(0.0, -c * sin(p.y), a * cos(p.z)), vec3d(b * cos(p.x), 0.0, -a * sin(p.z)),
                                  vec3d(-b * sin(p.x), c * cos(p.y), 0.0)};
            }};
}

Flow burgersVortex()
{
    constexpr double inflow = 0.1, swirl = 2.0;
    return {"Burgers vortex",
            [](const vec3d& p) {
                const double g = swirl * Core(p.x * p.x + p.y * p.y).value;
                return vec3d(-inflow * p.x - g * p.y, -inflow * p.y + g * p.x, 2.0 * inflow * p.z);
            },
            [](const vec3d& p) {
                const Core core(p.x * p.x + p.y * p.y);
                const double g = swirl * core.value, d = 2.0 * swirl * core.slope;
                return std::array{vec3d(-inflow - d * p.x * p.y, -g - d * p.y * p.y, 0.0),
                                  vec3d(g + d * p.x * p.x, -inflow + d * p.x * p.y, 0.0),
                                  vec3d(0.0, 0.0, 2.0 * inflow)};
            }};
}

std::vector<Flow> flows()
{
    return {taylorGreenFlow(), abcFlow(), burgersVortex()};
}

Flow solidRotation()
{
    return {"solid rotation", [](const vec3d& p) { return vec3d(-p.y, p.x, 0.0); },
            [](const vec3d&) {
                return std::array{vec3d(0.0, -1.0, 0.0), vec3d(1.0, 0.0, 0.0), vec3d(0.0)};
            }};
}

Model modelOf(std::vector<Brick> bricks, const Flow& flow, const mat4d& worldFromVoxel)
{
    Model model;
    for (int axis = 0; axis < 3; ++axis) {
        const auto component = [&](const vec3d& voxel) {
            return flow.velocity(transformPoint(worldFromVoxel, voxel))[axis];
        };
        Model one = modelOf(bricks, component, worldFromVoxel);
        one.fields[0].name = std::string(1, "uvw"[axis]);
        one.fields.insert(one.fields.begin(), model.fields.begin(), model.fields.end());
        model = std::move(one);
    }
    return model;
}

} // namespace brickwall::oracles
