// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/model/Pyramid.h"
#include "brickwall/core/model/Regions.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace brickwall {

/// What of a data set is wanted, ready for rays.
struct VolumeRequest
{
    std::string data;                ///< as the user named it
    std::vector<std::string> derive; ///< definitions of fields, as the user typed them
    std::vector<std::string> fields;
    NonFinite nonFinite = NonFinite::error;
    bool pyramid = false; ///< its members too

    bool operator==(const VolumeRequest&) const = default;
};

/// Where volumes that took long to make are kept for the next time.
struct VolumeCache
{
    std::string folder;                                    ///< empty: nowhere
    std::uint64_t leastCells = std::uint64_t(8) << 20;     ///< smaller ones are not worth it
    std::uint64_t mostBytes = std::uint64_t(32) << 30;     ///< of all together: those not used for longest go
    std::uint64_t leastFreeBytes = std::uint64_t(1) << 30; ///< of the disk: beyond that nothing is kept
};

/// Bricks with their layers of neighbours, and regions.
struct PreparedVolume
{
    Model model; ///< its fields have no values any more
    std::shared_ptr<const RegionTree> regions;
    std::vector<std::shared_ptr<const PaddedField>> fields; ///< in the order of the model's
    std::vector<PyramidMember> pyramid;
    bool fromCache = false;
    double loadMilliseconds = 0.0;    ///< from the file to bricks, or from the cache to all of it
    double prepareMilliseconds = 0.0; ///< bricks to regions and padded fields; 0 from the cache

    std::size_t bytes() const; ///< of regions, fields and pyramid
};

/// `$BRICKWALL_CACHE` is the folder, or `off`; otherwise `$XDG_CACHE_HOME/brickwall` or `~/.cache/brickwall`.
VolumeCache userCache();

/// Takes the volume from the cache if the files of the data set are those that it was made from (DataStamp.h);
/// otherwise loads it, builds regions, pads fields, and keeps all that in the cache. `data` is `request.data`, opened,
/// with the fields defined.
///
/// A cache that is damaged or cannot be written, as the disk is full, is as if there were none, but for a note. Any
/// number of processes may use it at the same time. Throws what loading does, and Cancelled, which leaves nothing.
PreparedVolume prepareVolume(const DataSet& data, const VolumeRequest& request, const VolumeCache& cache,
                             const Executor& executor, Progress& progress);

} // namespace brickwall
