// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The field B = N / D (docs: basis reconstruction) and its gradient at points in lanes, all of them in one region.
/// Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_RECONSTRUCT_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_RECONSTRUCT_H
#undef BRICKWALL_CORE_TRACE_RECONSTRUCT_H
#else
#define BRICKWALL_CORE_TRACE_RECONSTRUCT_H
#endif

#include "brickwall/core/model/Regions.h"
#include "brickwall/core/simd/Lanes.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

struct PointN
{
    FloatN x, y, z; ///< voxels, relative to an origin in half voxels
};

struct SampleN
{
    FloatN value;
    PointN gradient; ///< per voxel; only set if asked for
    MaskN valid;     ///< false where no tent reaches; the rest is then meaningless
};

/// A padded brick as seen from an origin: p is at padded cell index u = p / width + shift, whose integer part is the
/// cell with its centre at or below p.
struct BrickView
{
    const float* values;
    float reciprocalWidth;
    vec3f shift;
    vec3f size; ///< of the brick itself, the largest padded index at which a cell pair starts
    int strideY;
    int strideZ;

    BrickView(const PaddedBrick& brick, const float* fieldValues, const vec3i& origin)
        : values(fieldValues + brick.begin),
          reciprocalWidth(1.0f / static_cast<float>(brick.cellWidth())),
          size(brick.size),
          strideY(brick.size.x + 2),
          strideZ((brick.size.x + 2) * (brick.size.y + 2))
    {
        for (int axis = 0; axis < 3; ++axis)
            shift[axis] = static_cast<float>(0.5 * (origin[axis] - 2.0 * brick.lower[axis]) * reciprocalWidth + 0.5);
    }
};

/// The lower cell index along an axis and the position between it and the next.
struct CellN
{
    FloatN index, f;

    HWY_INLINE CellN(FloatN p, FloatN reciprocalWidth, FloatN shift, float size)
    {
        const FloatN u = fma(p, reciprocalWidth, shift);
        index = clamp(floor(u), 0.0f, size);
        f = clamp(u - index, 0.0f, 1.0f);
    }
};

/// The 8 cells around a point; [z][y][x].
struct CornersN
{
    FloatN v[2][2][2];

    HWY_INLINE CornersN(const BrickView& brick, const CellN& x, const CellN& y, const CellN& z)
    {
        const IntN base = toInt(x.index) + toInt(y.index) * IntN(brick.strideY) + toInt(z.index) * IntN(brick.strideZ);
        for (int k = 0; k < 2; ++k) {
            const float* plane = brick.values + k * brick.strideZ;
            const QuadN q = gatherQuads(PairsAt{plane, plane + brick.strideY}, base);
            v[k][0][0] = q.a;
            v[k][0][1] = q.b;
            v[k][1][0] = q.c;
            v[k][1][1] = q.d;
        }
    }

    HWY_INLINE void subtract(FloatN x)
    {
        for (auto& plane : v)
            for (auto& row : plane)
                for (FloatN& value : row)
                    value = value - x;
    }
};

/// The trilinear interpolant of one brick's padded cells.
template <bool withGradient>
HWY_INLINE SampleN sampleBrick(const BrickView& brick, const PointN& p)
{
    const CellN x(p.x, brick.reciprocalWidth, brick.shift.x, brick.size.x);
    const CellN y(p.y, brick.reciprocalWidth, brick.shift.y, brick.size.y);
    const CellN z(p.z, brick.reciprocalWidth, brick.shift.z, brick.size.z);
    CornersN c(brick, x, y, z);
    // Gradients of fields that hardly vary would otherwise be the rounding of their values.
    const FloatN reference = withGradient ? c.v[0][0][0] : FloatN(0.0f);
    if constexpr (withGradient)
        c.subtract(reference);
    FloatN row[2][2], slope[2][2], plane[2];
    for (int k = 0; k < 2; ++k) {
        for (int j = 0; j < 2; ++j) {
            slope[k][j] = c.v[k][j][1] - c.v[k][j][0];
            row[k][j] = fma(x.f, slope[k][j], c.v[k][j][0]);
        }
        plane[k] = lerp(row[k][0], row[k][1], y.f);
    }
    SampleN s;
    s.value = lerp(plane[0], plane[1], z.f) + reference;
    s.valid = firstLanes(laneCount);
    if constexpr (withGradient) {
        const FloatN w = brick.reciprocalWidth;
        s.gradient.x = w * lerp(lerp(slope[0][0], slope[0][1], y.f), lerp(slope[1][0], slope[1][1], y.f), z.f);
        s.gradient.y = w * lerp(row[0][1] - row[0][0], row[1][1] - row[1][0], z.f);
        s.gradient.z = w * (plane[1] - plane[0]);
    }
    return s;
}

/// The weights of a cell pair along one axis, 0 for a cell that is not the brick's own, and their derivatives per
/// voxel.
struct WeightsN
{
    FloatN w[2], d[2];

    HWY_INLINE WeightsN(const CellN& cell, float size, float reciprocalWidth)
    {
        const MaskN lower = cell.index > FloatN(0.5f); // padded index 0 is a neighbour's cell, as is size + 1
        const MaskN upper = cell.index < FloatN(size - 0.5f);
        w[0] = valueOrZero(lower, FloatN(1.0f) - cell.f);
        w[1] = valueOrZero(upper, cell.f);
        d[0] = valueOrZero(lower, -reciprocalWidth);
        d[1] = valueOrZero(upper, reciprocalWidth);
    }
};

HWY_INLINE FloatN weigh(const FloatN* weights, FloatN a, FloatN b)
{
    return fma(weights[1], b, weights[0] * a);
}

/// Sums over bricks of N and D, of values less `reference`, which keeps constants exact and cancellation small.
template <bool withGradient>
struct BasisSums
{
    FloatN n, d;
    PointN gradN, gradD;

    // Not by default member initialisers: an implicit constructor would be compiled without the instruction set.
    HWY_INLINE BasisSums() : n(0.0f), d(0.0f), gradN{0.0f, 0.0f, 0.0f}, gradD{0.0f, 0.0f, 0.0f} {}

    HWY_INLINE void add(const BrickView& brick, const PointN& p, FloatN reference)
    {
        const CellN cx(p.x, brick.reciprocalWidth, brick.shift.x, brick.size.x);
        const CellN cy(p.y, brick.reciprocalWidth, brick.shift.y, brick.size.y);
        const CellN cz(p.z, brick.reciprocalWidth, brick.shift.z, brick.size.z);
        const CornersN c(brick, cx, cy, cz);
        const WeightsN x(cx, brick.size.x, brick.reciprocalWidth);
        const WeightsN y(cy, brick.size.y, brick.reciprocalWidth);
        const WeightsN z(cz, brick.size.z, brick.reciprocalWidth);
        const FloatN sx = x.w[0] + x.w[1], sy = y.w[0] + y.w[1], sz = z.w[0] + z.w[1];
        d = fma(sx * sy, sz, d);
        FloatN plane[2], planeX[2], planeY[2];
        for (int k = 0; k < 2; ++k) {
            FloatN row[2], rowX[2];
            for (int j = 0; j < 2; ++j) {
                const FloatN a = c.v[k][j][0] - reference, b = c.v[k][j][1] - reference;
                row[j] = weigh(x.w, a, b);
                rowX[j] = weigh(x.d, a, b);
            }
            plane[k] = weigh(y.w, row[0], row[1]);
            planeX[k] = weigh(y.w, rowX[0], rowX[1]);
            planeY[k] = weigh(y.d, row[0], row[1]);
        }
        n += weigh(z.w, plane[0], plane[1]);
        if constexpr (withGradient) {
            gradN.x += weigh(z.w, planeX[0], planeX[1]);
            gradN.y += weigh(z.w, planeY[0], planeY[1]);
            gradN.z += weigh(z.d, plane[0], plane[1]);
            gradD.x = fma((x.d[0] + x.d[1]) * sy, sz, gradD.x);
            gradD.y = fma((y.d[0] + y.d[1]) * sx, sz, gradD.y);
            gradD.z = fma((z.d[0] + z.d[1]) * sx, sy, gradD.z);
        }
    }

    HWY_INLINE SampleN quotient(FloatN reference) const
    {
        SampleN s;
        s.valid = d > FloatN(1e-20f);
        const FloatN reciprocal = FloatN(1.0f) / select(s.valid, d, 1.0f);
        const FloatN value = n * reciprocal;
        s.value = reference + value;
        if constexpr (withGradient) {
            s.gradient.x = fnma(value, gradD.x, gradN.x) * reciprocal;
            s.gradient.y = fnma(value, gradD.y, gradN.y) * reciprocal;
            s.gradient.z = fnma(value, gradD.z, gradN.z) * reciprocal;
        }
        return s;
    }
};

/// B in a region of several bricks: each contributes its own cells only, what lies in the padding is another's.
template <bool withGradient>
HWY_INLINE SampleN sampleBricks(const RegionTree& tree, const Region& region, const float* fieldValues,
                                const vec3i& origin, const PointN& p, float reference)
{
    BasisSums<withGradient> sums;
    for (std::uint32_t i = 0; i < region.brickCount; ++i) {
        const PaddedBrick& brick = tree.bricks[tree.brickLists[region.firstBrick + i]];
        sums.add(BrickView(brick, fieldValues, origin), p, reference);
    }
    return sums.quotient(reference);
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
