// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ScalarsFile.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>

namespace brickwall {
namespace {

constexpr std::uint64_t chunk = 1 << 20;    // values that are read at a time
constexpr std::uint64_t mostInWindow = 4;   // values read for each that is wanted
constexpr std::uint64_t smallWindow = 4096; // whatever is wanted

bool areConsecutive(std::span<const std::uint32_t> ids)
{
    for (std::size_t i = 1; i < ids.size(); ++i)
        if (ids[i] != ids[0] + i)
            return false;
    return true;
}

} // namespace

ScalarsFile::ScalarsFile(const std::string& path, const Progress& progress)
    : file_(path), progress_(progress), size_(file_.size() / sizeof(float))
{
    if (file_.size() == 0)
        throw Error(path, "the file is empty, expected float32 values");
    if (file_.size() % sizeof(float) != 0)
        throw Error(path, fmt::format("truncated: expected float32 values, found {} bytes, which is no multiple of 4",
                                      file_.size()));
}

void ScalarsFile::gather(std::span<const std::uint32_t> ids, std::span<float> values)
{
    if (ids.empty())
        return;
    if (areConsecutive(ids))
        return file_.readAt(std::uint64_t(ids[0]) * sizeof(float), values, "values");
    const auto ends = std::ranges::minmax(ids);
    const std::uint32_t least = ends.min;
    const std::uint64_t count = std::uint64_t(ends.max) - least + 1;
    if (count > std::max(mostInWindow * ids.size(), smallWindow)) {
        const std::vector<float>& whole = all();
        std::ranges::transform(ids, values.begin(), [&](std::uint32_t id) { return whole[id]; });
        return;
    }
    std::vector<float> window(count);
    file_.readAt(std::uint64_t(least) * sizeof(float), std::span(window), "values");
    std::ranges::transform(ids, values.begin(), [&](std::uint32_t id) { return window[id - least]; });
}

const std::vector<float>& ScalarsFile::all()
{
    std::call_once(read_, [&] {
        all_.resize(size_);
        for (std::uint64_t i = 0; i < size_; i += chunk) {
            progress_.check();
            file_.readAt(i * sizeof(float), std::span(all_).subspan(i, std::min(chunk, size_ - i)), "values");
        }
    });
    return all_;
}

} // namespace brickwall
