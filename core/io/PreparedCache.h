// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/PreparedVolume.h"

#include <optional>
#include <string>
#include <vector>

namespace brickwall {

/// The place of one prepared volume in a cache. Nothing that goes wrong there is an Error: it is a note.
class PreparedCache
{
public:
    /// `files` are those of the data set; without any, or without a folder, there is no cache.
    PreparedCache(const VolumeCache& cache, const VolumeRequest& request, const std::vector<std::string>& files);

    /// The volume, if it is there, whole, and made from these files as they are. Throws Cancelled.
    std::optional<PreparedVolume> read(const Executor& executor, Progress& progress) const;

    /// Keeps it, and removes what has not been used for longest if all together is too much. `stamp` is that of the
    /// files (DataStamp.h) when the volume was made. Throws Cancelled.
    void write(const PreparedVolume& volume, const std::string& stamp, const Executor& executor,
               Progress& progress) const;

private:
    void makeRoom(std::uint64_t bytes) const;

    const VolumeCache& cache_;
    VolumeRequest request_; ///< whatever way its file was named
    const std::vector<std::string>& files_;
    std::string path_; ///< empty: none
};

} // namespace brickwall
