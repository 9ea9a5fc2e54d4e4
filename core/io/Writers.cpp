// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Writers.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace brickwall {

std::span<const TargetFormat> targetFormats()
{
    static const std::array all{
        TargetFormat{".exa", "ExaBrick, with .bricks and .scalars beside it", makeExaWriter},
        TargetFormat{".vdb", "OpenVDB, one grid per field and level", makeVdbWriter},
        TargetFormat{".vthb", "VTK overlapping AMR, with a folder of .vti pieces", makeVthbWriter},
        TargetFormat{".brickwall", "our own cache, which is read fastest", makeCacheWriter},
    };
    return all;
}

void forEachPiece(const CellSelection& cells, const SelectedValues& values, const Executor& executor,
                  Progress& progress,
                  const std::function<void(std::size_t, std::uint64_t, std::span<const float>)>& body)
{
    executor.forEach(cells.bricks.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<float> piece;
        for (std::size_t b = begin; b < end; ++b) {
            const std::uint64_t count = cells.bricks[b].cellCount();
            for (std::uint64_t first = 0; first < count; first += cellsAtOnce) {
                progress.check();
                piece.resize(std::min<std::uint64_t>(cellsAtOnce, count - first));
                values.read(b, first, piece);
                body(b, first, piece);
                progress.advance(piece.size());
            }
        }
    });
}

std::string fileNamePart(const std::string& name)
{
    std::string part = name;
    std::replace_if(
        part.begin(), part.end(),
        [](char c) {
            return !((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                     c == '-' || c == '_');
        },
        '_');
    return part;
}

vec3d voxelWidths(const Model& model, const std::string& format, const std::string& place)
{
    const mat4d& m = model.worldFromVoxel;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            if (c == r ? !(m[c][r] > 0.0) : m[c][r] != 0.0)
                throw Error(place, fmt::format("{} has no place for data whose axes are turned or mirrored against "
                                               "the world; write .brickwall",
                                               format));
    return {m[0][0], m[1][1], m[2][2]};
}

} // namespace brickwall
