// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/VisibleNodes.h"

#include <algorithm>
#include <atomic>

namespace brickwall {
namespace {

bool isEmpty(const KdNode& node)
{
    return node.axis == 3 && node.child == KdNode::emptyLeaf;
}

KdNode emptyNode()
{
    return {0, 3, KdNode::emptyLeaf};
}

/// `shows` says of a region whether a walk has to go there.
template <class Shows>
std::vector<KdNode> keepLeaves(const RegionTree& tree, const Executor& executor, const Shows& shows)
{
    std::vector<KdNode> nodes = tree.nodes;
    std::atomic<bool> hidden{false};
    executor.forEach(nodes.size(), 4096, [&](std::size_t begin, std::size_t end) {
        bool any = false;
        for (std::size_t i = begin; i < end; ++i) {
            if (nodes[i].axis == 3 && !isEmpty(nodes[i]) && !shows(nodes[i].child)) {
                nodes[i] = emptyNode();
                any = true;
            }
        }
        if (any)
            hidden = true;
    });
    if (!hidden)
        return nodes; // no node of a tree has two empty children
    // Children come after their parent, so one backward sweep carries emptiness up to the root.
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (nodes[i].axis != 3 && isEmpty(nodes[nodes[i].child]) && isEmpty(nodes[nodes[i].child + 1]))
            nodes[i] = emptyNode();
    }
    return nodes;
}

} // namespace

std::vector<KdNode> visibleNodes(const RegionTree& tree, std::span<const RegionBounds> bounds, const Executor& executor)
{
    return keepLeaves(tree, executor, [&](std::uint32_t region) { return bounds[region].extinction > 0.0f; });
}

std::vector<KdNode> surfaceNodes(const RegionTree& tree, const PaddedField& field, std::span<const IsoSurface> surfaces,
                                 const Executor& executor)
{
    return keepLeaves(tree, executor, [&](std::uint32_t region) {
        const Range range = field.regionRanges[region];
        return std::any_of(surfaces.begin(), surfaces.end(),
                           [&](const IsoSurface& surface) { return range.contains(surface.value); });
    });
}

} // namespace brickwall
