// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What rays in lanes may still err. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_ERROR_BUDGET_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_ERROR_BUDGET_H
#undef BRICKWALL_CORE_TRACE_ERROR_BUDGET_H
#else
#define BRICKWALL_CORE_TRACE_ERROR_BUDGET_H
#endif

#include "brickwall/core/simd/Lanes.h"
#include "brickwall/core/trace/BoundedTuning.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// What rays may still err, and have erred, along their whole length. Errors of samples at steps are as often above as
/// below, so that their squares add up; those of refined parts of pieces are added as they are.
class ErrorBudgetN
{
public:
    /// `end`: the t where the whole ray ends, for what is not spent in front is left for what lies behind.
    HWY_INLINE ErrorBudgetN(FloatN allowed, FloatN end)
        : allowed_(allowed), end_(end), sum_(0.0f), squares_(0.0f), root_(0.0f), left_(allowed)
    {
    }

    HWY_INLINE FloatN spent() const { return sum_ + root_; }

    /// What a part of the ray may add to the sum: half by its length, half by its opacity, so that neither long faint
    /// parts nor short dense ones starve. `perLength` is that of its piece or region.
    HWY_INLINE FloatN share(FloatN perLength, FloatN length, FloatN opacity) const
    {
        return FloatN(0.5f) * left_ * fma(length, perLength, opacity);
    }

    /// One over what is still before the ray.
    HWY_INLINE FloatN perLength(FloatN t) const { return FloatN(1.0f) / max(end_ - t, FloatN(1e-3f)); }

    /// What a ray may add to the squares, per length: half of what is left goes there.
    HWY_INLINE FloatN squares(FloatN perLength) const
    {
        const FloatN most = fma(0.5f, left_, root_);
        return fma(most, most, -squares_) * perLength;
    }

    HWY_INLINE void addToSum(MaskN lanes, FloatN error)
    {
        sum_ += valueOrZero(lanes, error);
        update();
    }

    HWY_INLINE void addToSquares(FloatN squares)
    {
        squares_ += squares;
        root_ = sqrt(squares_);
        update();
    }

private:
    HWY_INLINE void update() { left_ = max(allowed_ - spent(), allowed_ * FloatN(tuning::leastLeft)); }

    FloatN allowed_, end_;
    FloatN sum_, squares_, root_, left_; ///< root_: of squares_
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
