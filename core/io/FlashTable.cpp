// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/FlashTable.h"

#include "brickwall/core/base/Box.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

constexpr std::size_t rowsAtATime = 1 << 13;
constexpr double tolerance = 0.05; // of a block: numbers are floats, in which a place is coarser than a cell
/// `gid` has six neighbours, the parent and eight children of each block, from 1 on.
constexpr std::uint64_t gidColumns = 15, firstChild = 7;

} // namespace

FlashTable::FlashTable(const Hdf5File& file, std::uint64_t count) : bounds_(file.data("bounding box"))
{
    const std::uint64_t one[]{count}, faces[]{count, 3, 2};
    file.data("refine level").expectShape(one);
    file.data("node type").expectShape(one);
    bounds_.expectShape(faces);
    if (count == 0 || count > INT32_MAX)
        throw Error(bounds_.place(), fmt::format("expected 1 to {} blocks, found {}", INT32_MAX, count));
    readLevels(file);
    if (file.has("gid") && file.data("gid").shape() == std::vector<std::uint64_t>{count, gidColumns})
        children_.emplace(file.data("gid"));
    measure();
}

void FlashTable::readLevels(const Hdf5File& file)
{
    const Hdf5Data refine = file.data("refine level");
    for (const std::int64_t level : refine.integers()) {
        if (level < 1 || level > 64)
            throw Error(refine.place(), fmt::format("expected levels from 1 to 64, found {}", level));
        refine_.push_back(static_cast<std::uint8_t>(level));
    }
    for (const std::int64_t type : file.data("node type").integers())
        leaf_.push_back(type == 1);
}

vec3d FlashTable::extent(int refineLevel) const
{
    return coarsestExtent_ / std::exp2(refineLevel - coarsest_);
}

void FlashTable::forEachBlock(const std::function<void(std::size_t, const Faces&)>& body) const
{
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin < count(); begin += rowsAtATime) {
        const std::size_t rows = std::min(rowsAtATime, count() - begin);
        const std::uint64_t start[]{begin, 0, 0}, extent[]{rows, 3, 2};
        bounds_.read(start, extent, numbers);
        for (std::size_t row = 0; row < rows; ++row) {
            Faces faces{};
            std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(6 * row), 6, faces.at);
            body(begin + row, faces);
        }
    }
}

void FlashTable::checkFaces(std::size_t block, const Faces& faces) const
{
    for (int axis = 0; axis < 3; ++axis) {
        // Below the coarsest level both may be the same float.
        const bool ordered = refineLevel(block) > coarsest_ ? faces.lower(axis) <= faces.upper(axis)
                                                            : faces.lower(axis) < faces.upper(axis);
        if (!ordered || !std::isfinite(faces.lower(axis)) || !std::isfinite(faces.upper(axis)))
            throw Error(bounds_.place(),
                        fmt::format("block {}: expected a lower and a higher number along {}, found {} and {}", block,
                                    "xyz"[axis], faces.lower(axis), faces.upper(axis)));
    }
}

/// The domain is a whole number of the coarsest blocks wide: that makes their extent as exact as the domain's.
void FlashTable::measure()
{
    const auto coarsest = std::min_element(refine_.begin(), refine_.end());
    coarsest_ = *coarsest;
    const auto first = static_cast<std::size_t>(coarsest - refine_.begin());
    Box3d domain;
    vec3d size(1.0);
    forEachBlock([&](std::size_t block, const Faces& faces) {
        checkFaces(block, faces);
        const Box3d box{{faces.lower(0), faces.lower(1), faces.lower(2)},
                        {faces.upper(0), faces.upper(1), faces.upper(2)}};
        domain.extend(box);
        if (block == first)
            size = box.extent();
    });
    lower_ = domain.lower;
    upper_ = domain.upper;
    for (int axis = 0; axis < 3; ++axis)
        coarsestExtent_[axis] = domain.extent()[axis] / std::max(1.0, std::round(domain.extent()[axis] / size[axis]));
}

vec3d FlashTable::nearestPlace(std::size_t block, const Faces& faces) const
{
    const vec3d width = extent(refineLevel(block));
    vec3d place{0.0};
    for (int axis = 0; axis < 3; ++axis)
        place[axis] = std::round((faces.lower(axis) - lower_[axis]) / width[axis]);
    return place;
}

double FlashTable::distance(std::size_t block, const Faces& faces, const vec3d& place) const
{
    const vec3d width = extent(refineLevel(block));
    double most = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double lower = (faces.lower(axis) - lower_[axis]) / width[axis];
        const double upper = (faces.upper(axis) - lower_[axis]) / width[axis];
        for (const double d : {std::abs(lower - place[axis]), std::abs(upper - place[axis] - 1.0)})
            most = d <= most ? most : d; // a NaN stays
    }
    return most;
}

double FlashTable::floatError(int refineLevel) const
{
    const vec3d largest = glm::max(glm::abs(lower_), glm::abs(upper_)) / extent(refineLevel);
    return std::exp2(-22) * std::max({largest.x, largest.y, largest.z});
}

FlashTable::Tree FlashTable::readTree() const
{
    Tree tree;
    tree.child.resize(count());
    for (std::size_t block = 0; block < count(); ++block)
        tree.parent.push_back(static_cast<std::uint32_t>(block));
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin < count(); begin += rowsAtATime) {
        const std::size_t rows = std::min(rowsAtATime, count() - begin);
        const std::uint64_t start[]{begin, firstChild}, extent[]{rows, 8};
        children_->read(start, extent, numbers);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            if (numbers[i] >= 1 && numbers[i] <= double(count())) {
                const auto block = static_cast<std::size_t>(numbers[i]) - 1;
                tree.parent[block] = static_cast<std::uint32_t>(begin + i / 8);
                tree.child[block] = static_cast<std::uint8_t>(i % 8);
            }
    }
    tree.place.resize(count());
    forEachBlock([&](std::size_t block, const Faces& faces) {
        if (refineLevel(block) == coarsest_)
            tree.place[block] = nearestPlace(block, faces);
    });
    return tree;
}

std::optional<vec3d> FlashTable::placeInTree(std::size_t block, const Tree& tree) const
{
    vec3d inside{0.0};
    double width = 1.0; // of the ancestor at hand, in blocks of the level asked for
    for (; refineLevel(block) > coarsest_; block = tree.parent[block], width *= 2.0) {
        if (refineLevel(tree.parent[block]) != refineLevel(block) - 1)
            return std::nullopt;
        const int child = tree.child[block];
        inside += width * vec3d(child & 1, child >> 1 & 1, child >> 2);
    }
    return inside + width * tree.place[block];
}

void FlashTable::forEachLeaf(const std::function<void(std::size_t, const vec3d&)>& body) const
{
    std::optional<Tree> tree; // read when the first block needs it
    forEachBlock([&](std::size_t block, const Faces& faces) {
        if (!isLeaf(block))
            return;
        if (const vec3d place = nearestPlace(block, faces); distance(block, faces, place) < tolerance)
            return body(block, place);
        if (!children_)
            failPlace(block, faces);
        if (!tree)
            tree = readTree();
        const auto place = placeInTree(block, *tree);
        if (!place || !(distance(block, faces, *place) < tolerance + floatError(refineLevel(block))))
            failPlace(block, faces);
        body(block, *place);
    });
}

void FlashTable::failPlace(std::size_t block, const Faces& faces) const
{
    const vec3d width = extent(refineLevel(block)), place = nearestPlace(block, faces);
    int axis = 0;
    for (int a = 2; a >= 0; --a)
        if (!(std::abs(lower_[a] + place[a] * width[a] - faces.lower(a)) < tolerance * width[a] &&
              std::abs(lower_[a] + (place[a] + 1.0) * width[a] - faces.upper(a)) < tolerance * width[a]))
            axis = a;
    throw Error(bounds_.place(), fmt::format("block {}: expected a block of refine level {}, {} wide along {}, at a "
                                             "whole number of them from {}, found {} to {}",
                                             block, refineLevel(block), width[axis], "xyz"[axis], lower_[axis],
                                             faces.lower(axis), faces.upper(axis)));
}

} // namespace brickwall
