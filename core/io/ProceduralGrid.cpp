// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/LargeArray.h"
#include "brickwall/core/io/ProceduralSet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include <glm/ext/matrix_transform.hpp>

namespace brickwall {
namespace {

constexpr int blockWidth = 8; // in cells
constexpr std::uint64_t blockCells = blockWidth * blockWidth * blockWidth;
constexpr std::uint64_t cellsAtOnce = 1 << 14; // between two looks at whether to stop

/// A block of the tree, leaf or refined: `at` counts blocks of its level.
struct Block
{
    vec3i at;
    int level;
    bool leaf = true;
    float change = 0.0f; ///< the largest difference between neighbouring cell corners, 0 on level 0
};

/// The blocks made so far. Everything here runs on one thread and in one order; only `measure` is parallel.
class BlockTree
{
public:
    explicit BlockTree(const ProceduralSet& set) : set_(set)
    {
        vec3i at;
        for (at.z = 0; at.z < set.rootBlocks.z; ++at.z)
            for (at.y = 0; at.y < set.rootBlocks.y; ++at.y)
                for (at.x = 0; at.x < set.rootBlocks.x; ++at.x)
                    add(at, set.levels - 1);
        leaves_ = blocks_.size();
    }

    std::uint64_t leafCells() const { return leaves_ * blockCells; }
    const std::vector<Block>& blocks() const { return blocks_; }

    /// Sets `change` of all blocks from index `first` on.
    void measure(std::size_t first, const Executor& executor, const Progress& progress)
    {
        executor.forEach(blocks_.size() - first, 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = first + begin; i < first + end; ++i) {
                progress.check();
                if (blocks_[i].level > 0)
                    blocks_[i].change = changeOf(blocks_[i]);
            }
        });
    }

    /// Replaces a leaf by its eight children, after coarser neighbours across its faces have been refined.
    void refine(std::size_t index)
    {
        if (!blocks_[index].leaf)
            return;
        const Block block = blocks_[index];
        for (int side = 0; side < 6; ++side) {
            vec3i at = block.at;
            at[side / 2] += side % 2 == 0 ? -1 : 1;
            if (inside(at, block.level) && !find(at, block.level))
                refine(*find(at >> 1, block.level + 1));
        }
        blocks_[index].leaf = false;
        for (int child = 0; child < 8; ++child)
            add(block.at * 2 + vec3i(child & 1, (child >> 1) & 1, child >> 2), block.level - 1);
        leaves_ += 7;
    }

private:
    static std::uint64_t key(const vec3i& at, int level)
    {
        return std::uint64_t(level) << 57 | std::uint64_t(at.x) << 38 | std::uint64_t(at.y) << 19 | std::uint64_t(at.z);
    }

    void add(const vec3i& at, int level)
    {
        indices_.emplace(key(at, level), blocks_.size());
        blocks_.push_back({at, level});
    }

    const std::size_t* find(const vec3i& at, int level) const
    {
        const auto it = indices_.find(key(at, level));
        return it == indices_.end() ? nullptr : &it->second;
    }

    bool inside(const vec3i& at, int level) const
    {
        const vec3i size = set_.rootBlocks << (set_.levels - 1 - level);
        return at.x >= 0 && at.y >= 0 && at.z >= 0 && at.x < size.x && at.y < size.y && at.z < size.z;
    }

    /// Corners instead of centres: those on the faces belong to both blocks, so that no front hides between two blocks.
    float changeOf(const Block& block) const
    {
        constexpr int n = blockWidth + 1;
        std::array<float, n * n * n> v;
        const double width = 1 << block.level;
        for (int k = 0, i = 0; k < n; ++k)
            for (int j = 0; j < n; ++j)
                for (int x = 0; x < n; ++x, ++i)
                    v[i] = float(set_.refinedBy(
                        transformPoint(set_.worldFromVoxel, width * vec3d(block.at * blockWidth + vec3i(x, j, k)))));
        float largest = 0.0f;
        for (int i = 0; i < n * n * n; ++i) {
            const int x = i % n, j = i / n % n, k = i / (n * n);
            largest = x > 0 ? std::max(largest, std::abs(v[i] - v[i - 1])) : largest;
            largest = j > 0 ? std::max(largest, std::abs(v[i] - v[i - n])) : largest;
            largest = k > 0 ? std::max(largest, std::abs(v[i] - v[i - n * n])) : largest;
        }
        return largest;
    }

    const ProceduralSet& set_;
    std::vector<Block> blocks_;
    std::unordered_map<std::uint64_t, std::size_t> indices_;
    std::uint64_t leaves_ = 0;
};

/// The leaves that may be refined and change at least `share` times as much as the one that changes most, most first.
std::vector<std::size_t> mostChanging(const std::vector<Block>& blocks, float share)
{
    float largest = 0.0f;
    for (const Block& block : blocks)
        largest = block.leaf ? std::max(largest, block.change) : largest;
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < blocks.size() && largest > 0.0f; ++i)
        if (blocks[i].leaf && blocks[i].change >= share * largest)
            chosen.push_back(i);
    std::stable_sort(chosen.begin(), chosen.end(),
                     [&](std::size_t a, std::size_t b) { return blocks[a].change > blocks[b].change; });
    return chosen;
}

std::vector<Brick> leafBricks(const std::vector<Block>& blocks)
{
    std::vector<Brick> bricks;
    for (const Block& block : blocks)
        if (block.leaf)
            bricks.push_back(
                {(block.at * blockWidth) << block.level, vec3i(blockWidth), block.level, bricks.size() * blockCells});
    return bricks;
}

} // namespace

std::vector<Brick> refineBlocks(const ProceduralSet& set, const Executor& executor, Progress& progress)
{
    progress.begin("refining", set.cells);
    BlockTree tree(set);
    for (std::size_t measured = 0; tree.leafCells() + 4 * blockCells <= set.cells;) {
        const std::uint64_t before = tree.leafCells();
        tree.measure(measured, executor, progress);
        measured = tree.blocks().size();
        for (const std::size_t index : mostChanging(tree.blocks(), 0.8f))
            if (tree.leafCells() + 4 * blockCells <= set.cells)
                tree.refine(index);
        if (tree.leafCells() == before)
            break; // nothing changes any more
        progress.advance(tree.leafCells() - before);
    }
    progress.end();
    return leafBricks(tree.blocks());
}

void sampleBrick(const ProceduralField& field, const mat4d& worldFromVoxel, const Brick& brick, std::uint64_t first,
                 std::span<float> values)
{
    const auto row = std::uint64_t(brick.size.x), plane = row * std::uint64_t(brick.size.y);
    vec3i i(first % row, first % plane / row, first / plane);
    for (float& value : values) {
        value = float(field.value(
            transformPoint(worldFromVoxel, vec3d(brick.lower) + (vec3d(i) + 0.5) * double(brick.cellWidth()))));
        if (++i.x < brick.size.x)
            continue;
        i.x = 0;
        if (++i.y < brick.size.y)
            continue;
        i.y = 0;
        ++i.z;
    }
}

Field sampleField(const ProceduralField& field, const mat4d& worldFromVoxel, std::span<const Brick> bricks,
                  const Executor& executor, Progress& progress)
{
    const std::uint64_t cells = bricks.empty() ? 0 : bricks.back().begin + bricks.back().cellCount();
    Field out{field.name, field.unit, makeLargeArray(cells, executor), {}, {}};
    progress.begin("sampling " + field.name, cells);
    executor.forEach(bricks.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (const Brick& brick : bricks.subspan(begin, end - begin))
            for (std::uint64_t first = 0; first < brick.cellCount(); first += cellsAtOnce) {
                progress.check();
                const std::uint64_t count = std::min(cellsAtOnce, brick.cellCount() - first);
                sampleBrick(field, worldFromVoxel, brick, first,
                            std::span(out.values).subspan(brick.begin + first, count));
                progress.advance(count);
            }
    });
    out.range = rangeOf(out.values);
    progress.end();
    return out;
}

mat4d worldFromGrid(const vec3d& lower, double width, int rootBlocks, int levels)
{
    const double voxels = double(rootBlocks) * blockWidth * (1 << (levels - 1));
    return glm::scale(glm::translate(mat4d(1.0), lower), vec3d(width / voxels));
}

} // namespace brickwall
