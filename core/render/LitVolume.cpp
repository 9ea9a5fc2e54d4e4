// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/LitVolume.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

template <class T>
using PerRay = RayTile::PerRay<T>;

/// Of what a ray sees of the data.
constexpr float longestStep = 1.0f / 16.0f, shortestStep = 0x1p-14f;

/// What a step has added to a ray of a tile.
struct Added
{
    float color = 0.0f; ///< the largest component
    float opacity = 0.0f;

    Added(const TileResult& before, const TileResult& after, int ray)
        : opacity(before.transmittance[ray] - after.transmittance[ray])
    {
        for (int c = 0; c < 3; ++c)
            color = std::max(color, after.color[c][ray] - before.color[c][ray]);
    }
};

/// Where the rays of a tile are on their way.
class LitRays
{
public:
    LitRays(const LightVisibility& light, const Light& settings, const RayTile& tile, TileResult& result)
        : light_(light), settings_(settings), tile_(tile), result_(result)
    {
        for (int i = 0; i < tile.count; ++i) {
            at_[i] = tile.tNear[i];
            step_[i] = longestStep * (tile.tFar[i] - tile.tNear[i]);
            seen_[i] = 1.0f;
        }
    }

    /// The next step of every ray; false if all are at their end.
    bool next(RayTile& part)
    {
        bool any = false;
        for (int i = 0; i < tile_.count; ++i) {
            part.tNear[i] = at_[i];
            const float end = at_[i] + step_[i];
            // Not even a step that rounding swallows may keep a ray where it is.
            part.tFar[i] = end < tile_.tFar[i] && end > at_[i] ? end : tile_.tFar[i];
            any = any || part.tNear[i] < part.tFar[i];
        }
        return any;
    }

    /// Keeps what was added, with its light, or takes it back for a shorter step.
    void finish(const RayTile& part, const TileResult& before)
    {
        lookAt(part, before);
        for (int i = 0; i < tile_.count; ++i) {
            if (!(part.tNear[i] < part.tFar[i]))
                continue;
            const Added added(before, result_, i);
            const float error = matters_[i] ? 0.5f * gap() * std::abs(far_[i] - seen_[i]) * added.color : 0.0f;
            const float share = shareOf(part, added, i);
            if (error > share && step_[i] > shortestStep * (tile_.tFar[i] - tile_.tNear[i])) {
                takeBack(before, i);
                step_[i] *= 0.5f;
                continue;
            }
            light(before, i, matters_[i] ? 0.5f * (far_[i] + seen_[i]) : seen_[i]);
            seen_[i] = matters_[i] ? far_[i] : seen_[i];
            isSeenHere_[i] = matters_[i];
            at_[i] = part.tFar[i];
            if (error < 0.25f * share)
                step_[i] = std::min(2.0f * step_[i], longestStep * (tile_.tFar[i] - tile_.tNear[i]));
        }
    }

private:
    float gap() const { return 1.0f - settings_.ambient; }

    float shareOf(const RayTile& part, const Added& added, int i) const
    {
        const float length = (part.tFar[i] - part.tNear[i]) / (tile_.tFar[i] - tile_.tNear[i]);
        return 0.5f * settings_.tolerance * (length + added.opacity);
    }

    /// Asks for the light at both ends of a step if it could make a difference.
    void lookAt(const RayTile& part, const TileResult& before)
    {
        PerRay<vec3d> points;
        PerRay<bool> unknown{};
        for (int i = 0; i < tile_.count; ++i) {
            const bool moves = part.tNear[i] < part.tFar[i];
            const Added added(before, result_, i);
            matters_[i] = moves && gap() * added.color > shareOf(part, added, i);
            unknown[i] = matters_[i] && !isSeenHere_[i];
            isSeenHere_[i] = isSeenHere_[i] || unknown[i];
            points[i] = SecondaryRays::pointAt(tile_, i, part.tNear[i]);
        }
        light_.from(points, unknown, tile_.count, seen_, result_.counts);
        for (int i = 0; i < tile_.count; ++i)
            points[i] = SecondaryRays::pointAt(tile_, i, part.tFar[i]);
        light_.from(points, matters_, tile_.count, far_, result_.counts);
    }

    void takeBack(const TileResult& before, int i)
    {
        for (int c = 0; c < 3; ++c)
            result_.color[c][i] = before.color[c][i];
        result_.transmittance[i] = before.transmittance[i];
        result_.weightedDistance[i] = before.weightedDistance[i];
        result_.error[i] = before.error[i];
    }

    void light(const TileResult& before, int i, float visibility)
    {
        for (int c = 0; c < 3; ++c) {
            const float dark = before.color[c][i];
            result_.color[c][i] = dark + light_.remains(visibility) * (result_.color[c][i] - dark);
        }
    }

    const LightVisibility& light_;
    const Light& settings_;
    const RayTile& tile_;
    TileResult& result_;
    PerRay<float> at_, step_;
    PerRay<float> seen_, far_; ///< the visibility where it was known last, and at the step's end
    PerRay<bool> isSeenHere_{}, matters_{};
};

} // namespace

void integrateLit(const std::function<void(const RayTile&, TileResult&)>& integrate, const Light& light,
                  const LightVisibility& visibility, const RayTile& tile, TileResult& result)
{
    LitRays rays(visibility, light, tile, result);
    RayTile part = tile;
    while (rays.next(part)) {
        const TileResult before = result;
        integrate(part, result);
        rays.finish(part, before);
    }
}

} // namespace brickwall
