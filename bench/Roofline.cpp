// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/bench/Roofline.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/bench/Roofline.h"
#include "brickwall/core/simd/Lanes.h"
#include "brickwall/core/trace/Packet.h"
#include "brickwall/core/trace/TransferLookup.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The lower of two neighbours along an axis, and where between them.
struct GridAxisN
{
    IntN index;
    FloatN f;

    HWY_INLINE GridAxisN(FloatN t, FloatN dir, FloatN org)
    {
        const FloatN u = fma(t, dir, org); // not below 0 by more than rounding
        index = toInt(u);
        f = u - toFloat(index);
    }
};

HWY_INLINE FloatN valueOf(const bench::DenseVolume& volume, const GridAxisN& x, const GridAxisN& y, const GridAxisN& z)
{
    const int strideY = volume.size.x, strideZ = volume.size.x * volume.size.y;
    const IntN base = x.index + y.index * IntN(strideY) + z.index * IntN(strideZ);
    const float* lower = volume.values.data();
    const float* upper = lower + strideZ;
    const QuadN a = gatherQuads(PairsAt{lower, lower + strideY}, base);
    const QuadN b = gatherQuads(PairsAt{upper, upper + strideY}, base);
    return lerp(lerp(lerp(a.a, a.b, x.f), lerp(a.c, a.d, x.f), y.f),
                lerp(lerp(b.a, b.b, x.f), lerp(b.c, b.d, x.f), y.f), z.f);
}

template <bench::Work work>
std::uint64_t march(const bench::DenseVolume& volume, const TransferTable& table, float step, float lengthPerStep,
                    const vec3i& origin, const RayTile& tile, TileResult& result)
{
    const TransferLookup lookup(table);
    std::uint64_t samples = 0;
    for (int i = 0; i < tile.count; ++i)
        samples += std::uint64_t(std::ceil(std::max(0.0f, (tile.tFar[i] - tile.tNear[i]) / step - 0.5f)));
    for (int first = 0; first < tile.count; first += laneCount) {
        const PacketN packet(tile, first);
        FloatN org[3];
        for (int axis = 0; axis < 3; ++axis)
            org[axis] = packet.ray.org[axis] + FloatN(0.5f * static_cast<float>(origin[axis]));
        ColorN color{0.0f, 0.0f, 0.0f};
        FloatN transmittance = 1.0f;
        FloatN t = packet.t0 + FloatN(0.5f * step);
        MaskN active = packet.active & (t < packet.t1);
        while (any(active)) {
            const FloatN at = min(t, packet.t1);
            const FloatN value =
                valueOf(volume, GridAxisN(at, packet.ray.dir[0], org[0]), GridAxisN(at, packet.ray.dir[1], org[1]),
                        GridAxisN(at, packet.ray.dir[2], org[2]));
            if constexpr (work == bench::Work::fetch) {
                color.r += value;
            } else {
                const QuadN look = lookup(value, active);
                const FloatN through = exp(-look.d * FloatN(lengthPerStep));
                const FloatN weight = fnma(transmittance, through, transmittance);
                color = {fma(weight, look.a, color.r), fma(weight, look.b, color.g), fma(weight, look.c, color.b)};
                transmittance *= through;
            }
            t += FloatN(step);
            active = active & (t < packet.t1);
        }
        store(color.r, result.color[0].data() + first);
        store(color.g, result.color[1].data() + first);
        store(color.b, result.color[2].data() + first);
        store(transmittance, result.transmittance.data() + first);
    }
    return samples;
}

std::uint64_t fetchKernel(const bench::DenseVolume& volume, const TransferTable& table, float step, float lengthPerStep,
                          const vec3i& origin, const RayTile& tile, TileResult& result)
{
    return march<bench::Work::fetch>(volume, table, step, lengthPerStep, origin, tile, result);
}

std::uint64_t compositeKernel(const bench::DenseVolume& volume, const TransferTable& table, float step,
                              float lengthPerStep, const vec3i& origin, const RayTile& tile, TileResult& result)
{
    return march<bench::Work::composite>(volume, table, step, lengthPerStep, origin, tile, result);
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brickwall {

HWY_EXPORT(fetchKernel);
HWY_EXPORT(compositeKernel);

bench::DenseVolume::DenseVolume(const vec3i& size) : size(size)
{
    const std::size_t slice = std::size_t(size.x) * size.y;
    values.resize(slice * (size.z + 1) + size.x + 2);
}

std::uint64_t bench::marchDense(const DenseVolume& volume, const TransferTable& table, Work work, float step,
                                float lengthPerStep, const vec3i& origin, const RayTile& rays, TileResult& result)
{
    if (work == Work::fetch)
        return HWY_DYNAMIC_DISPATCH(fetchKernel)(volume, table, step, lengthPerStep, origin, rays, result);
    return HWY_DYNAMIC_DISPATCH(compositeKernel)(volume, table, step, lengthPerStep, origin, rays, result);
}

} // namespace brickwall
#endif
