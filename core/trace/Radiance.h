// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What rays in lanes collect, and the light that colours are seen in. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_RADIANCE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_RADIANCE_H
#undef BRICKWALL_CORE_TRACE_RADIANCE_H
#else
#define BRICKWALL_CORE_TRACE_RADIANCE_H
#endif

#include "brickwall/core/trace/Reconstruct.h"
#include "brickwall/core/trace/RegionWalk.h"
#include "brickwall/core/trace/TraceTile.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

struct ColorN
{
    FloatN r, g, b;
};

/// What has been collected along rays, front to back.
struct RadianceN
{
    ColorN color;
    FloatN transmittance;
    FloatN weightedDistance;

    HWY_INLINE RadianceN() : color{0.0f, 0.0f, 0.0f}, transmittance(1.0f), weightedDistance(0.0f) {}

    /// Adds a segment [t, t + length] of constant extinction and colour.
    HWY_INLINE void add(FloatN extinction, const ColorN& c, FloatN t, FloatN length)
    {
        const FloatN depth = extinction * length;
        const FloatN through = exp(-depth);
        const FloatN absorbed = FloatN(1.0f) - through;
        const FloatN weight = transmittance * absorbed;
        color.r = fma(weight, c.r, color.r);
        color.g = fma(weight, c.g, color.g);
        color.b = fma(weight, c.b, color.b);
        weightedDistance = fma(weight, fma(meanDepth(depth, through, absorbed), length, t), weightedDistance);
        transmittance *= through;
    }

    /// Where in [0, 1] of a segment its contribution comes from on average: 1/d - e^-d / (1 - e^-d), a series where
    /// that would cancel. Keeps the depth of an opaque surface sharp.
    HWY_INLINE static FloatN meanDepth(FloatN depth, FloatN through, FloatN absorbed)
    {
        const FloatN square = depth * depth;
        const FloatN inner = fma(square, fma(square, 1.0f / 30240.0f, -1.0f / 720.0f), 1.0f / 12.0f);
        const FloatN series = fnma(depth, inner, 0.5f);
        const MaskN thin = depth <= FloatN(0.5f);
        if (all(thin))
            return series;
        return select(thin, series, fnma(depth, through, absorbed) / select(thin, 1.0f, depth * absorbed));
    }
};

/// |cos| between gradient and ray in world space, 1 where there is no gradient.
class Headlight
{
public:
    Headlight(const TraceScene& scene, const RayN& ray, FloatN worldStretch)
        : metric_(scene.gradientMetric), ray_(ray), reciprocalStretch_(FloatN(1.0f) / worldStretch)
    {
        // Fields may be as small as 1e-30: their gradients are scaled so that the squares do not vanish.
        const float span = scene.field->range.span();
        scale_ = span > 0.0f ? std::min(1.0f / span, 1e37f) : 1.0f;
    }

    HWY_INLINE FloatN operator()(const PointN& gradient) const { return abs(cosine(gradient)); }

    /// With the sign of the slope along the ray; 1 where there is no gradient.
    HWY_INLINE FloatN cosine(const PointN& gradient) const
    {
        const FloatN x = gradient.x * scale_, y = gradient.y * scale_, z = gradient.z * scale_;
        const FloatN along = fma(x, ray_.dir[0], fma(y, ray_.dir[1], z * ray_.dir[2]));
        const FloatN gx = fma(x, metric_[0], fma(y, metric_[3], z * metric_[4]));
        const FloatN gy = fma(x, metric_[3], fma(y, metric_[1], z * metric_[5]));
        const FloatN gz = fma(x, metric_[4], fma(y, metric_[5], z * metric_[2]));
        const FloatN squared = fma(x, gx, fma(y, gy, z * gz));
        const FloatN cosine = clamp(along * reciprocalStretch_ / sqrt(squared), -1.0f, 1.0f);
        return select(squared > FloatN(noGradientSquared), cosine, 1.0f);
    }

private:
    const std::array<float, 6>& metric_;
    const RayN& ray_;
    FloatN reciprocalStretch_;
    float scale_;
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
