// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What rays in lanes carry along in the bounded method. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_BOUNDED_RAYS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_BOUNDED_RAYS_H
#undef BRICKWALL_CORE_TRACE_BOUNDED_RAYS_H
#else
#define BRICKWALL_CORE_TRACE_BOUNDED_RAYS_H
#endif

#include "brickwall/core/trace/ErrorBudget.h"
#include "brickwall/core/trace/FieldColors.h"
#include "brickwall/core/trace/Parts.h"
#include "brickwall/core/trace/Radiance.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

struct BoundedRays
{
    const TraceScene& scene;
    const RayN& ray;
    TransferIntegralLookup lookup;
    TransferIntegralLookup colors; ///< if they are of another field
    Headlight headlight;
    float leastTransmittance; ///< with less, a ray ends

    RadianceN radiance;
    TraceCounts counts;
    ErrorBudgetN budget;
    FloatN before;   ///< the error of earlier parts of the ray
    FloatN rounding; ///< errors that no refinement would take away: no part of the budget

    // What was found last, for the steps that are taken next.
    FloatN step;      ///< suggested; 0 where none has been taken
    FloatN lastAt;    ///< t where that was
    FloatN lastStep;  ///< taken; 0 after a piece
    QuadN last;       ///< c sigma, sigma there; c with the light
    FloatN lastLight; ///< at the end of the last piece

    BoundedRays(const TraceScene& traceScene, const BoundedParameters& parameters, const RayN& rays, FloatN end,
                FloatN worldStretch, FloatN error)
        : scene(traceScene),
          ray(rays),
          lookup(*traceScene.integral),
          colors(colorIntegralOf(traceScene)),
          headlight(traceScene, rays, worldStretch),
          leastTransmittance(parameters.tolerance * tuning::endShare),
          budget(max(FloatN(parameters.tolerance * (tuning::usedShare - tuning::endShare)) - error, 0.0f), end),
          before(error),
          rounding(0.0f),
          step(0.0f),
          lastAt(-1.0f),
          lastStep(0.0f),
          last{0.0f, 0.0f, 0.0f, 0.0f},
          lastLight(0.0f)
    {
    }

    HWY_INLINE MaskN goOn() const { return radiance.transmittance > FloatN(leastTransmittance); }

    /// The bound of all errors so far, with that of having stopped where next to nothing would have followed.
    HWY_INLINE FloatN error() const
    {
        const MaskN ended = radiance.transmittance <= FloatN(leastTransmittance);
        return before + budget.spent() + rounding + valueOrZero(ended, radiance.transmittance);
    }

    HWY_INLINE PointN pointAt(FloatN t) const
    {
        return {fma(t, ray.dir[0], ray.org[0]), fma(t, ray.dir[1], ray.org[1]), fma(t, ray.dir[2], ray.org[2])};
    }

    /// Since what was found last.
    HWY_INLINE FloatN changeTo(const QuadN& density) const { return largestChange(density - last); }
    HWY_INLINE void add(MaskN lanes, const SegmentN& segment, FloatN t, FloatN length)
    {
        // Lanes that are not meant may hold anything, even NaN.
        const FloatN through = radiance.transmittance;
        const FloatN where = RadianceN::meanDepth(segment.depth, segment.through, segment.opacity);
        radiance.color.r += valueOrZero(lanes, through * segment.red);
        radiance.color.g += valueOrZero(lanes, through * segment.green);
        radiance.color.b += valueOrZero(lanes, through * segment.blue);
        radiance.weightedDistance += valueOrZero(lanes, through * segment.opacity * fma(where, length, t));
        radiance.transmittance *= select(lanes, segment.through, 1.0f);
    }

    /// A part of a piece, and what it errs; `most` is what it may err at the worst, per transmittance.
    HWY_INLINE void add(MaskN lanes, const PartN& part, FloatN most, FloatN t, FloatN length)
    {
        budget.addToSum(lanes, radiance.transmittance * min(part.error, most));
        rounding += valueOrZero(lanes, radiance.transmittance * min(part.rounding, most));
        add(lanes, part.segment, t, length);
    }
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
