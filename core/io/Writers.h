// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/CellSelection.h"
#include "brickwall/core/io/OutputFiles.h"
#include "brickwall/core/model/Model.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// What a writer is told before the first field.
struct Output
{
    std::string path;   ///< the file that a user opens
    const Model& model; ///< name, transform, meshes; its fields are not looked at
    const CellSelection& cells;
    std::vector<std::string> fieldNames; ///< of all fields that will come, in their order
    bool compress = false;
};

/// Writes one data set, field by field, into files that `OutputFiles` names. Memory: a block of cells for each thread,
/// if its class does not say otherwise. Throws Error, naming the file, and Cancelled.
class Writer
{
public:
    virtual ~Writer() = default;

    /// The next field.
    virtual void write(const SelectedValues& values, const Executor& executor, Progress& progress) = 0;
    /// All fields are there: writes what is left and closes all files.
    virtual void finish() = 0;
};

/// May write the geometry at once; the output lives longer than the writer.
using MakeWriter = std::unique_ptr<Writer> (*)(const Output& output, OutputFiles& files, const Executor& executor,
                                               Progress& progress);

struct TargetFormat
{
    std::string extension; ///< of the file that a user opens, ".exa"
    std::string name;      ///< for people
    MakeWriter make;
};

/// All formats that can be written.
std::span<const TargetFormat> targetFormats();

// One file each.
std::unique_ptr<Writer> makeExaWriter(const Output&, OutputFiles&, const Executor&, Progress&);
std::unique_ptr<Writer> makeVdbWriter(const Output&, OutputFiles&, const Executor&, Progress&);
std::unique_ptr<Writer> makeVthbWriter(const Output&, OutputFiles&, const Executor&, Progress&);
std::unique_ptr<Writer> makeCacheWriter(const Output&, OutputFiles&, const Executor&, Progress&);

/// How many cells a writer takes at a time.
inline constexpr std::size_t cellsAtOnce = 1 << 16;

/// Calls body(brick, first cell of it, values) for pieces of at most cellsAtOnce cells that together are all chosen
/// ones, bricks side by side, the pieces of a brick in their order; counts cells as progress.
void forEachPiece(const CellSelection& cells, const SelectedValues& values, const Executor& executor,
                  Progress& progress,
                  const std::function<void(std::size_t brick, std::uint64_t first, std::span<const float>)>& body);

/// A field's name as part of a file's: what is no letter, digit, '.', '-' or '_' becomes '_'.
std::string fileNamePart(const std::string& name);

/// The widths of voxels along the axes; an Error at `place` if the model's axes are not those of the world, or run the
/// other way: `format` has no place for that.
vec3d voxelWidths(const Model& model, const std::string& format, const std::string& place);

} // namespace brickwall
