// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/Regions.h"

namespace brickwall {

std::size_t RegionTree::bytes() const
{
    return sizeof(*this) + nodes.size() * sizeof(KdNode) + regions.size() * sizeof(Region) +
           brickLists.size() * sizeof(std::uint32_t) + bricks.size() * sizeof(PaddedBrick);
}

std::size_t PaddedField::bytes() const
{
    return sizeof(*this) + values.size() * sizeof(float) + regionRanges.size() * sizeof(Range) +
           (regionSlopes.size() + regionLogSlopes.size()) * sizeof(float);
}

std::int64_t findRegion(const RegionTree& tree, const vec3d& p)
{
    const Box3d bounds{vec3d(tree.bounds.lower), vec3d(tree.bounds.upper)};
    if (tree.nodes.empty() || !bounds.contains(p))
        return -1;
    const KdNode* node = &tree.nodes[0];
    while (node->axis != 3)
        node = &tree.nodes[node->child + (p[node->axis] < node->plane ? 0 : 1)];
    return node->child == KdNode::emptyLeaf ? -1 : std::int64_t(node->child);
}

} // namespace brickwall
