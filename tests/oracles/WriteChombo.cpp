// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/WriteChombo.h"

#include "brickwall/tests/oracles/WriteHdf5.h"

#include <fmt/format.h>

#include <limits>

namespace brickwall::oracles {
namespace {

const std::vector<std::string> boxMembers{"lo_i", "lo_j", "lo_k", "hi_i", "hi_j", "hi_k"};
const std::vector<std::string> vectorMembers{"intvecti", "intvectj", "intvectk"};

void appendBox(const Chombo3& c, int level, const Box3i& box, std::vector<double>& values)
{
    const Box3i grown{box.lower - c.ghosts, box.upper + c.ghosts};
    for (int component = 0; component < static_cast<int>(c.components.size()); ++component)
        for (int z = grown.lower.z; z < grown.upper.z; ++z)
            for (int y = grown.lower.y; y < grown.upper.y; ++y)
                for (int x = grown.lower.x; x < grown.upper.x; ++x) {
                    const vec3i cell(x, y, z);
                    values.push_back(box.contains(cell) ? c.value(level, component, cell)
                                                        : std::numeric_limits<double>::quiet_NaN());
                }
}

/// Every level of PLUTO says where the domain begins.
void writePluto(Hdf5Writer& file, const Chombo3& c, const std::string& group)
{
    for (std::size_t axis = 0; axis < c.plutoOrigin.size(); ++axis)
        file.attribute(group, fmt::format("domBeg{}", axis + 1), {c.plutoOrigin[axis]});
    for (std::size_t i = 0; i < c.plutoStretch.size(); ++i)
        file.attribute(group, fmt::format("g_x{}stretch", i + 2), {c.plutoStretch[i]});
    if (c.plutoOrigin.empty())
        return;
    file.attribute(group, "geometry", {double(c.plutoGeometry)}, Hdf5Number::int32);
    file.attribute(group, "logr", {0}, Hdf5Number::int32);
}

void writeLevel(Hdf5Writer& file, const Chombo3& c, int level, double cellSize)
{
    const std::string group = fmt::format("level_{}", level);
    const auto index = static_cast<std::size_t>(level);
    const int ratio = index < c.ratios.size() ? c.ratios[index] : 1;
    file.group(group);
    file.attribute(group, "dx", {cellSize});
    if (c.vectorRatios)
        file.recordAttribute(group, "vec_ref_ratio", vectorMembers, {ratio, ratio, ratio});
    else
        file.attribute(group, "ref_ratio", {double(ratio)}, Hdf5Number::int32);
    writePluto(file, c, group);
    std::vector<std::int64_t> boxes;
    std::vector<double> values, offsets{0};
    for (const Box3i& b : c.boxes[index]) {
        boxes.insert(boxes.end(), {b.lower.x, b.lower.y, b.lower.z, b.upper.x - 1, b.upper.y - 1, b.upper.z - 1});
        appendBox(c, level, b, values);
        offsets.push_back(double(values.size()));
    }
    file.records(group + "/boxes", boxMembers, boxes);
    file.numbers(group + "/data:datatype=0", {values.size()}, values,
                 c.floats ? Hdf5Number::float32 : Hdf5Number::float64);
    if (c.offsets)
        file.numbers(group + "/data:offsets=0", {offsets.size()}, offsets, Hdf5Number::int64);
    const std::string attributes = group + "/data_attributes";
    file.group(attributes);
    file.attribute(attributes, "comps", {double(c.components.size())}, Hdf5Number::int32);
    file.textAttribute(attributes, "objectType", "FArrayBox");
    file.recordAttribute(attributes, "ghost", vectorMembers, {3, 3, 3}); // in the code's memory
    if (c.outputGhost)
        file.recordAttribute(attributes, "outputGhost", vectorMembers, {c.ghosts.x, c.ghosts.y, c.ghosts.z});
}

} // namespace

void writeChombo(const std::string& path, const Chombo3& chombo)
{
    Hdf5Writer file(path);
    file.group("Chombo_global");
    file.attribute("Chombo_global", "SpaceDim", {3}, Hdf5Number::int32);
    file.attribute("", "num_levels", {double(chombo.boxes.size())}, Hdf5Number::int32);
    file.attribute("", "num_components", {double(chombo.components.size())}, Hdf5Number::int32);
    for (std::size_t i = 0; i < chombo.components.size(); ++i)
        file.textAttribute("", fmt::format("component_{}", i), chombo.components[i]);
    double cellSize = chombo.cellSize;
    for (std::size_t level = 0; level < chombo.boxes.size(); ++level) {
        writeLevel(file, chombo, static_cast<int>(level), cellSize);
        if (level < chombo.ratios.size())
            cellSize /= chombo.ratios[level];
    }
}

} // namespace brickwall::oracles
