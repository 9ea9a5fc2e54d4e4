// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/trace/TraceTile.h"

#include <cstdint>
#include <memory>

namespace brickwall::bench {

/// The other way to walk: regions that the transfer function shows as boxes of an Embree scene (user geometry, its best
/// builder), of which a packet of 16 rays is asked for the nearest one, again and again, from where it left the last.
/// For comparison with the kd-tree alone; it integrates nothing.
class EmbreeRegions
{
public:
    /// Builds the hierarchy for the regions with any extinction in `scene.regionBounds`; borrows the scene.
    explicit EmbreeRegions(const TraceScene& scene);
    ~EmbreeRegions();
    EmbreeRegions(const EmbreeRegions&) = delete;
    EmbreeRegions& operator=(const EmbreeRegions&) = delete;

    /// The regions that all rays of the tile meet, as countRegions.
    std::uint64_t count(const RayTile& rays) const;

private:
    struct Embree;
    std::unique_ptr<Embree> embree_;
};

} // namespace brickwall::bench
