// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Pieces of rays (Pieces.h) in regions of several bricks. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_SEVERAL_BRICKS_PIECES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_SEVERAL_BRICKS_PIECES_H
#undef BRICKWALL_CORE_TRACE_SEVERAL_BRICKS_PIECES_H
#else
#define BRICKWALL_CORE_TRACE_SEVERAL_BRICKS_PIECES_H
#endif

#include "brickwall/core/trace/Pieces.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// B on pieces in a region of several bricks: N / D, each a cubic; pieces end at the planes of all levels. N is of
/// values less a reference, which keeps constants exact and cancellation small.
class SeveralBricksPieces
{
public:
    HWY_INLINE SeveralBricksPieces(const RegionTree& tree, const Region& region, const float* fieldValues,
                                   const vec3i& origin, const RayN& ray)
        : tree_(tree), region_(region), values_(fieldValues), origin_(origin), ray_(ray)
    {
        std::uint32_t levels = 0;
        for (const std::uint32_t brick : bricks())
            levels |= 1u << tree.bricks[brick].level;
        for (int level = region.finestLevel; level <= region.coarsestLevel; ++level)
            if (levels >> level & 1)
                planes_[levelCount_++] = PlanesN(ray, level, origin);
    }

    int fetches() const { return region_.brickCount; }

    HWY_INLINE FloatN end(FloatN t, FloatN least) const
    {
        FloatN end = planes_[0].next(t, least);
        for (int i = 1; i < levelCount_; ++i)
            end = min(end, planes_[i].next(t, least));
        return end;
    }

    HWY_INLINE FloatN roundingAt(FloatN t) const
    {
        FloatN most = planes_[0].roundingAt(t);
        for (int i = 1; i < levelCount_; ++i)
            most = max(most, planes_[i].roundingAt(t));
        return most;
    }

    HWY_INLINE void load(FloatN t0, FloatN t1)
    {
        for (int i = 0; i < 4; ++i)
            n_.b[i] = d_.b[i] = 0.0f;
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < 3; ++i)
                gradN_[axis].b[i] = gradD_[axis].b[i] = 0.0f;
        bool first = true;
        for (const std::uint32_t brick : bricks()) {
            add(BrickView(tree_.bricks[brick], values_, origin_), t0, t1, first);
            first = false;
        }
    }

    /// What D cannot fall below on the piece.
    HWY_INLINE FloatN leastWeight() const { return d_.least(); }

    HWY_INLINE FloatN least() const { return enclosure(n_, d_).lo; }
    HWY_INLINE FloatN largest() const { return enclosure(n_, d_).hi; }

    /// Of B on [s0, s1].
    HWY_INLINE EnclosureN enclosure(FloatN s0, FloatN s1) const
    {
        return enclosure(restricted(n_, s0, s1), restricted(d_, s0, s1));
    }

    HWY_INLINE void at(FloatN s, FloatN& value, FloatN& slope) const
    {
        FloatN n, dn, d, dd;
        evaluate(n_, s, n, dn);
        evaluate(d_, s, d, dd);
        const FloatN reciprocal = FloatN(1.0f) / select(hasWeight(d), d, 1.0f);
        const FloatN quotient = n * reciprocal;
        value = reference_ + quotient;
        slope = fnma(quotient, dd, dn) * reciprocal;
    }

    HWY_INLINE void loadGradient() {}

    HWY_INLINE PointN gradientAt(FloatN s) const
    {
        FloatN n, dn, d, dd;
        evaluate(n_, s, n, dn);
        evaluate(d_, s, d, dd);
        const FloatN reciprocal = FloatN(1.0f) / select(hasWeight(d), d, 1.0f);
        const FloatN quotient = n * reciprocal;
        return {fnma(quotient, gradD_[0](s), gradN_[0](s)) * reciprocal,
                fnma(quotient, gradD_[1](s), gradN_[1](s)) * reciprocal,
                fnma(quotient, gradD_[2](s), gradN_[2](s)) * reciprocal};
    }

private:
    static constexpr int mostLevels = 25; // maxLevel + 1

    std::span<const std::uint32_t> bricks() const
    {
        return std::span(tree_.brickLists).subspan(region_.firstBrick, region_.brickCount);
    }

    HWY_INLINE static MaskN hasWeight(FloatN d) { return d > FloatN(1e-20f); }

    /// n_i / d_i are convex combinations of the values, and enclose B as the coefficients of a cubic would.
    HWY_INLINE EnclosureN enclosure(const CubicN& n, const CubicN& d) const
    {
        constexpr float most = std::numeric_limits<float>::max();
        EnclosureN e{most, -most};
        for (int i = 0; i < 4; ++i) {
            const MaskN counts = hasWeight(d.b[i]);
            const FloatN value = n.b[i] / select(counts, d.b[i], 1.0f);
            e.lo = min(e.lo, select(counts, value, most));
            e.hi = max(e.hi, select(counts, value, -most));
        }
        return {e.lo + reference_, e.hi + reference_};
    }

    /// The weights of the brick's own cells at the piece's two ends, their sums, and their derivatives per voxel.
    struct Axis
    {
        CellN cell;
        FloatN w[2][2], sum[2], d[2]; ///< w[end][cell]

        HWY_INLINE Axis(const BrickView& brick, int axis, FloatN org, FloatN dir, FloatN t0, FloatN t1)
            : cell(fma(FloatN(0.5f) * (t0 + t1), dir, org), brick.reciprocalWidth, brick.shift[axis], brick.size[axis])
        {
            const float size = brick.size[axis];
            const MaskN lower = cell.index > FloatN(0.5f), upper = cell.index < FloatN(size - 0.5f);
            for (int end = 0; end < 2; ++end) {
                const FloatN u = fma(fma(end == 0 ? t0 : t1, dir, org), brick.reciprocalWidth, brick.shift[axis]);
                const FloatN f = clamp(u - cell.index, 0.0f, 1.0f);
                w[end][0] = valueOrZero(lower, FloatN(1.0f) - f);
                w[end][1] = valueOrZero(upper, f);
                sum[end] = w[end][0] + w[end][1];
            }
            d[0] = valueOrZero(lower, -brick.reciprocalWidth);
            d[1] = valueOrZero(upper, brick.reciprocalWidth);
        }
    };

    /// Values count relative to one of the first brick's.
    HWY_INLINE void add(const BrickView& brick, FloatN t0, FloatN t1, bool first)
    {
        const Axis x(brick, 0, ray_.org[0], ray_.dir[0], t0, t1), y(brick, 1, ray_.org[1], ray_.dir[1], t0, t1),
            z(brick, 2, ray_.org[2], ray_.dir[2], t0, t1);
        const CornersN c(brick, x.cell, y.cell, z.cell);
        if (first)
            reference_ = c.v[0][0][0];
        FloatN row[2][2][2], rowX[2][2], plane[2][2][2], planeX[2][2], planeY[2][2]; // [z cell][y cell or end][x end]
        for (int k = 0; k < 2; ++k) {
            for (int j = 0; j < 2; ++j) {
                const FloatN a = c.v[k][j][0] - reference_, b = c.v[k][j][1] - reference_;
                row[k][j][0] = weigh(x.w[0], a, b);
                row[k][j][1] = weigh(x.w[1], a, b);
                rowX[k][j] = weigh(x.d, a, b);
            }
            for (int i = 0; i < 2; ++i) {
                plane[k][0][i] = weigh(y.w[0], row[k][0][i], row[k][1][i]);
                plane[k][1][i] = weigh(y.w[1], row[k][0][i], row[k][1][i]);
                planeX[k][i] = weigh(y.w[i], rowX[k][0], rowX[k][1]);
                planeY[k][i] = weigh(y.d, row[k][0][i], row[k][1][i]);
            }
        }
        FloatN v[2][2][2], weight[2][2][2];
        for (int k = 0; k < 2; ++k)
            for (int j = 0; j < 2; ++j)
                for (int i = 0; i < 2; ++i) {
                    v[k][j][i] = weigh(z.w[k], plane[0][j][i], plane[1][j][i]);
                    weight[k][j][i] = x.sum[i] * y.sum[j] * z.sum[k];
                }
        accumulate(n_, cubicOf(v));
        accumulate(d_, cubicOf(weight));

        const FloatN dx = x.d[0] + x.d[1], dy = y.d[0] + y.d[1], dz = z.d[0] + z.d[1];
        addBilinear(gradN_[0], weigh(z.w[0], planeX[0][0], planeX[1][0]), weigh(z.w[0], planeX[0][1], planeX[1][1]),
                    weigh(z.w[1], planeX[0][0], planeX[1][0]), weigh(z.w[1], planeX[0][1], planeX[1][1]));
        addBilinear(gradN_[1], weigh(z.w[0], planeY[0][0], planeY[1][0]), weigh(z.w[0], planeY[0][1], planeY[1][1]),
                    weigh(z.w[1], planeY[0][0], planeY[1][0]), weigh(z.w[1], planeY[0][1], planeY[1][1]));
        addBilinear(gradN_[2], weigh(z.d, plane[0][0][0], plane[1][0][0]), weigh(z.d, plane[0][0][1], plane[1][0][1]),
                    weigh(z.d, plane[0][1][0], plane[1][1][0]), weigh(z.d, plane[0][1][1], plane[1][1][1]));
        addBilinear(gradD_[0], dx * y.sum[0] * z.sum[0], dx * y.sum[1] * z.sum[0], dx * y.sum[0] * z.sum[1],
                    dx * y.sum[1] * z.sum[1]);
        addBilinear(gradD_[1], dy * x.sum[0] * z.sum[0], dy * x.sum[1] * z.sum[0], dy * x.sum[0] * z.sum[1],
                    dy * x.sum[1] * z.sum[1]);
        addBilinear(gradD_[2], dz * x.sum[0] * y.sum[0], dz * x.sum[1] * y.sum[0], dz * x.sum[0] * y.sum[1],
                    dz * x.sum[1] * y.sum[1]);
    }

    HWY_INLINE static void accumulate(CubicN& sum, const CubicN& c)
    {
        for (int i = 0; i < 4; ++i)
            sum.b[i] += c.b[i];
    }

    /// Values at (start, start), (end, start), (start, end), (end, end) of the two other coordinates.
    HWY_INLINE static void addBilinear(QuadraticN& sum, FloatN a, FloatN b, FloatN c, FloatN d)
    {
        sum.b[0] += a;
        sum.b[1] = fma(0.5f, b + c, sum.b[1]);
        sum.b[2] += d;
    }

    const RegionTree& tree_;
    const Region& region_;
    const float* values_;
    vec3i origin_;
    const RayN& ray_;
    FloatN reference_;
    PlanesN planes_[mostLevels];
    int levelCount_ = 0;
    CubicN n_, d_;
    QuadraticN gradN_[3], gradD_[3];
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
