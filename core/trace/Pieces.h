// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Pieces of rays in lanes: between consecutive planes through cell centres of a region's bricks, where N and D of the
/// basis reconstruction are cubics (docs: along a ray). One fetch gives all that is on a piece. Per instruction set,
/// see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_PIECES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_PIECES_H
#undef BRICKWALL_CORE_TRACE_PIECES_H
#else
#define BRICKWALL_CORE_TRACE_PIECES_H
#endif

#include "brickwall/core/trace/BoundedTuning.h"
#include "brickwall/core/trace/Reconstruct.h"
#include "brickwall/core/trace/RegionWalk.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// Where rays meet the planes through cell centres of one level. In u = p / width + shift, these are the integers.
class PlanesN
{
public:
    PlanesN() = default;
    HWY_INLINE PlanesN(const RayN& ray, int level, const vec3i& origin)
    {
        const float reciprocalWidth = 1.0f / static_cast<float>(1 << level);
        for (int axis = 0; axis < 3; ++axis) {
            // Only where the planes are matters, not their number: whole cells are left out of the origin.
            const int inCell = origin[axis] & ((2 << level) - 1);
            u_[axis] = fma(ray.org[axis], reciprocalWidth, 0.5f * static_cast<float>(inCell) * reciprocalWidth + 0.5f);
            perT_[axis] = ray.dir[axis] * reciprocalWidth;
            const MaskN flat = abs(perT_[axis]) < FloatN(1e-30f);
            tPer_[axis] = FloatN(1.0f) / select(flat, 1e-30f, perT_[axis]);
            step_[axis] = select(perT_[axis] < FloatN(0.0f), -1.0f, 1.0f);
        }
    }

    /// The next plane after t, by more than `least`: closer ones are where the ray is already, up to rounding.
    HWY_INLINE FloatN next(FloatN t, FloatN least) const
    {
        FloatN end = std::numeric_limits<float>::max();
        for (int axis = 0; axis < 3; ++axis) {
            // Downwards the ray is in -u what it is upwards in u.
            const FloatN u = fma(t, perT_[axis], u_[axis]) * step_[axis];
            const FloatN plane = (floor(u) + FloatN(1.0f)) * step_[axis];
            const FloatN at = (plane - u_[axis]) * tPer_[axis];
            const FloatN after = (plane + step_[axis] - u_[axis]) * tPer_[axis];
            end = min(end, select(at > t + least, at, after));
        }
        return max(end, t + least);
    }

    /// How far from t rounding may put the planes that are there, 0 where none is. Much for one that the ray meets at a
    /// small angle.
    HWY_INLINE FloatN roundingAt(FloatN t) const
    {
        FloatN most = 0.0f;
        for (int axis = 0; axis < 3; ++axis) {
            const FloatN along = t * perT_[axis], u = along + u_[axis];
            const FloatN noise = FloatN(tuning::planeNoise) * (abs(along) + abs(u_[axis]));
            const MaskN there = abs(u - floor(u + FloatN(0.5f))) <= noise;
            most = max(most, valueOrZero(there, noise * abs(tPer_[axis])));
        }
        return most;
    }

private:
    FloatN u_[3], perT_[3], tPer_[3], step_[3];
};

/// A quadratic and a cubic over s in [0, 1] by their Bernstein coefficients, which enclose them.
struct QuadraticN
{
    FloatN b[3];

    HWY_INLINE FloatN operator()(FloatN s) const { return lerp(lerp(b[0], b[1], s), lerp(b[1], b[2], s), s); }
};

struct CubicN
{
    FloatN b[4];

    HWY_INLINE FloatN least() const { return min(min(b[0], b[1]), min(b[2], b[3])); }
    HWY_INLINE FloatN largest() const { return max(max(b[0], b[1]), max(b[2], b[3])); }
};

/// What a function cannot leave.
struct EnclosureN
{
    FloatN lo, hi;
};

/// Of a cubic on [s0, s1]: blossoms of s0 and s1.
HWY_INLINE CubicN restricted(const CubicN& cubic, FloatN s0, FloatN s1)
{
    const auto blossom = [&](FloatN x, FloatN y, FloatN z) LANES_LAMBDA {
        const FloatN c0 = lerp(cubic.b[0], cubic.b[1], x), c1 = lerp(cubic.b[1], cubic.b[2], x);
        const FloatN c2 = lerp(cubic.b[2], cubic.b[3], x);
        return lerp(lerp(c0, c1, y), lerp(c1, c2, y), z);
    };
    return {{blossom(s0, s0, s0), blossom(s0, s0, s1), blossom(s0, s1, s1), blossom(s1, s1, s1)}};
}

/// A cubic and its derivative at s.
HWY_INLINE void evaluate(const CubicN& cubic, FloatN s, FloatN& value, FloatN& slope)
{
    const FloatN c0 = lerp(cubic.b[0], cubic.b[1], s), c1 = lerp(cubic.b[1], cubic.b[2], s);
    const FloatN c2 = lerp(cubic.b[2], cubic.b[3], s);
    const FloatN d0 = lerp(c0, c1, s), d1 = lerp(c1, c2, s);
    value = lerp(d0, d1, s);
    slope = FloatN(3.0f) * (d1 - d0);
}

/// Sums of multi-linear functions along a ray, by blossoms: coefficient k is the mean over all ways to take k of the
/// coordinates from the piece's end and the others from its start. Stays a convex combination of the corners.
HWY_INLINE CubicN cubicOf(const FloatN (&v)[2][2][2]) // [z][y][x], 0 at the start, 1 at the end
{
    constexpr float third = 1.0f / 3.0f;
    return {{v[0][0][0], (v[0][0][1] + v[0][1][0] + v[1][0][0]) * third, (v[0][1][1] + v[1][0][1] + v[1][1][0]) * third,
             v[1][1][1]}};
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
