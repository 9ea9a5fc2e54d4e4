// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Pieces of rays (Pieces.h) in regions of one brick. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_ONE_BRICK_PIECES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_ONE_BRICK_PIECES_H
#undef BRICKWALL_CORE_TRACE_ONE_BRICK_PIECES_H
#else
#define BRICKWALL_CORE_TRACE_ONE_BRICK_PIECES_H
#endif

#include "brickwall/core/trace/Pieces.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// B on pieces in a region of one brick, whose padded values give it: a cubic.
class OneBrickPieces
{
public:
    HWY_INLINE OneBrickPieces(const RegionTree& tree, const Region& region, const float* fieldValues,
                              const vec3i& origin, const RayN& ray)
        : brick_(tree.bricks[tree.brickLists[region.firstBrick]], fieldValues, origin),
          planes_(ray, region.finestLevel, origin)
    {
        for (int axis = 0; axis < 3; ++axis) {
            u_[axis] = fma(ray.org[axis], brick_.reciprocalWidth, brick_.shift[axis]);
            perT_[axis] = ray.dir[axis] * brick_.reciprocalWidth;
        }
    }

    static constexpr int fetches() { return 1; }
    HWY_INLINE FloatN end(FloatN t, FloatN least) const { return planes_.next(t, least); }
    HWY_INLINE FloatN roundingAt(FloatN t) const { return planes_.roundingAt(t); }

    /// Fetches the cells around [t0, t1].
    HWY_INLINE void load(FloatN t0, FloatN t1)
    {
        const Pair x(*this, 0, t0, t1), y(*this, 1, t0, t1), z(*this, 2, t0, t1);
        const CornersN c(brick_, x.cell, y.cell, z.cell);
        // Relative to one of them: gradients of fields that hardly vary would otherwise be the rounding of their
        // values.
        reference_ = c.v[0][0][0];
        for (int k = 0; k < 2; ++k) {
            for (int j = 0; j < 2; ++j) {
                const FloatN start = c.v[k][j][0] - reference_;
                slope_[k][j] = c.v[k][j][1] - c.v[k][j][0];
                row_[k][j][0] = fma(x.f[0], slope_[k][j], start);
                row_[k][j][1] = fma(x.f[1], slope_[k][j], start);
            }
            for (int i = 0; i < 2; ++i) {
                rise_[k][i] = row_[k][1][i] - row_[k][0][i];
                for (int j = 0; j < 2; ++j)
                    plane_[k][j][i] = fma(y.f[j], rise_[k][i], row_[k][0][i]);
            }
        }
        FloatN v[2][2][2];
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i)
                for (int k = 0; k < 2; ++k)
                    v[k][j][i] = lerp(plane_[0][j][i], plane_[1][j][i], z.f[k]);
        value_ = cubicOf(v);
        for (int k = 0; k < 2; ++k) {
            y_[k] = y.f[k];
            z_[k] = z.f[k];
        }
    }

    /// What B cannot leave on the piece.
    HWY_INLINE FloatN least() const { return reference_ + value_.least(); }
    HWY_INLINE FloatN largest() const { return reference_ + value_.largest(); }

    /// B and dB/ds at s in [0, 1] of the piece.
    HWY_INLINE void at(FloatN s, FloatN& value, FloatN& slope) const
    {
        evaluate(value_, s, value, slope);
        value += reference_;
    }

    /// Of B on [s0, s1].
    HWY_INLINE EnclosureN enclosure(FloatN s0, FloatN s1) const
    {
        const CubicN c = restricted(value_, s0, s1);
        return {reference_ + c.least(), reference_ + c.largest()};
    }

    /// Needed before gradientAt.
    HWY_INLINE void loadGradient()
    {
        FloatN e[2][2];
        for (int k = 0; k < 2; ++k)
            for (int j = 0; j < 2; ++j)
                e[k][j] = lerp(slope_[k][0], slope_[k][1], y_[j]);
        gradient_[0] = quadraticOf(lerp(e[0][0], e[1][0], z_[0]), lerp(e[0][1], e[1][1], z_[0]),
                                   lerp(e[0][0], e[1][0], z_[1]), lerp(e[0][1], e[1][1], z_[1]));
        gradient_[1] = quadraticOf(lerp(rise_[0][0], rise_[1][0], z_[0]), lerp(rise_[0][1], rise_[1][1], z_[0]),
                                   lerp(rise_[0][0], rise_[1][0], z_[1]), lerp(rise_[0][1], rise_[1][1], z_[1]));
        gradient_[2] = quadraticOf(plane_[1][0][0] - plane_[0][0][0], plane_[1][0][1] - plane_[0][0][1],
                                   plane_[1][1][0] - plane_[0][1][0], plane_[1][1][1] - plane_[0][1][1]);
    }

    /// Per voxel.
    HWY_INLINE PointN gradientAt(FloatN s) const
    {
        const FloatN w = brick_.reciprocalWidth;
        return {w * gradient_[0](s), w * gradient_[1](s), w * gradient_[2](s)};
    }

private:
    /// The pair of cells around a piece along an axis, found from its middle, and the positions of its ends between
    /// their centres.
    struct Pair
    {
        CellN cell;
        FloatN f[2];

        HWY_INLINE Pair(const OneBrickPieces& p, int axis, FloatN t0, FloatN t1)
            : cell(FloatN(0.5f) * (t0 + t1), p.perT_[axis], p.u_[axis], p.brick_.size[axis])
        {
            f[0] = clamp(fma(t0, p.perT_[axis], p.u_[axis]) - cell.index, 0.0f, 1.0f);
            f[1] = clamp(fma(t1, p.perT_[axis], p.u_[axis]) - cell.index, 0.0f, 1.0f);
        }
    };

    /// Of a bilinear function: its values at (start, start), (end, start), (start, end), (end, end).
    HWY_INLINE static QuadraticN quadraticOf(FloatN a, FloatN b, FloatN c, FloatN d)
    {
        return {{a, FloatN(0.5f) * (b + c), d}};
    }

    BrickView brick_;
    PlanesN planes_;
    FloatN u_[3], perT_[3];
    FloatN slope_[2][2], row_[2][2][2], rise_[2][2], plane_[2][2][2], y_[2], z_[2];
    FloatN reference_;
    CubicN value_; ///< less the reference
    QuadraticN gradient_[3];
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
