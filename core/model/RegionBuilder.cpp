// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/RegionPlane.h"
#include "brickwall/core/model/Regions.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
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

    Subtree build(const Box3i& box, const std::vector<std::uint32_t>& bricks, int depth) const
    {
        if (bricks.size() < parallelBricks)
            return buildSerially(box, bricks, depth);
        progress_.check();
        RegionPlaneChooser chooser(supports_);
        const RegionLeaf leaf = regionLeaf(box, bricks, supports_);
        const SplitPlane plane = split(box, bricks, depth, leaf, chooser);
        if (plane.axis < 0)
            return buildSerially(box, bricks, depth);
        const auto parts = halves(box, plane); // clang 14 captures no names of a structured binding
        Subtree a, b;
        executor_.both([&] { a = build(parts.first, overlapping(parts.first, bricks), depth + 1); },
                       [&] { b = build(parts.second, overlapping(parts.second, bricks), depth + 1); });
        return join(plane, std::move(a), b, depth);
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

    /// The root, both children's roots, then the rest of the lower side, then that of the upper.
    static Subtree join(const SplitPlane& plane, Subtree a, const Subtree& b, int depth)
    {
        checkCounts(a.nodes.size() + b.nodes.size() + 1, a.brickLists.size() + b.brickLists.size());
        Subtree tree;
        tree.depth = std::max({depth, a.depth, b.depth});
        tree.nodes.reserve(a.nodes.size() + b.nodes.size() + 1);
        tree.nodes.push_back(innerNode(plane, 1));
        const auto moved = [](KdNode n, std::size_t nodes, std::size_t regions) {
            if (n.axis != 3 || n.child != KdNode::emptyLeaf)
                n.child = (n.child + std::uint32_t(n.axis != 3 ? nodes : regions)) & KdNode::emptyLeaf;
            return n;
        };
        const std::size_t aNodes = 2, bNodes = 1 + a.nodes.size(), bRegions = a.regions.size();
        tree.nodes.push_back(moved(a.nodes[0], aNodes, 0));
        tree.nodes.push_back(moved(b.nodes[0], bNodes, bRegions));
        for (std::size_t i = 1; i < a.nodes.size(); ++i)
            tree.nodes.push_back(moved(a.nodes[i], aNodes, 0));
        for (std::size_t i = 1; i < b.nodes.size(); ++i)
            tree.nodes.push_back(moved(b.nodes[i], bNodes, bRegions));
        tree.regions = std::move(a.regions);
        tree.brickLists = std::move(a.brickLists);
        const auto listed = std::uint32_t(tree.brickLists.size());
        for (Region r : b.regions) {
            r.firstBrick += listed;
            tree.regions.push_back(r);
        }
        tree.brickLists.insert(tree.brickLists.end(), b.brickLists.begin(), b.brickLists.end());
        return tree;
    }

    std::span<const Support> supports_;
    const Executor& executor_;
    Progress& progress_;
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
    Subtree tree = Builder(supports, executor, progress).build(result.bounds, all, 0);
    checkCounts(tree.nodes.size(), tree.brickLists.size());
    result.nodes = std::move(tree.nodes);
    result.regions = std::move(tree.regions);
    result.brickLists = std::move(tree.brickLists);
    result.depth = tree.depth;
    progress.end();
    return result;
}

} // namespace brickwall
