// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/LevelBoxes.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace brickwall {

/// One field in one box of a file, as a format's reader gives access to it. Each is used by one thread.
class BoxReader
{
public:
    virtual ~BoxReader() = default;

    /// File and place in it, for messages about values.
    virtual std::string place() const = 0;
    /// The box whose values `read` yields, in its level's indices: that of the job, and ghost cells if there are any.
    virtual Box3i box() const = 0;
    /// How many values to ask for at a time, if planes have fewer. A cheap read is best done in what fits a core's
    /// cache.
    virtual std::int64_t slabValues() const { return std::int64_t(1) << 18; }
    /// The values of the planes zBegin <= z < zEnd of `box()`, x fastest. Throws Error.
    virtual void read(int zBegin, int zEnd, std::vector<double>& values) = 0;
};

/// Makes the reader of one field in the box of a job. Called from several threads at once.
using OpenBox = std::function<std::unique_ptr<BoxReader>(const LeafJob& job)>;

/// Reads one field box by box, a few planes at a time: memory is the field's values and, for each thread, one slab of
/// planes and what the BoxReader keeps. Progress counts cells. Throws Error for values that are not finite as float
/// (`nonFinite` = error), what `open` and the readers throw, and Cancelled.
Field readLeafField(const LeafPlan& plan, const std::string& name, const OpenBox& open, NonFinite nonFinite,
                    const Executor& executor, Progress& progress);

/// The model of a plan whose fields have been read: notes what was left out, leaves out non-finite cells if asked for,
/// and checks the result. `place` is the file or folder for messages.
Model leafModel(LeafPlan plan, std::vector<Field> fields, const mat4d& worldFromVoxel, const std::string& place,
                NonFinite nonFinite, const Executor& executor, Progress& progress);

/// "velmag", "magvel", "speed", "density", "dens", "rho", whichever comes first in this list, else the first name.
/// Empty without names.
std::string usualField(const std::vector<std::string>& names);

} // namespace brickwall
