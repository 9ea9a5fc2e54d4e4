// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The bounded method along rays in lanes (TraceTile.h says what it computes, docs/decisions/0013 why it is so). Per
/// instruction set, see core/simd/Lanes.h.
///
/// ErrorBudget.h: what may still be spent. BoundedSteps.h: one sample per step, where that is enough. BoundedPieces.h:
/// else piece by piece, in parts (Parts.h). BoundedTuning.h: the numbers in all of it.
#if defined(BRICKWALL_CORE_TRACE_BOUNDED_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_BOUNDED_H
#undef BRICKWALL_CORE_TRACE_BOUNDED_H
#else
#define BRICKWALL_CORE_TRACE_BOUNDED_H
#endif

#include "brickwall/core/trace/BoundedPieces.h"
#include "brickwall/core/trace/BoundedSteps.h"
#include "brickwall/core/trace/OneBrickPieces.h"
#include "brickwall/core/trace/SeveralBricksPieces.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The visitor of a RegionWalk that spends an error budget. `colored`: by another field.
template <bool shaded, bool colored>
class Bounded
{
public:
    /// `end`: where the whole rays end; `error`: what earlier parts of them have erred.
    Bounded(const TraceScene& scene, const BoundedParameters& parameters, const RayN& ray, FloatN end,
            FloatN worldStretch, FloatN error)
        : rays(scene, parameters, ray, end, worldStretch, error)
    {
    }

    MaskN operator()(std::uint32_t index, MaskN active, FloatN t0, FloatN t1)
    {
        const TraceScene& scene = rays.scene;
        const Region& region = scene.regions->regions[index];
        const float* values = scene.field->values.data();
        rays.counts.regionsVisited += count(active);
        if (region.brickCount == 1) {
            const BrickView brick(scene.regions->bricks[scene.regions->brickLists[region.firstBrick]], values,
                                  scene.origin);
            visit<OneBrickPieces>(region, index, active, t0, t1,
                                  [&](const PointN& p) LANES_LAMBDA { return sampleBrick<shaded>(brick, p); });
        } else {
            const float reference = scene.field->regionRanges[index].lo;
            visit<SeveralBricksPieces>(region, index, active, t0, t1, [&](const PointN& p) LANES_LAMBDA {
                return sampleBricks<shaded>(*scene.regions, region, values, scene.origin, p, reference);
            });
        }
        return rays.goOn();
    }

    BoundedRays rays;

private:
    template <class Pieces, class Field>
    HWY_INLINE void visit(const Region& region, std::uint32_t index, MaskN active, FloatN t0, FloatN t1,
                          const Field& field)
    {
        const FloatN t = BoundedSteps<shaded, colored>(rays, region, index)(active, t0, t1, field);
        const MaskN todo = active & (t < t1) & rays.goOn();
        if (any(todo))
            BoundedPieces<Pieces, shaded, colored>(rays, region, index)(todo, t, t1);
    }
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
