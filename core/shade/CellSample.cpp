// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/CellSample.h"

#include <algorithm>

namespace brickwall {
namespace {

/// SplitMix64's finaliser (Steele, Lea, Flood 2014).
std::uint64_t hash(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

} // namespace

std::vector<SampledCell> sampleCells(const Model& model, const Field& field, std::uint64_t count)
{
    const std::uint64_t cells = std::min<std::uint64_t>(model.cellCount, field.values.size());
    const std::uint64_t stride = std::max<std::uint64_t>(1, cells / std::max<std::uint64_t>(1, count));
    std::vector<SampledCell> sample;
    sample.reserve(std::size_t(cells / stride + 1));
    auto brick = model.bricks.begin();
    for (std::uint64_t first = 0; first < cells; first += stride) {
        const std::uint64_t group = std::min(stride, cells - first);
        const std::uint64_t cell = first + hash(first) % group;
        while (cell >= brick->begin + brick->cellCount())
            ++brick;
        const double width = brick->cellWidth();
        sample.push_back({field.values[cell], width * width * width * double(group)});
    }
    return sample;
}

} // namespace brickwall
