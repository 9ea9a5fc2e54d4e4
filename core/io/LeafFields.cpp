// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/LeafFields.h"

#include "brickwall/core/base/LargeArray.h"
#include "brickwall/core/io/EmptyCells.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/model/CheckModel.h"
#include "brickwall/core/simd/NarrowRow.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>

namespace brickwall {
namespace {

class FieldReader
{
public:
    FieldReader(const LeafPlan& plan, const std::string& name, const OpenBox& open, NonFinite nonFinite)
        : plan_(plan), name_(name), open_(open), nonFinite_(nonFinite)
    {
    }

    /// In slabs of planes, which bounds memory and the time until Progress::check. `slab` is reused from job to job.
    OrderedRange readJob(const LeafJob& job, std::vector<double>& slab, std::vector<float>& values,
                         Progress& progress) const
    {
        OrderedRange range;
        const auto reader = open_(job);
        const Box3i box = reader->box();
        Box3i needed;
        for (std::size_t p = job.firstPiece; p < job.endPiece; ++p)
            needed.extend(plan_.pieces[p].cells);
        const std::int64_t planeValues = std::int64_t(box.extent().x) * box.extent().y;
        const int planes =
            static_cast<int>(std::clamp<std::int64_t>(reader->slabValues() / planeValues, 1, needed.extent().z));
        for (int z = needed.lower.z; z < needed.upper.z; z += planes) {
            progress.check();
            Box3i slabBox = box;
            slabBox.lower.z = z;
            slabBox.upper.z = std::min(z + planes, needed.upper.z);
            reader->read(slabBox.lower.z, slabBox.upper.z, slab);
            for (std::size_t p = job.firstPiece; p < job.endPiece; ++p) {
                const Box3i cells = plan_.pieces[p].cells.intersection(slabBox);
                range.extend(copy(cells, slab, slabBox, plan_.bricks[plan_.pieces[p].brick], values, *reader));
                progress.advance(static_cast<std::uint64_t>(volume(cells)));
            }
        }
        return range;
    }

private:
    /// The values of these cells, in the level's indices, which the slab and the brick hold all.
    OrderedRange copy(const Box3i& c, const std::vector<double>& slab, const Box3i& slabBox, const Brick& brick,
                      std::vector<float>& values, const BoxReader& reader) const
    {
        OrderedRange range;
        const vec3i origin = brick.lower / brick.cellWidth();
        const vec3i size = slabBox.extent();
        for (int z = c.lower.z; z < c.upper.z; ++z)
            for (int y = c.lower.y; y < c.upper.y; ++y) {
                const std::size_t inRow = std::size_t(z - slabBox.lower.z) * size.y + (y - slabBox.lower.y);
                const double* in = slab.data() + inRow * size.x + (c.lower.x - slabBox.lower.x);
                const std::uint64_t outRow = std::uint64_t(z - origin.z) * brick.size.y + (y - origin.y);
                float* out = values.data() + brick.begin + outRow * brick.size.x + (c.lower.x - origin.x);
                const int count = c.upper.x - c.lower.x;
                const OrderedRange row = narrowRow(in, count, out);
                if (!row.finite() && nonFinite_ == NonFinite::error)
                    failAt(in, out, {c.lower.x, y, z}, reader);
                range.extend(row);
            }
        return range;
    }

    [[noreturn]] void failAt(const double* in, const float* out, vec3i cell, const BoxReader& reader) const
    {
        while (std::isfinite(*out))
            ++in, ++out, ++cell.x;
        failNotFinite(*in, reader.place(), name_, fmt::format("cell ({},{},{})", cell.x, cell.y, cell.z));
    }

    const LeafPlan& plan_;
    const std::string& name_;
    const OpenBox& open_;
    NonFinite nonFinite_;
};

} // namespace

Field readLeafField(const LeafPlan& plan, const std::string& name, const OpenBox& open, NonFinite nonFinite,
                    const Executor& executor, Progress& progress)
{
    progress.begin(fmt::format("reading {}", name), plan.cellCount);
    Field field;
    field.name = name;
    field.values = makeLargeArray(plan.cellCount, executor);
    const FieldReader reader(plan, name, open, nonFinite);
    OrderedRange range;
    std::mutex mutex;
    executor.forEach(plan.jobs.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<double> slab;
        OrderedRange part;
        for (std::size_t j = begin; j < end; ++j) {
            progress.check();
            part.extend(reader.readJob(plan.jobs[j], slab, field.values, progress));
        }
        const std::lock_guard lock(mutex);
        range.extend(part);
    });
    field.range = range.range();
    progress.end();
    return field;
}

Model leafModel(LeafPlan plan, std::vector<Field> fields, const mat4d& worldFromVoxel, const std::string& place,
                NonFinite nonFinite, const Executor& executor, Progress& progress)
{
    Model model;
    model.name = stemOf(place);
    model.bricks = std::move(plan.bricks);
    model.fields = std::move(fields);
    model.worldFromVoxel = worldFromVoxel;
    model.cellCount = plan.cellCount;
    if (plan.coveredCells > 0)
        model.notes.push_back(fmt::format("{}: {} cells left out that finer levels cover", place, plan.coveredCells));
    if (nonFinite == NonFinite::empty)
        leaveOutNonFinite(model, place, executor, progress);
    for (const std::string& note : model.notes)
        progress.note(note);
    checkLayout(model, place); // readLeafField has looked at every value
    return model;
}

std::string usualField(const std::vector<std::string>& names)
{
    for (const char* usual : {"velmag", "magvel", "speed", "density", "dens", "rho"})
        if (std::find(names.begin(), names.end(), usual) != names.end())
            return usual;
    return names.empty() ? std::string() : names[0];
}

} // namespace brickwall
