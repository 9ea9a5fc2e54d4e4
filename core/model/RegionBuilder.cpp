// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/RegionPlane.h"
#include "brickwall/core/model/Regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

namespace brickwall {
namespace {

using half::Support;

/// Below this many bricks a subtree is built by one thread into one buffer. A constant, so that the tree does not
/// depend on the executor.
constexpr std::size_t parallelBricks = 256;

/// Deeper than this, planes halve the list instead of minimising the cost: keeps the traversal stack short for any
/// layout.
constexpr int balanceDepth = 40;

/// A part of the tree with indices of its own; its root is nodes[0].
struct Subtree
{
    std::vector<KdNode> nodes;
    std::vector<Region> regions;
    std::vector<std::uint32_t> brickLists;
    int depth = 0;
};

/// A node of the upper part of the tree, with two parts below it, or a subtree that was built by one thread.
struct Part
{
    SplitPlane plane; ///< axis -1: a subtree
    std::unique_ptr<Part> lower, upper;
    Subtree tree;
};

KdNode innerNode(const SplitPlane& plane, std::size_t child)
{
    KdNode node;
    node.plane = plane.position;
    node.axis = std::uint32_t(plane.axis) & 3u;
    node.child = std::uint32_t(child) & KdNode::emptyLeaf;
    return node;
}

/// Too many nodes, regions or list entries for their indices; far beyond what fits a machine with a terabyte.
void checkCounts(std::size_t nodes, std::size_t listed)
{
    if (nodes >= KdNode::emptyLeaf || listed > std::numeric_limits<std::uint32_t>::max())
        throw Error("regions",
                    fmt::format("expected at most {} nodes and 2^32 - 1 listed bricks, found {} and {}; merge "
                                "the bricks into larger ones",
                                KdNode::emptyLeaf, nodes, listed));
}

class Builder
{
public:
    Builder(std::span<const Support> supports, const Executor& executor, Progress& progress)
        : supports_(supports), executor_(executor), progress_(progress)
    {
    }

    std::unique_ptr<Part> build(const Box3i& box, const std::vector<std::uint32_t>& bricks, int depth) const
    {
        auto part = std::make_unique<Part>();
        if (bricks.size() >= parallelBricks) {
            progress_.check();
            RegionPlaneChooser chooser(supports_);
            const RegionLeaf leaf = regionLeaf(box, bricks, supports_);
            part->plane = split(box, bricks, depth, leaf, chooser);
        }
        if (part->plane.axis < 0) {
            part->tree = buildSerially(box, bricks, depth);
            return part;
        }
        const auto boxes = halves(box, part->plane); // clang 14 captures no names of a structured binding
        executor_.both([&] { part->lower = build(boxes.first, overlapping(boxes.first, bricks), depth + 1); },
                       [&] { part->upper = build(boxes.second, overlapping(boxes.second, bricks), depth + 1); });
        return part;
    }

private:
    Subtree buildSerially(const Box3i& box, const std::vector<std::uint32_t>& bricks, int depth) const
    {
        Subtree tree;
        tree.nodes.emplace_back();
        RegionPlaneChooser chooser(supports_);
        fill(tree, 0, box, bricks, depth, chooser);
        progress_.advance(tree.regions.size());
        return tree;
    }

    void fill(Subtree& tree, std::size_t node, const Box3i& box, const std::vector<std::uint32_t>& bricks, int depth,
              RegionPlaneChooser& chooser) const
    {
        progress_.check();
        tree.depth = std::max(tree.depth, depth);
        const RegionLeaf leaf = regionLeaf(box, bricks, supports_);
        const SplitPlane plane = split(box, bricks, depth, leaf, chooser);
        if (plane.axis < 0)
            return addLeaf(tree, node, box, bricks, leaf);
        const std::size_t child = tree.nodes.size();
        tree.nodes.resize(child + 2);
        tree.nodes[node] = innerNode(plane, child);
        const auto [lower, upper] = halves(box, plane);
        fill(tree, child, lower, overlapping(lower, bricks), depth + 1, chooser);
        fill(tree, child + 1, upper, overlapping(upper, bricks), depth + 1, chooser);
    }

    /// The plane of a node; axis -1 if it is to be a leaf.
    SplitPlane split(const Box3i& box, std::span<const std::uint32_t> bricks, int depth, const RegionLeaf& leaf,
                     RegionPlaneChooser& chooser) const
    {
        const bool oneLevel = leaf.levelCount == 1;
        const bool done = leaf.kind == RegionLeaf::Kind::empty || leaf.kind == RegionLeaf::Kind::singleBrick ||
                          (leaf.kind == RegionLeaf::Kind::sameBricks && !oneLevel);
        return done ? SplitPlane() : chooser.choose(box, bricks, oneLevel, depth >= balanceDepth);
    }

    void addLeaf(Subtree& tree, std::size_t node, const Box3i& box, std::span<const std::uint32_t> bricks,
                 const RegionLeaf& leaf) const
    {
        if (leaf.kind == RegionLeaf::Kind::empty)
            return;
        std::uint8_t finest = maxLevel, coarsest = 0;
        for (const std::uint32_t b : bricks) {
            finest = std::min(finest, std::uint8_t(supports_[b].level));
            coarsest = std::max(coarsest, std::uint8_t(supports_[b].level));
        }
        if (leaf.kind == RegionLeaf::Kind::singleBrick)
            bricks = {&leaf.brick, 1};
        if (bricks.size() > std::numeric_limits<std::uint16_t>::max())
            throw Error("regions", fmt::format("expected at most 65535 bricks in one place, found {} around voxel "
                                               "({}, {}, {}); merge the bricks into larger ones",
                                               bricks.size(), box.lower.x / 2, box.lower.y / 2, box.lower.z / 2));
        tree.nodes[node].child = std::uint32_t(tree.regions.size()) & KdNode::emptyLeaf;
        tree.regions.push_back({box.lower, box.upper, std::uint32_t(tree.brickLists.size()),
                                std::uint16_t(bricks.size()), finest, coarsest});
        tree.brickLists.insert(tree.brickLists.end(), bricks.begin(), bricks.end());
    }

    static std::pair<Box3i, Box3i> halves(const Box3i& box, const SplitPlane& plane)
    {
        Box3i lower = box, upper = box;
        lower.upper[plane.axis] = upper.lower[plane.axis] = plane.position;
        return {lower, upper};
    }

    std::vector<std::uint32_t> overlapping(const Box3i& box, std::span<const std::uint32_t> bricks) const
    {
        std::vector<std::uint32_t> kept;
        kept.reserve(bricks.size());
        std::copy_if(bricks.begin(), bricks.end(), std::back_inserter(kept),
                     [&](std::uint32_t b) { return supports_[b].box.overlaps(box); });
        return kept;
    }

    std::span<const Support> supports_;
    const Executor& executor_;
    Progress& progress_;
};

/// Puts parts together, each once: in the order in which one thread would have built all of it. What has been taken
/// over is gone from the part, so that memory is that of one tree and a little.
class Assembly
{
public:
    explicit Assembly(RegionTree& tree) : tree_(tree) {}

    void assemble(Part& root)
    {
        count(root);
        checkCounts(nodes_, listed_);
        tree_.nodes.reserve(nodes_);
        tree_.regions.reserve(regions_);
        tree_.brickLists.reserve(listed_);
        tree_.nodes.emplace_back();
        take(root, 0);
    }

private:
    void count(const Part& part)
    {
        nodes_ += part.plane.axis < 0 ? part.tree.nodes.size() : 1;
        regions_ += part.tree.regions.size();
        listed_ += part.tree.brickLists.size();
        if (part.plane.axis < 0)
            return;
        count(*part.lower);
        count(*part.upper);
    }

    void take(Part& part, std::size_t slot)
    {
        if (part.plane.axis < 0)
            return take(part.tree, slot);
        const std::size_t child = tree_.nodes.size();
        tree_.nodes.resize(child + 2);
        tree_.nodes[slot] = innerNode(part.plane, child);
        take(*part.lower, child);
        part.lower.reset();
        take(*part.upper, child + 1);
        part.upper.reset();
    }

    void take(const Subtree& part, std::size_t slot)
    {
        const std::size_t nodes = tree_.nodes.size() - 1, regions = tree_.regions.size(); // but for its root
        const auto listed = std::uint32_t(tree_.brickLists.size());
        const auto moved = [&](KdNode n) {
            if (n.axis != 3 || n.child != KdNode::emptyLeaf)
                n.child = (n.child + std::uint32_t(n.axis != 3 ? nodes : regions)) & KdNode::emptyLeaf;
            return n;
        };
        tree_.nodes[slot] = moved(part.nodes[0]);
        std::transform(part.nodes.begin() + 1, part.nodes.end(), std::back_inserter(tree_.nodes), moved);
        for (Region region : part.regions) {
            region.firstBrick += listed;
            tree_.regions.push_back(region);
        }
        tree_.brickLists.insert(tree_.brickLists.end(), part.brickLists.begin(), part.brickLists.end());
        tree_.depth = std::max(tree_.depth, part.depth);
    }

    RegionTree& tree_;
    std::size_t nodes_ = 0, regions_ = 0, listed_ = 0;
};

} // namespace

RegionTree buildRegions(std::span<const Brick> bricks, const Executor& executor, Progress& progress)
{
    progress.begin("building regions", 0);
    progress.check();
    RegionTree result;
    if (bricks.empty()) {
        result.nodes.emplace_back();
        result.bounds = {vec3i(0), vec3i(0)};
        progress.end();
        return result;
    }
    std::vector<Support> supports;
    supports.reserve(bricks.size());
    for (const Brick& b : bricks) {
        supports.push_back(half::supportOf(b));
        result.bounds.extend(supports.back().box);
        result.bricks.push_back({b.lower, b.size, b.level, result.paddedCellCount});
        const vec3i padded = result.bricks.back().paddedSize();
        result.paddedCellCount += std::uint64_t(padded.x) * padded.y * padded.z;
    }
    std::vector<std::uint32_t> all(bricks.size());
    std::iota(all.begin(), all.end(), 0u);
    const std::unique_ptr<Part> root = Builder(supports, executor, progress).build(result.bounds, all, 0);
    Assembly(result).assemble(*root);
    progress.end();
    return result;
}

} // namespace brickwall
