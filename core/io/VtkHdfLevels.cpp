// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VtkHdfLevels.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

constexpr std::uint64_t boxesAtATime = 1 << 13; // as a list that means harm may be long
const std::string root = "VTKHDF", steps = "VTKHDF/Steps";

std::string groupOf(std::size_t level)
{
    return fmt::format("{}/Level{}", root, level);
}

std::string stepsOf(std::size_t level)
{
    return fmt::format("{}/Level{}", steps, level);
}

vec3d triple(const Hdf5File& file, const std::string& object, const std::string& attribute)
{
    const std::vector<double> n = file.numbers(object, attribute);
    if (n.size() != 3 || !std::isfinite(n[0] + n[1] + n[2]))
        throw Error(fmt::format("{}: attribute '{}' of /{}", file.path(), attribute, object),
                    fmt::format("expected three numbers, found {}", fmt::join(n, ", ")));
    return {n[0], n[1], n[2]};
}

std::size_t levelCount(const Hdf5File& file)
{
    std::size_t count = 0, groups = 0;
    while (file.has(groupOf(count)))
        ++count;
    for (const std::string& member : file.members(root))
        groups += member.starts_with("Level") ? 1 : 0;
    if (count == 0 || groups != count)
        throw Error(file.path(), fmt::format("expected the levels Level0, Level1 and so on, found {} such groups, but "
                                             "no {}",
                                             groups, groupOf(count)));
    return count;
}

/// What a list of a level has for a step. Version 2.2 of the format lacked an "s" in the lists' names.
std::uint64_t stepValue(const Hdf5File& file, const std::string& list, const std::string& oldList, std::int64_t step)
{
    const Hdf5Data data = file.data(file.has(oldList) ? oldList : list);
    const std::vector<std::int64_t> values = data.integers();
    if (static_cast<std::uint64_t>(step) >= values.size())
        throw Error(data.place(), fmt::format("expected a number for step {}, found {} numbers", step, values.size()));
    const std::int64_t value = values[static_cast<std::size_t>(step)];
    if (value < 0)
        throw Error(data.place(), fmt::format("expected no negative number, found {} for step {}", value, step));
    return static_cast<std::uint64_t>(value);
}

/// AMRBox has the lowest and highest index of each box along x, along y, along z.
Box3i boxOf(const double* n, std::size_t index, const std::string& place)
{
    const vec3d low(n[0], n[2], n[4]), high(n[1], n[3], n[5]);
    if (high.z < low.z && high.x >= low.x && high.y >= low.y)
        throw Error(place,
                    fmt::format("box {}: expected data of three dimensions, found a box without cells along z", index));
    for (int axis = 0; axis < 3; ++axis)
        if (!(low[axis] <= high[axis] && low[axis] >= -coordinateLimit && high[axis] < coordinateLimit))
            throw Error(place, fmt::format("box {}: expected indices from low to high within +-{}, found {} to {} "
                                           "along {}",
                                           index, coordinateLimit, low[axis], high[axis], "xyz"[axis]));
    return {vec3i(low), vec3i(high) + 1};
}

std::vector<Box3i> readBoxes(const Hdf5File& file, std::size_t level, std::int64_t step)
{
    const Hdf5Data data = file.data(groupOf(level) + "/AMRBox");
    const std::uint64_t shape[]{0, 6};
    data.expectShape(shape);
    std::uint64_t first = 0, count = data.shape()[0];
    if (file.has(steps)) {
        const std::string group = stepsOf(level);
        first = stepValue(file, group + "/AMRBoxOffsets", group + "/AMRBoxOffset", step);
        count = stepValue(file, group + "/NumberOfAMRBoxes", group + "/NumberOfAMRBox", step);
    }
    std::vector<double> numbers;
    std::vector<Box3i> boxes;
    while (boxes.size() < count) {
        const std::uint64_t start[]{first + boxes.size(), 0};
        const std::uint64_t extent[]{std::min<std::uint64_t>(boxesAtATime, count - boxes.size()), 6};
        data.read(start, extent, numbers);
        for (const double* n = numbers.data(); n < numbers.data() + numbers.size(); n += 6)
            boxes.push_back(boxOf(n, boxes.size(), data.place()));
    }
    return boxes;
}

/// The ratio of two levels' cell sizes, the same along all axes.
int ratioOf(const vec3d& coarse, const vec3d& fine, const std::string& place)
{
    const vec3d ratios = coarse / fine;
    const double ratio = std::round(ratios.x);
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(ratios[axis] - ratio) < 1e-3 && ratio >= 1.0 && ratio < 1e6))
            throw Error(place, fmt::format("expected a whole number of times finer cells than on the level before, the "
                                           "same along all axes, found {}, {} and {} times",
                                           ratios.x, ratios.y, ratios.z));
    return static_cast<int>(ratio);
}

} // namespace

std::vector<ArrayField> readVtkHdfFields(const Hdf5File& file)
{
    levelCount(file);
    const std::string group = groupOf(0) + "/CellData";
    std::vector<ArrayField> fields;
    for (const std::string& array : file.members(group)) {
        if (array == "vtkGhostType")
            continue; // which cells are covered: found out from the boxes
        const Hdf5Data data = file.data(group + "/" + array);
        const std::vector<std::uint64_t>& shape = data.shape();
        const std::uint64_t components = shape.size() == 2 ? shape[1] : 1;
        if (shape.empty() || shape.size() > 2 || components < 1 || components > 64)
            throw Error(data.place(), fmt::format("expected values of cells, with 1 to 64 components, found the shape "
                                                  "{}",
                                                  shapeText(shape)));
        appendArrayFields(array, static_cast<int>(components), fields);
    }
    if (fields.empty())
        throw Error(fmt::format("{}: /{}", file.path(), group),
                    file.members(groupOf(0) + "/PointData").empty()
                        ? "expected values of cells, found none"
                        : "expected values of cells, found those of points alone, which are not read");
    return fields;
}

std::int64_t vtkHdfStepCount(const Hdf5File& file)
{
    return file.has(steps) ? file.integer(steps, "NSteps", 1, std::int64_t(1) << 31) : 1;
}

double vtkHdfTime(const Hdf5File& file, std::int64_t step)
{
    if (!file.has(steps + "/Values"))
        return 0.0;
    const std::vector<double> times = file.data(steps + "/Values").numbers();
    return static_cast<std::size_t>(step) < times.size() ? times[static_cast<std::size_t>(step)] : 0.0;
}

VtkHdfLevels readVtkHdfLevels(const Hdf5File& file, std::int64_t step)
{
    VtkHdfLevels levels;
    std::vector<vec3d> spacing;
    std::vector<int> ratios;
    const std::size_t count = levelCount(file);
    for (std::size_t i = 0; i < count && (i == 0 || !file.has(steps) || file.has(stepsOf(i))); ++i) {
        const std::string group = groupOf(i), place = fmt::format("{}: attribute 'Spacing' of /{}", file.path(), group);
        spacing.push_back(triple(file, group, "Spacing"));
        if (!glm::all(glm::greaterThan(spacing[i], vec3d(0.0))))
            throw Error(place, fmt::format("expected positive numbers, found {}, {} and {}", spacing[i].x, spacing[i].y,
                                           spacing[i].z));
        if (i > 0)
            ratios.push_back(ratioOf(spacing[i - 1], spacing[i], place));
        levels.groups.push_back(group);
        levels.boxes.push_back({fmt::format("{}: /{}/AMRBox", file.path(), group), 0, readBoxes(file, i, step)});
    }
    const std::vector<int> numbers = levelNumbers(ratios, file.path());
    for (std::size_t i = 0; i < levels.boxes.size(); ++i)
        levels.boxes[i].level = numbers[i];
    levels.worldFromVoxel = worldFromIndices(triple(file, root, "Origin"), vec3i(0), spacing.back());
    return levels;
}

VtkHdfArray openVtkHdfArray(const Hdf5File& file, const VtkHdfLevels& levels, std::size_t level,
                            const ArrayField& field, std::int64_t step)
{
    VtkHdfArray out{file.data(fmt::format("{}/CellData/{}", levels.groups[level], field.array)), {}};
    const std::vector<std::uint64_t>& shape = out.values.shape();
    const std::uint64_t components = shape.size() == 2 ? shape[1] : 1;
    if (shape.empty() || shape.size() > 2 || components != static_cast<std::uint64_t>(field.components))
        throw Error(out.values.place(), fmt::format("expected {} components, as Level0 has, found the shape {}",
                                                    field.components, shapeText(shape)));
    double end = 0.0;
    if (file.has(steps)) {
        const std::string group = stepsOf(level);
        end = double(
            stepValue(file, group + "/CellDataOffsets/" + field.array, group + "/CellDataOffset/" + field.array, step));
    }
    for (std::size_t i = 0; i < levels.boxes[level].boxes.size(); ++i) {
        const vec3d size(levels.boxes[level].boxes[i].extent());
        out.offsets.push_back(static_cast<std::uint64_t>(end));
        end += size.x * size.y * size.z;
        if (end > double(shape[0]))
            throw Error(out.values.place(), fmt::format("truncated: box {} needs the values {} to {}, but there are {}",
                                                        i, out.offsets.back(), end, shape[0]));
    }
    return out;
}

} // namespace brickwall
