// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ChomboLevels.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

const std::vector<std::string> boxMembers{"lo_i", "lo_j", "lo_k", "hi_i", "hi_j", "hi_k"};
constexpr std::uint64_t boxesAtATime = 1 << 13; // as a list that means harm may be long
const std::vector<std::string> vectorMembers{"intvecti", "intvectj", "intvectk"};

std::string groupOf(std::size_t level)
{
    return fmt::format("level_{}", level);
}

std::size_t levelCount(const Hdf5File& file)
{
    return static_cast<std::size_t>(file.integer("", "num_levels", 1, 64));
}

std::vector<Box3i> readBoxes(const Hdf5File& file, const std::string& dataset)
{
    const Hdf5Data data = file.data(dataset);
    std::vector<Box3i> boxes;
    while (boxes.size() < data.size()) {
        const std::uint64_t count = std::min<std::uint64_t>(boxesAtATime, data.size() - boxes.size());
        const std::vector<std::int32_t> numbers = data.records(boxMembers, boxes.size(), count);
        for (const std::int32_t* n = numbers.data(); n < numbers.data() + numbers.size(); n += 6) {
            const auto [least, most] = std::minmax_element(n, n + 6);
            if (n[3] < n[0] || n[4] < n[1] || n[5] < n[2] || *least < -coordinateLimit || *most >= coordinateLimit)
                throw Error(data.place(),
                            fmt::format("box {}: expected indices from low to high within +-{}, found ({},{},{}) to "
                                        "({},{},{})",
                                        boxes.size(), coordinateLimit, n[0], n[1], n[2], n[3], n[4], n[5]));
            boxes.push_back({vec3i(n[0], n[1], n[2]), vec3i(n[3] + 1, n[4] + 1, n[5] + 1)});
        }
    }
    return boxes;
}

/// To the next finer level. Some codes have a ratio for each axis.
int readRatio(const Hdf5File& file, const std::string& group)
{
    if (!file.hasAttribute(group, "vec_ref_ratio"))
        return static_cast<int>(file.integer(group, "ref_ratio", 1, 1 << 20));
    const std::vector<std::int32_t> ratios = file.record(group, "vec_ref_ratio", vectorMembers);
    const std::int32_t ratio = ratios[0];
    if (ratios[1] != ratio || ratios[2] != ratio || ratio < 1 || ratio > 1 << 20)
        throw Error(
            fmt::format("{}: attribute 'vec_ref_ratio' of /{}", file.path(), group),
            fmt::format("expected the same ratio along all axes, found {}, {} and {}", ratio, ratios[1], ratios[2]));
    return static_cast<int>(ratio);
}

double readCellSize(const Hdf5File& file, const std::string& group)
{
    const std::vector<double> dx = file.numbers(group, "dx");
    if (dx.size() != 1 || !(dx[0] > 0.0) || !std::isfinite(dx[0]))
        throw Error(fmt::format("{}: attribute 'dx' of /{}", file.path(), group),
                    fmt::format("expected one positive cell size, found {}",
                                dx.size() == 1 ? fmt::format("{}", dx[0]) : fmt::format("{} numbers", dx.size())));
    return dx[0];
}

double numberOr(const Hdf5File& file, const std::string& attribute, double otherwise)
{
    const std::string group = groupOf(0);
    if (!file.hasAttribute(group, attribute))
        return otherwise;
    const std::vector<double> numbers = file.numbers(group, attribute);
    if (numbers.size() != 1 || !std::isfinite(numbers[0]))
        throw Error(fmt::format("{}: attribute '{}' of /{}", file.path(), attribute, group), "expected one number");
    return numbers[0];
}

/// PLUTO says what its coordinates are, by number. Other codes have no other than Cartesian ones.
void checkGeometry(const Hdf5File& file)
{
    if (!file.hasAttribute(groupOf(0), "domBeg1"))
        return;
    if (const double geometry = numberOr(file, "geometry", 1.0); geometry != 1.0)
        throw Error(fmt::format("{}: attribute 'geometry' of /{}", file.path(), groupOf(0)),
                    fmt::format("expected 1, Cartesian coordinates, found {}", geometry));
    if (const double logarithmic = numberOr(file, "logr", 0.0); logarithmic != 0.0)
        throw Error(fmt::format("{}: attribute 'logr' of /{}", file.path(), groupOf(0)),
                    fmt::format("expected 0, cells of one size, found {}", logarithmic));
}

/// Where index 0 is: `domBeg1` to `domBeg3` of PLUTO, `prob_lo` of others, else the origin.
vec3d readOrigin(const Hdf5File& file)
{
    if (file.hasAttribute(groupOf(0), "domBeg1"))
        return {numberOr(file, "domBeg1", 0.0), numberOr(file, "domBeg2", 0.0), numberOr(file, "domBeg3", 0.0)};
    for (const std::string& object : {std::string(), std::string("Chombo_global"), groupOf(0)})
        if (file.hasAttribute(object, "prob_lo")) {
            const std::vector<double> p = file.numbers(object, "prob_lo");
            if (p.size() != 3 || !std::isfinite(p[0] + p[1] + p[2]))
                throw Error(fmt::format("{}: attribute 'prob_lo' of /{}", file.path(), object),
                            fmt::format("expected three numbers, found {}", fmt::join(p, ", ")));
            return {p[0], p[1], p[2]};
        }
    return vec3d(0.0);
}

/// PLUTO's cells may be wider along y and z, by these factors.
vec3d readStretch(const Hdf5File& file)
{
    const vec3d stretch(1.0, numberOr(file, "g_x2stretch", 1.0), numberOr(file, "g_x3stretch", 1.0));
    if (!glm::all(glm::greaterThan(stretch, vec3d(0.0))))
        throw Error(fmt::format("{}: attributes 'g_x2stretch', 'g_x3stretch' of /{}", file.path(), groupOf(0)),
                    fmt::format("expected positive numbers, found {} and {}", stretch.y, stretch.z));
    return stretch;
}

/// The names of the root's attributes component_0, component_1 ...
std::vector<std::string> componentNames(const Hdf5File& file)
{
    std::vector<std::string> names;
    if (file.hasAttribute("", "num_components"))
        for (std::int64_t i = 0, count = file.integer("", "num_components", 1, 65536); i < count; ++i)
            names.push_back(file.text("", fmt::format("component_{}", i)));
    return names;
}

/// A checkpoint has an array for each variable: a vector's components are named x, y, z and its name, if the root has
/// such names, else numbered.
std::string nameOf(const std::string& array, std::int64_t component, std::int64_t count,
                   const std::vector<std::string>& known)
{
    if (count == 1)
        return array;
    const std::string xyz = component < 3 ? std::string(1, "xyz"[component]) + array : std::string();
    return std::find(known.begin(), known.end(), xyz) != known.end() ? xyz : fmt::format("{}_{}", array, component);
}

std::uint64_t valuesOf(const Box3i& box, const vec3i& ghosts, std::int64_t components, const std::string& place)
{
    const vec3d size = vec3d(box.extent()) + 2.0 * vec3d(ghosts);
    const double values = size.x * size.y * size.z * double(components);
    if (values >= 9e15)
        throw Error(place, fmt::format("expected boxes whose values can be counted, found one of {}", values));
    return static_cast<std::uint64_t>(values);
}

vec3i ghostsOf(const Hdf5File& file, const std::string& attributes, const std::string& name)
{
    if (!file.hasAttribute(attributes, name))
        return vec3i(0);
    const std::vector<std::int32_t> g = file.record(attributes, name, vectorMembers);
    if (*std::min_element(g.begin(), g.end()) < 0 || *std::max_element(g.begin(), g.end()) > 1024)
        throw Error(fmt::format("{}: attribute '{}' of /{}", file.path(), name, attributes),
                    fmt::format("expected 0 to 1024 ghost cells, found {}, {} and {}", g[0], g[1], g[2]));
    return {g[0], g[1], g[2]};
}

} // namespace

std::vector<ChomboField> readChomboFields(const Hdf5File& file)
{
    const std::int64_t dimensions = file.integer("Chombo_global", "SpaceDim", 1, 16);
    if (dimensions != 3)
        throw Error(file.path(), fmt::format("expected data of three dimensions, found {}", dimensions));
    const std::vector<std::string> known = componentNames(file);
    const std::string suffix = ":datatype=0", group = groupOf(0);
    std::vector<ChomboField> fields;
    for (const std::string& member : file.members(group)) {
        if (!member.ends_with(suffix))
            continue;
        const std::string array = member.substr(0, member.size() - suffix.size());
        const std::string attributes = fmt::format("{}/{}_attributes", group, array);
        if (file.hasAttribute(attributes, "objectType") && file.text(attributes, "objectType") != "FArrayBox")
            continue; // values on faces
        const std::int64_t count = file.integer(attributes, "comps", 1, 65536);
        const bool all = array == "data" && known.size() == static_cast<std::size_t>(count);
        for (std::int64_t c = 0; c < count; ++c)
            fields.push_back({all ? known[static_cast<std::size_t>(c)] : nameOf(array, c, count, known), array, c});
    }
    if (fields.empty())
        throw Error(fmt::format("{}: /{}", file.path(), group), "expected values in cells, found no dataset "
                                                                "'data:datatype=0' or the like");
    return fields;
}

ChomboLevels readChomboLevels(const Hdf5File& file)
{
    checkGeometry(file);
    ChomboLevels levels;
    std::vector<int> ratios;
    std::vector<double> sizes;
    const std::size_t count = levelCount(file);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string group = groupOf(i), boxes = group + "/boxes";
        levels.groups.push_back(group);
        levels.boxes.push_back({fmt::format("{}: /{}", file.path(), boxes), 0, readBoxes(file, boxes)});
        sizes.push_back(readCellSize(file, group));
        if (i + 1 < count)
            ratios.push_back(readRatio(file, group));
    }
    const std::vector<int> numbers = levelNumbers(ratios, file.path());
    for (std::size_t i = 0; i < count; ++i) {
        levels.boxes[i].level = numbers[i];
        const double expected = std::ldexp(sizes.back(), numbers[i]);
        if (!(std::abs(sizes[i] - expected) <= 1e-6 * expected))
            throw Error(fmt::format("{}: attribute 'dx' of /{}", file.path(), levels.groups[i]),
                        fmt::format("expected {}, as the refinement ratios and the finest level's cells have it, "
                                    "found {}",
                                    expected, sizes[i]));
    }
    levels.worldFromVoxel = worldFromIndices(readOrigin(file), vec3i(0), sizes.back() * readStretch(file));
    return levels;
}

ChomboArray openChomboArray(const Hdf5File& file, const ChomboLevels& levels, std::size_t level,
                            const std::string& array)
{
    const std::string base = levels.groups[level] + "/" + array, attributes = base + "_attributes";
    const std::vector<Box3i>& boxes = levels.boxes[level].boxes;
    ChomboArray out{file.data(base + ":datatype=0"), file.integer(attributes, "comps", 1, 65536), vec3i(0), {}};
    std::vector<std::int64_t> offsets;
    if (file.has(base + ":offsets=0")) {
        const Hdf5Data data = file.data(base + ":offsets=0");
        const std::uint64_t expected[]{boxes.size() + 1};
        data.expectShape(expected);
        offsets = data.integers();
    }
    // What was written around the boxes; files without it say only how many ghost cells the code had in memory.
    const bool written = file.hasAttribute(attributes, "outputGhost");
    out.ghosts = ghostsOf(file, attributes, written ? "outputGhost" : "ghost");
    if (!written && !boxes.empty() && !offsets.empty() &&
        static_cast<std::uint64_t>(offsets[1]) - static_cast<std::uint64_t>(offsets[0]) ==
            valuesOf(boxes[0], vec3i(0), out.components, base))
        out.ghosts = vec3i(0);
    std::uint64_t end = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const std::uint64_t count = valuesOf(boxes[i], out.ghosts, out.components, out.values.place());
        const std::int64_t begin = offsets.empty() ? static_cast<std::int64_t>(end) : offsets[i];
        if (!offsets.empty() &&
            (begin < 0 || offsets[i + 1] < begin || static_cast<std::uint64_t>(offsets[i + 1] - begin) != count))
            throw Error(fmt::format("{}: /{}:offsets=0", file.path(), base),
                        fmt::format("box {}: expected {} values, {} components with {},{},{} ghost cells, found the "
                                    "offsets {} and {}",
                                    i, count, out.components, out.ghosts.x, out.ghosts.y, out.ghosts.z, begin,
                                    offsets[i + 1]));
        out.offsets.push_back(static_cast<std::uint64_t>(begin));
        end = static_cast<std::uint64_t>(begin) + count;
        if (end > out.values.size())
            throw Error(out.values.place(), fmt::format("truncated: box {} needs the values {} to {}, but there are {}",
                                                        i, begin, end, out.values.size()));
    }
    return out;
}

} // namespace brickwall
