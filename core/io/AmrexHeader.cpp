// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/AmrexHeader.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/Model.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace brickwall {
namespace {

constexpr std::int64_t indexLimit = std::int64_t(1) << 30; // sums and differences of indices stay ints

vec3i readIntVect(TextCursor& text, std::string_view what)
{
    vec3i v;
    text.expect("(", what);
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0)
            text.expect(",", what);
        v[axis] = static_cast<int>(text.integer(what, -indexLimit, indexLimit));
    }
    text.expect(")", what);
    return v;
}

/// Reading stays below the folder of the plotfile.
void checkInside(TextCursor& text, const std::string& path, const std::string& what)
{
    if (leadsOutside(path))
        throw Error(text.where(), fmt::format("expected {} within the plotfile, found '{}'", what, path));
}

vec3d readPoint(TextCursor& text, const std::string& what)
{
    vec3d p;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] = text.number(what);
    return p;
}

/// One ratio per level but the finest, or one for all; AMReX writes "2", others "(2,2,2)".
void readRatios(TextCursor& text, std::vector<AmrexLevel>& levels)
{
    std::vector<int> ratios;
    while (!text.nextIs("((") && ratios.size() < levels.size()) {
        const std::string where = text.where();
        const vec3i ratio = text.nextIs("(") ? readIntVect(text, "a refinement ratio")
                                             : vec3i(static_cast<int>(text.integer("a refinement ratio", 1, 1 << 20)));
        if (ratio != vec3i(ratio.x) || ratio.x < 2 || !std::has_single_bit(static_cast<unsigned>(ratio.x)))
            throw Error(
                where,
                fmt::format("expected a refinement ratio that is a power of two and the same along all axes, found "
                            "({},{},{})",
                            ratio.x, ratio.y, ratio.z));
        ratios.push_back(ratio.x);
    }
    const std::size_t steps = levels.size() - 1;
    if (ratios.size() != steps && !(ratios.size() == 1 && steps > 1))
        text.fail(fmt::format("{} refinement ratios, or one for all (there were {})", steps, ratios.size()));
    for (std::size_t i = 0; i < steps; ++i)
        levels[i].ratio = ratios.size() == 1 ? ratios[0] : ratios[i];
}

void readDomains(TextCursor& text, std::vector<AmrexLevel>& levels)
{
    for (std::size_t i = 0; i < levels.size(); ++i) {
        levels[i].domain = readAmrexBox(text);
        const Box3i& d = levels[i].domain;
        const int r = i > 0 ? levels[i - 1].ratio : 1;
        const Box3i coarse = i > 0 ? levels[i - 1].domain : d;
        for (int axis = 0; axis < 3; ++axis)
            if (std::int64_t(coarse.lower[axis]) * r != d.lower[axis] ||
                std::int64_t(coarse.upper[axis]) * r != d.upper[axis])
                throw Error(
                    text.where(),
                    fmt::format("the domain of level {} is not that of level {} refined by {}: expected {} to {} along "
                                "{}, found {} to {}",
                                i, i - 1, r, std::int64_t(coarse.lower[axis]) * r,
                                std::int64_t(coarse.upper[axis]) * r - 1, "xyz"[axis], d.lower[axis],
                                d.upper[axis] - 1));
    }
}

void readCellSizes(TextCursor& text, std::vector<AmrexLevel>& levels)
{
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const std::string where = text.where();
        const vec3d dx = levels[i].cellSize = readPoint(text, fmt::format("the cell size of level {}", i));
        for (int axis = 0; axis < 3; ++axis) {
            if (!(dx[axis] > 0))
                throw Error(where, fmt::format("expected a positive cell size, found {}", dx[axis]));
            const double expected = i > 0 ? levels[i - 1].cellSize[axis] / levels[i - 1].ratio : dx[axis];
            if (std::abs(dx[axis] - expected) > 1e-3 * expected)
                throw Error(
                    where, fmt::format("expected the cell size {} for level {}, as level {} is refined by {}, found {}",
                                       expected, i, i - 1, levels[i - 1].ratio, dx[axis]));
        }
    }
}

/// The grids' physical boxes are passed over: Cell_H has them as integers.
void readGrids(TextCursor& text, std::vector<AmrexLevel>& levels)
{
    for (std::size_t i = 0; i < levels.size(); ++i) {
        text.integer("the number of the level", static_cast<std::int64_t>(i), static_cast<std::int64_t>(i));
        levels[i].gridCount = text.count("the number of grids", 0);
        text.word("the time");
        text.word("the level's step");
        for (std::int64_t k = 0; k < 6 * levels[i].gridCount; ++k)
            text.number("a bound of a grid");
        levels[i].path = text.word("the path of the level's data");
        checkInside(text, levels[i].path, "the path of the level's data");
    }
}

void readFabs(TextCursor& text, std::int64_t count, AmrexCells& cells)
{
    std::map<std::string, std::uint32_t> known; // by name, of cells.files
    for (std::int64_t i = 0; i < count; ++i) {
        text.expect("FabOnDisk:", "the place of a FAB");
        const std::string name = text.word("the name of a data file");
        const auto [file, isNew] = known.emplace(name, static_cast<std::uint32_t>(cells.files.size()));
        if (isNew) {
            checkInside(text, name, "the name of a data file");
            cells.files.push_back(name);
        }
        const std::int64_t offset = text.integer("an offset in a data file", 0, INT64_MAX);
        cells.fabs.push_back({file->second, static_cast<std::uint64_t>(offset)});
    }
}

int shiftOf(const std::vector<AmrexLevel>& levels)
{
    int shift = 0;
    for (const AmrexLevel& level : levels)
        shift += std::countr_zero(static_cast<unsigned>(level.ratio));
    return shift;
}

} // namespace

bool isPlotfileVersion(const std::string& firstLine)
{
    // NAME-V1.1: no blanks, and digits, a dot and digits at the end.
    const std::size_t dash = firstLine.rfind("-V");
    if (dash == std::string::npos || dash == 0 || firstLine.find_first_of(" \t") != std::string::npos)
        return false;
    const std::string number = firstLine.substr(dash + 2);
    const std::size_t dot = number.find('.');
    return dot != std::string::npos && dot > 0 && dot + 1 < number.size() &&
           std::all_of(number.begin(), number.end(), [](unsigned char c) { return std::isdigit(c) || c == '.'; });
}

AmrexHeader readAmrexHeader(const std::string& file)
{
    TextCursor text(file);
    AmrexHeader header;
    header.version = text.line("the version of the plotfile, like HyperCLaw-V1.1");
    const std::int64_t components = text.count("the number of components", 1);
    text.line("the end of the line");
    for (std::int64_t i = 0; i < components; ++i)
        header.components.push_back(text.line("the name of a component"));
    const std::string where = text.where();
    const std::int64_t dimensions = text.integer("the number of dimensions", 1, 3);
    if (dimensions != 3)
        throw Error(
            where,
            fmt::format("expected a plotfile of three dimensions, found one of {}, which cannot be shown as a volume",
                        dimensions));
    text.word("the time");
    header.levels.resize(static_cast<std::size_t>(text.integer("the number of the finest level", 0, maxLevel)) + 1);
    header.lower = readPoint(text, "the lower corner of the domain");
    header.upper = readPoint(text, "the upper corner of the domain");
    readRatios(text, header.levels);
    if (shiftOf(header.levels) > maxLevel)
        throw Error(where, fmt::format("expected refinement by at most 2^{} in all, found 2^{}", maxLevel,
                                       shiftOf(header.levels)));
    readDomains(text, header.levels);
    for (std::size_t i = 0; i < header.levels.size(); ++i)
        text.word("a level's step");
    readCellSizes(text, header.levels);
    if (text.integer("the coordinate system", 0, 2) != 0)
        throw Error(text.where(), "expected Cartesian coordinates (0), found cylindrical or spherical ones");
    text.word("the boundary width");
    readGrids(text, header.levels);
    return header;
}

AmrexCells readAmrexCells(const std::string& file, int level)
{
    TextCursor text(file);
    AmrexCells cells;
    cells.boxes = {file, level, {}};
    const std::string where = text.where();
    const std::int64_t version = text.integer("the version of the MultiFab", 0, 4);
    if (version > 1)
        throw Error(
            where, fmt::format("expected version 0 or 1, found {}, whose data have no headers; write the plotfile with "
                               "vismf.headerversion = 1",
                               version));
    text.word("how the data were written");
    cells.components = text.integer("the number of components", 1, 1 << 20);
    cells.ghosts = text.nextIs("(") ? readIntVect(text, "the number of ghost cells")
                                    : vec3i(static_cast<int>(text.integer("the number of ghost cells", 0, 1 << 10)));
    if (std::min({cells.ghosts.x, cells.ghosts.y, cells.ghosts.z}) < 0)
        throw Error(where, "expected no negative number of ghost cells");
    text.expect("(", "the list of boxes");
    const std::int64_t boxes = text.count("the number of boxes", 0);
    text.word("the hash of the boxes");
    for (std::int64_t i = 0; i < boxes; ++i)
        cells.boxes.boxes.push_back(readAmrexBox(text));
    text.expect(")", "the list of boxes");
    checkLevel(cells.boxes);
    text.integer("the number of FABs, as many as boxes", boxes, boxes);
    readFabs(text, boxes, cells);
    return cells;
}

Box3i readAmrexBox(TextCursor& text)
{
    text.expect("(", "a box ((lower) (upper) (type))");
    const vec3i lower = readIntVect(text, "a box's lower index");
    const vec3i upper = readIntVect(text, "a box's upper index");
    const vec3i type = readIntVect(text, "a box's type");
    if (type != vec3i(0))
        throw Error(text.where(), fmt::format("expected values at cell centres, type (0,0,0), found type ({},{},{})",
                                              type.x, type.y, type.z));
    for (int axis = 0; axis < 3; ++axis)
        if (upper[axis] < lower[axis])
            throw Error(text.where(), fmt::format("expected a box with cells, found indices {} to {} along {}",
                                                  lower[axis], upper[axis], "xyz"[axis]));
    for (int axis = 0; axis < 3; ++axis) // extents stay ints
        if (std::int64_t(upper[axis]) - lower[axis] >= indexLimit)
            throw Error(text.where(), fmt::format("expected a box of at most {} cells along {}, found indices {} to {}",
                                                  indexLimit, "xyz"[axis], lower[axis], upper[axis]));
    text.expect(")", "a box");
    return {lower, upper + 1};
}

} // namespace brickwall
