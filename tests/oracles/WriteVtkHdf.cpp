// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/WriteVtkHdf.h"

#include "brickwall/tests/oracles/WriteHdf5.h"

#include <fmt/format.h>

#include <cmath>

namespace brickwall::oracles {
namespace {

/// The values of an array on a level, box after box; `first` is the oracle's number of its first component.
std::vector<double> arrayValues(const VtkAmr3& amr, std::size_t level, const VtkArray& array, int first)
{
    std::vector<double> values;
    for (const Box3i& b : amr.boxes[level])
        for (int z = b.lower.z; z < b.upper.z; ++z)
            for (int y = b.lower.y; y < b.upper.y; ++y)
                for (int x = b.lower.x; x < b.upper.x; ++x)
                    for (int c = 0; c < array.components; ++c)
                        values.push_back(amr.value(static_cast<int>(level), first + c, {x, y, z}));
    return values;
}

void writeArrays(Hdf5Writer& file, const std::vector<VtkAmr3>& steps, std::size_t level, const std::string& group,
                 const std::string& offsetGroup)
{
    int first = 0;
    for (const VtkArray& array : steps[0].arrays) {
        const auto components = static_cast<std::uint64_t>(array.components);
        std::vector<double> values, offsets;
        for (const VtkAmr3& step : steps) {
            offsets.push_back(double(values.size() / components));
            const std::vector<double> more = arrayValues(step, level, array, first);
            values.insert(values.end(), more.begin(), more.end());
        }
        std::vector<std::uint64_t> shape{values.size() / components};
        if (components > 1)
            shape.push_back(components);
        file.numbers(group + "/CellData/" + array.name, shape, values,
                     array.type == "Float32" ? Hdf5Number::float32 : Hdf5Number::float64);
        if (steps.size() > 1)
            file.numbers(offsetGroup + "/" + array.name, {offsets.size()}, offsets, Hdf5Number::int64);
        first += array.components;
    }
}

void writeLevel(Hdf5Writer& file, const std::vector<VtkAmr3>& steps, std::size_t level, const vec3d& spacing,
                const std::string& s)
{
    const std::string group = fmt::format("VTKHDF/Level{}", level),
                      stepGroup = fmt::format("VTKHDF/Steps/Level{}", level);
    const std::string offsetGroup = stepGroup + "/CellDataOffset" + s;
    file.group(group);
    file.attribute(group, "Spacing", {spacing.x, spacing.y, spacing.z});
    std::vector<double> boxes, counts, firsts;
    for (const VtkAmr3& step : steps) {
        firsts.push_back(double(boxes.size() / 6));
        counts.push_back(double(step.boxes[level].size()));
        for (const Box3i& b : step.boxes[level])
            for (int axis = 0; axis < 3; ++axis) {
                boxes.push_back(b.lower[axis]);
                boxes.push_back(b.upper[axis] - 1);
            }
    }
    file.numbers(group + "/AMRBox", {boxes.size() / 6, 6}, boxes, Hdf5Number::int32);
    file.group(group + "/CellData");
    if (steps.size() > 1) {
        file.group(stepGroup);
        file.group(offsetGroup);
        file.numbers(stepGroup + "/AMRBoxOffset" + s, {firsts.size()}, firsts, Hdf5Number::int64);
        file.numbers(stepGroup + (s.empty() ? "/NumberOfAMRBox" : "/NumberOfAMRBoxes"), {counts.size()}, counts,
                     Hdf5Number::int64);
    }
    writeArrays(file, steps, level, group, offsetGroup);
}

} // namespace

void writeVtkHdf(const std::string& path, const std::vector<VtkAmr3>& steps, double version)
{
    const std::string s = version == 2.2 ? "" : "s";
    Hdf5Writer file(path);
    file.group("VTKHDF");
    file.attribute("VTKHDF", "Version", {std::floor(version), std::round(10.0 * (version - std::floor(version)))},
                   Hdf5Number::int64);
    file.textAttribute("VTKHDF", "Type", "OverlappingAMR");
    file.textAttribute("VTKHDF", "GridDescription", "XYZ");
    const vec3d origin = steps[0].origin;
    file.attribute("VTKHDF", "Origin", {origin.x, origin.y, origin.z});
    if (steps.size() > 1) {
        std::vector<double> times;
        for (std::size_t i = 0; i < steps.size(); ++i)
            times.push_back(0.5 * double(i));
        file.group("VTKHDF/Steps");
        file.attribute("VTKHDF/Steps", "NSteps", {double(steps.size())}, Hdf5Number::int64);
        file.numbers("VTKHDF/Steps/Values", {times.size()}, times);
    }
    vec3d spacing = steps[0].spacing;
    for (std::size_t level = 0; level < steps[0].boxes.size(); ++level) {
        writeLevel(file, steps, level, spacing, s);
        if (level < steps[0].ratios.size())
            spacing /= double(steps[0].ratios[level]);
    }
}

} // namespace brickwall::oracles
