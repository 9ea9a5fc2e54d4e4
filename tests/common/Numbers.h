// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <numbers>
#include <random>

namespace brickwall::test {

/// Doubles from a fixed seed that are the same with every standard library (std::uniform_real_distribution's are not).
class Numbers
{
public:
    explicit Numbers(unsigned seed) : engine_(seed) {}
    double operator()(double from, double to) { return from + (to - from) * (double(engine_()) / 4294967296.0); }
    vec3d point(double reach)
    {
        const double x = (*this)(-reach, reach), y = (*this)(-reach, reach), z = (*this)(-reach, reach);
        return {x, y, z};
    }
    mat4d rotation()
    {
        const double angle = (*this)(0.0, 2.0 * std::numbers::pi);
        return glm::rotate(mat4d(1.0), angle, glm::normalize(point(1.0) + vec3d(1e-3)));
    }

private:
    std::mt19937 engine_;
};

} // namespace brickwall::test
