// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/InputFile.h"

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// A .scalars file: float32 values, by their index, of which no more is read than is asked for, so that a large field
/// is not in memory twice. Any number of threads may gather at the same time. Throws Error, and Cancelled.
class ScalarsFile
{
public:
    ScalarsFile(const std::string& path, const Progress& progress);

    std::uint64_t size() const { return size_; } ///< in values

    /// The values of as many IDs, each below size(). IDs of neighbours in a brick mostly are neighbours in the file:
    /// these values are read at once. Where they are not, all of the file is read, once.
    void gather(std::span<const std::uint32_t> ids, std::span<float> values);

private:
    const std::vector<float>& all();

    InputFile file_;
    const Progress& progress_;
    std::uint64_t size_;
    std::once_flag read_;
    std::vector<float> all_;
};

} // namespace brickwall
