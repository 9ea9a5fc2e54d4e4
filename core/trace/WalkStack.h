// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace brickwall {

/// Room for what a walk of the kd-tree has still to visit: at most one node per level of the tree. Made once per tile.
class WalkStack
{
public:
    struct Slot
    {
        alignas(64) float t0[16];
        alignas(64) float t1[16];
        std::uint32_t node;
    };

    explicit WalkStack(int treeDepth) : slots_(static_cast<std::size_t>(treeDepth) + 1) {}

    Slot* slots() { return slots_.data(); }

private:
    std::vector<Slot> slots_;
};

} // namespace brickwall
