// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/VisibleNodes.h"

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

} // namespace

std::vector<KdNode> visibleNodes(const RegionTree& tree, const PaddedField& field, const TransferTable& table,
                                 const Executor& executor)
{
    std::vector<KdNode> nodes = tree.nodes;
    executor.forEach(nodes.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (nodes[i].axis == 3 && !isEmpty(nodes[i]) &&
                !(table.largestExtinction(field.regionRanges[nodes[i].child]) > 0.0f))
                nodes[i] = emptyNode();
        }
    });
    // Children come after their parent, so one backward sweep carries emptiness up to the root.
    for (std::size_t i = nodes.size(); i-- > 0;) {
        if (nodes[i].axis != 3 && isEmpty(nodes[nodes[i].child]) && isEmpty(nodes[nodes[i].child + 1]))
            nodes[i] = emptyNode();
    }
    return nodes;
}

} // namespace brickwall
