// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What the methods of the literature share that take steps along rays in lanes. Per instruction set, see
/// core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_STEPPING_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_STEPPING_H
#undef BRICKWALL_CORE_TRACE_STEPPING_H
#else
#define BRICKWALL_CORE_TRACE_STEPPING_H
#endif

#include "brickwall/core/trace/FieldColors.h"
#include "brickwall/core/trace/Radiance.h"
#include "brickwall/core/trace/Reconstruct.h"
#include "brickwall/core/trace/RegionWalk.h"
#include "brickwall/core/trace/TraceTile.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The planes t = (offset + k) step of a ray, those beyond t0, one after the other.
class SamplePlanesN
{
public:
    HWY_INLINE SamplePlanesN(FloatN t0, FloatN step, FloatN offset) : step_(step), offset_(offset), last_(t0)
    {
        k_ = floor(t0 / step - offset) + FloatN(1.0f);
        k_ = select((offset + k_) * step <= t0, k_ + FloatN(1.0f), k_);
    }

    HWY_INLINE FloatN next()
    {
        // Far away, where floats are further apart than the planes, every float is one: the walk has to come to an end.
        const FloatN least = fma(abs(last_), 1.2e-7f, last_);
        last_ = max((offset_ + k_) * step_, least);
        k_ += FloatN(1.0f);
        return last_;
    }

private:
    FloatN step_, offset_, last_, k_;
};

/// The visitor of a RegionWalk that hands a region's field to Method::march(region, active, t0, t1, field), where
/// field(t, lanes) is B along the ray, clamped to the region's range: B stays inside it, and rounding must not push it
/// over the edge of the transfer function.
template <class Method, bool shaded>
class Stepping
{
public:
    Stepping(const TraceScene& scene, const StepParameters& parameters, const RayN& ray, FloatN offset,
             FloatN worldStretch)
        : scene_(scene),
          headlight_(scene, ray, worldStretch),
          ray_(ray),
          offset_(offset),
          dt_(parameters.dt),
          leastTransmittance_(1.0f - parameters.terminationOpacity)
    {
    }

    MaskN operator()(std::uint32_t index, MaskN active, FloatN t0, FloatN t1)
    {
        const Region& region = scene_.regions->regions[index];
        index_ = index;
        const Range range = scene_.field->regionRanges[index];
        const float* values = scene_.field->values.data();
        counts.regionsVisited += count(active);
        if (region.brickCount == 1) {
            const BrickView brick(scene_.regions->bricks[scene_.regions->brickLists[region.firstBrick]], values,
                                  scene_.origin);
            const auto field = [&](FloatN t, MaskN lanes) LANES_LAMBDA {
                return counted(sampleBrick<shaded>(brick, pointAt(t)), range, lanes, 1);
            };
            static_cast<Method*>(this)->march(region, active, t0, t1, field);
        } else {
            const auto field = [&](FloatN t, MaskN lanes) LANES_LAMBDA {
                const SampleN s =
                    sampleBricks<shaded>(*scene_.regions, region, values, scene_.origin, pointAt(t), range.lo);
                return counted(s, range, lanes, region.brickCount);
            };
            static_cast<Method*>(this)->march(region, active, t0, t1, field);
        }
        return goesOn(active);
    }

    RadianceN radiance;
    TraceCounts counts;

protected:
    HWY_INLINE FloatN stepIn(const Region& region) const { return dt_ * static_cast<float>(1 << region.finestLevel); }

    HWY_INLINE MaskN goesOn(MaskN active) const
    {
        return active & (radiance.transmittance > FloatN(leastTransmittance_));
    }

    HWY_INLINE PointN pointAt(FloatN t) const
    {
        return {fma(t, ray_.dir[0], ray_.org[0]), fma(t, ray_.dir[1], ray_.org[1]), fma(t, ray_.dir[2], ray_.org[2])};
    }

    /// Whether colours are those of another field.
    bool isColoredByField() const { return scene_.colors.field != nullptr; }

    /// That field in the region at hand, in the range of the colours.
    HWY_INLINE FloatN colorValueAt(FloatN t, MaskN lanes)
    {
        const auto n = static_cast<std::uint64_t>(count(lanes));
        counts.samples += n;
        counts.fetches += n * scene_.regions->regions[index_].brickCount;
        return brickwall::HWY_NAMESPACE::colorValueAt(scene_, index_, pointAt(t));
    }

    /// What was looked up for a place, in its colour if that is of another field.
    template <class Lookup>
    HWY_INLINE QuadN inItsColor(const QuadN& look, const Lookup& colors, FloatN t, MaskN lanes)
    {
        const MaskN seen = lanes & (look.d > FloatN(0.0f));
        if (!isColoredByField() || none(seen))
            return look;
        const QuadN color = colors(colorValueAt(t, seen), seen);
        return {color.a, color.b, color.c, look.d};
    }

    /// What colours are multiplied by.
    HWY_INLINE FloatN shade(const SampleN& s) const
    {
        if constexpr (shaded)
            return headlight_(s.gradient);
        else
            return 1.0f;
    }

    const TraceScene& scene_;
    Headlight headlight_;
    const RayN& ray_;
    FloatN offset_;
    float dt_;
    float leastTransmittance_;

private:
    std::uint32_t index_ = 0; ///< of the region at hand

    HWY_INLINE SampleN counted(SampleN s, const Range& range, MaskN lanes, std::uint32_t bricks)
    {
        const auto n = static_cast<std::uint64_t>(count(lanes));
        counts.samples += n;
        counts.fetches += n * bricks;
        s.value = clamp(s.value, range.lo, range.hi);
        return s;
    }
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
