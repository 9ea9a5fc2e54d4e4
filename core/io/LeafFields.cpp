// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/LeafFields.h"

#include "brickwall/core/io/EmptyCells.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/model/CheckModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <mutex>
#include <utility>

namespace brickwall {
namespace {

/// Narrows a row to float; false if a value is not finite as one. Compares bits, as compilers turn that into lanes.
bool narrow(const double* in, int count, float* out)
{
    constexpr std::uint32_t magnitude = 0x7fffffff, infinite = 0x7f800000;
    std::uint32_t largest = 0;
    for (int i = 0; i < count; ++i) {
        out[i] = static_cast<float>(in[i]);
        largest = std::max(largest, std::bit_cast<std::uint32_t>(out[i]) & magnitude);
    }
    return largest < infinite;
}

Range rangeInParallel(std::span<const float> values, const Executor& executor)
{
    Range range;
    std::mutex mutex;
    executor.forEach(values.size(), std::size_t(1) << 20, [&](std::size_t begin, std::size_t end) {
        const Range part = rangeOf(values.subspan(begin, end - begin));
        const std::lock_guard lock(mutex);
        range.extend(part);
    });
    return range;
}

class FieldReader
{
public:
    FieldReader(const LeafPlan& plan, const std::string& name, const OpenBox& open, NonFinite nonFinite)
        : plan_(plan), name_(name), open_(open), nonFinite_(nonFinite)
    {
    }

    /// In slabs of planes, which bounds memory and the time until Progress::check. `slab` is reused from job to job.
    void readJob(const LeafJob& job, std::vector<double>& slab, std::vector<float>& values, Progress& progress) const
    {
        constexpr std::int64_t slabValues = 1 << 18;
        const auto reader = open_(job);
        const Box3i box = reader->box();
        Box3i needed;
        for (std::size_t p = job.firstPiece; p < job.endPiece; ++p)
            needed.extend(plan_.pieces[p].cells);
        const std::int64_t planeValues = std::int64_t(box.extent().x) * box.extent().y;
        const int planes = static_cast<int>(std::clamp<std::int64_t>(slabValues / planeValues, 1, needed.extent().z));
        for (int z = needed.lower.z; z < needed.upper.z; z += planes) {
            progress.check();
            Box3i slabBox = box;
            slabBox.lower.z = z;
            slabBox.upper.z = std::min(z + planes, needed.upper.z);
            reader->read(slabBox.lower.z, slabBox.upper.z, slab);
            for (std::size_t p = job.firstPiece; p < job.endPiece; ++p) {
                const Box3i cells = plan_.pieces[p].cells.intersection(slabBox);
                copy(cells, slab, slabBox, plan_.bricks[plan_.pieces[p].brick], values, *reader);
                progress.advance(static_cast<std::uint64_t>(volume(cells)));
            }
        }
    }

private:
    /// The values of these cells, in the level's indices, which the slab and the brick hold all.
    void copy(const Box3i& c, const std::vector<double>& slab, const Box3i& slabBox, const Brick& brick,
              std::vector<float>& values, const BoxReader& reader) const
    {
        const vec3i origin = brick.lower / brick.cellWidth();
        const vec3i size = slabBox.extent();
        for (int z = c.lower.z; z < c.upper.z; ++z)
            for (int y = c.lower.y; y < c.upper.y; ++y) {
                const std::size_t inRow = std::size_t(z - slabBox.lower.z) * size.y + (y - slabBox.lower.y);
                const double* in = slab.data() + inRow * size.x + (c.lower.x - slabBox.lower.x);
                const std::uint64_t outRow = std::uint64_t(z - origin.z) * brick.size.y + (y - origin.y);
                float* out = values.data() + brick.begin + outRow * brick.size.x + (c.lower.x - origin.x);
                const int count = c.upper.x - c.lower.x;
                if (!narrow(in, count, out) && nonFinite_ == NonFinite::error)
                    failAt(in, out, {c.lower.x, y, z}, reader);
            }
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
    field.values.resize(plan.cellCount);
    const FieldReader reader(plan, name, open, nonFinite);
    executor.forEach(plan.jobs.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<double> slab;
        for (std::size_t j = begin; j < end; ++j) {
            progress.check();
            reader.readJob(plan.jobs[j], slab, field.values, progress);
        }
    });
    field.range = rangeInParallel(field.values, executor);
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
    checkModel(model, place);
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
