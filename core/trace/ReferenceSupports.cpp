// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/ReferenceSupports.h"

#include <algorithm>
#include <numeric>

namespace brickwall::reference {
namespace {

/// The part of [t0, t1] in which the line is in the box, faces included; empty if t0 > t1 afterwards. Rounding is
/// monotonic, so that a box inside another never yields the longer part.
void clip(const Line& line, const Box3d& box, double& t0, double& t1)
{
    for (int axis = 0; axis < 3; ++axis) {
        if (line.dir[axis] == 0.0) {
            if (line.org[axis] < box.lower[axis] || line.org[axis] > box.upper[axis])
                t1 = -std::numeric_limits<double>::infinity();
            continue;
        }
        const double a = (box.lower[axis] - line.org[axis]) / line.dir[axis];
        const double b = (box.upper[axis] - line.org[axis]) / line.dir[axis];
        t0 = std::max(t0, std::min(a, b));
        t1 = std::min(t1, std::max(a, b));
    }
}

} // namespace

Box3d supportOf(const PaddedBrick& brick)
{
    const double width = brick.cellWidth();
    return {vec3d(brick.lower) - 0.5 * width, vec3d(brick.lower) + (vec3d(brick.size) + 0.5) * width};
}

Supports::Supports(std::span<const PaddedBrick> bricks) : order_(bricks.size())
{
    boxes_.reserve(bricks.size());
    for (const PaddedBrick& brick : bricks)
        boxes_.push_back(supportOf(brick));
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(bricks.size() + 1);
    nodes_.emplace_back();
    split(0, 0, std::uint32_t(bricks.size()));
}

void Supports::split(std::uint32_t node, std::uint32_t first, std::uint32_t count)
{
    constexpr std::uint32_t leafSize = 3;
    Box3d box, centers;
    for (std::uint32_t i = first; i < first + count; ++i) {
        box.extend(boxes_[order_[i]]);
        centers.extend(boxes_[order_[i]].lower + boxes_[order_[i]].upper);
    }
    nodes_[node] = {box, first, count};
    if (count <= leafSize)
        return;
    const vec3d extent = centers.extent();
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::uint32_t half = count / 2;
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + half, begin + count, [&](std::uint32_t a, std::uint32_t b) {
        return boxes_[a].lower[axis] + boxes_[a].upper[axis] < boxes_[b].lower[axis] + boxes_[b].upper[axis];
    });
    const auto children = std::uint32_t(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = children;
    nodes_[node].count = 0;
    split(children, first, half);
    split(children + 1, first + half, count - half);
}

void Supports::cross(const Line& line, double tNear, double tFar, std::vector<Crossing>& crossings) const
{
    crossings.clear();
    if (boxes_.empty())
        return;
    std::vector<std::uint32_t> stack{0};
    while (!stack.empty()) {
        const Node& node = nodes_[stack.back()];
        stack.pop_back();
        double t0 = tNear, t1 = tFar;
        clip(line, node.box, t0, t1);
        if (!(t0 < t1))
            continue;
        if (node.count == 0) {
            stack.push_back(node.first);
            stack.push_back(node.first + 1);
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            double a = tNear, b = tFar;
            clip(line, boxes_[order_[i]], a, b);
            if (a < b)
                crossings.push_back({order_[i], a, b});
        }
    }
}

} // namespace brickwall::reference
