// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// Bricks of an ExaBrick data set, and for each value slot of the model the cell ID, which is the index of its value in
/// every
/// `.scalars` file.
///
/// The IDs of the first fileOffsets.size() bricks stay in the file and are streamed for each field, so that memory
/// holds little beside the fields; those of the remaining bricks are in storedIds.
struct ExaGeometry
{
    std::string place; ///< the .bricks or .cells file
    std::vector<Brick> bricks;
    std::uint64_t cellCount = 0;
    std::vector<std::string> notes;

    std::shared_ptr<InputFile> idFile;
    std::vector<std::uint64_t> fileOffsets; ///< of a brick's first ID, in bytes
    std::vector<std::uint64_t> records;     ///< a brick's number in the file
    std::vector<std::uint32_t> storedIds;

    /// Calls body(first slot, IDs) for pieces that together are all slots, from any thread.
    void forEachId(const Executor& executor, Progress& progress,
                   const std::function<void(std::uint64_t, std::span<const std::uint32_t>)>& body) const;

    /// "cell (1,0,2) of brick 3, at voxel (8,0,16) of level 1", for messages.
    std::string describe(std::uint64_t slot) const;
};

/// Reads `.bricks`: records of int32 size[3], lower[3], level, IDs[size.x * size.y * size.z], little-endian, up to the
/// end of the file. ID -1 is an empty cell: what else its brick has is carved into full bricks, and counted in the
/// notes.
ExaGeometry readBricks(const std::string& path, const Executor& executor, Progress& progress);

/// Reads `.cells`: records of int32 lower[3], level. The ID of a cell is the number of its record.
ExaGeometry readCells(const std::string& path, const Executor& executor, Progress& progress);

/// Error unless the first record of the file makes sense; these formats have no magic number.
void checkFirstBrick(const std::string& path);
void checkFirstCell(const std::string& path);

/// Reads `.tris`: meshes of int32 count, float32 vertices[3 * count], int32 count, int32 triangles[3 * count].
std::vector<TriangleMesh> readTriangles(const std::string& path, Progress& progress);

} // namespace brickwall
