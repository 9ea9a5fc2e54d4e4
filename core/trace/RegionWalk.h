// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Rays in lanes through the kd-tree of regions, front to back. The walk owns the loop, the caller what happens in a
/// region. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_REGION_WALK_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_REGION_WALK_H
#undef BRICKWALL_CORE_TRACE_REGION_WALK_H
#else
#define BRICKWALL_CORE_TRACE_REGION_WALK_H
#endif

#include "brickwall/core/model/Regions.h"
#include "brickwall/core/simd/Lanes.h"
#include "brickwall/core/trace/WalkStack.h"

#include <span>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

struct RayN
{
    FloatN org[3]; ///< voxels, relative to the scene's origin
    FloatN dir[3];
};

/// Where rays meet a node's plane: [.., nearEnd] lies in the child before it, [farStart, ..] in that behind.
struct CrossingN
{
    FloatN nearEnd, farStart;
};

/// Packets are split so that one order of a node's children is front to back for all their rays. Planes says where rays
/// meet planes.
template <class Planes>
class KdWalk
{
public:
    KdWalk(std::span<const KdNode> nodes, const vec3i& origin, const RayN& ray, WalkStack& stack)
        : nodes_(nodes.data()), stack_(stack.slots()), origin_(origin)
    {
        // A ray along a plane stays on one side of it. A huge reciprocal instead of infinity says so without NaNs: the
        // plane is met far away or long ago, and at t = 0 if the ray lies in it, which gives it to the upper side.
        const FloatN tiny = Planes::tiny;
        for (int axis = 0; axis < 3; ++axis) {
            org_[axis] = ray.org[axis];
            const MaskN flat = abs(ray.dir[axis]) < tiny;
            reciprocal_[axis] = FloatN(1.0f) / select(flat, tiny, ray.dir[axis]);
            backwards_[axis] = andNot(ray.dir[axis] < FloatN(0.0f), flat);
        }
    }

    /// Calls visit(region, active, t0, t1) -> MaskN for every region, t0 < t1 where `active`; the lanes that it returns
    /// go on, the others have ended.
    template <class Visit>
    void operator()(MaskN active, FloatN t0, FloatN t1, Visit& visit) const
    {
        for (int octant = 0; octant < 8 && any(active); ++octant) {
            MaskN lanes = active;
            for (int axis = 0; axis < 3; ++axis)
                lanes = (octant >> axis & 1) ? lanes & backwards_[axis] : andNot(lanes, backwards_[axis]);
            active = andNot(active, lanes);
            if (any(lanes))
                walk(octant, lanes, t0, t1, visit);
        }
    }

private:
    /// Intervals on the stack are empty (t0 >= t1) in lanes that do not go there, so that it needs no masks.
    template <class Visit>
    void walk(int octant, MaskN alive, FloatN t0, FloatN t1, Visit& visit) const
    {
        std::uint32_t next = 0;
        WalkStack::Slot* top = stack_;
        MaskN active = alive & (t0 < t1);
        if (none(active))
            return;
        while (true) {
            KdNode node = nodes_[next];
            while (node.axis != 3) {
                next = descend(node, octant, active, t0, t1, top);
                node = nodes_[next];
            }
            if (node.child != KdNode::emptyLeaf) {
                const MaskN on = visit(node.child, active, t0, t1);
                alive = andNot(alive, andNot(active, on));
            }
            do {
                if (top == stack_)
                    return;
                --top;
                t0 = load(top->t0);
                t1 = load(top->t1);
                active = alive & (t0 < t1);
            } while (none(active));
            next = top->node;
        }
    }

    /// The child that comes first; the other one goes on the stack if any lane needs it as well.
    HWY_INLINE std::uint32_t descend(const KdNode& node, int octant, MaskN& active, FloatN& t0, FloatN& t1,
                                     WalkStack::Slot*& top) const
    {
        const int axis = node.axis;
        const float plane = 0.5f * static_cast<float>(node.plane - origin_[axis]);
        const CrossingN crossing = Planes::crossing(plane, org_[axis], reciprocal_[axis]);
        const std::uint32_t first = octant >> axis & 1;
        const MaskN inNear = active & (t0 < crossing.nearEnd);
        const MaskN inFar = active & (crossing.farStart < t1);
        if (none(inFar))
            return node.child + first;
        if (none(inNear))
            return node.child + (1 - first);
        top->node = node.child + (1 - first);
        store(max(t0, crossing.farStart), top->t0);
        store(t1, top->t1);
        ++top;
        t1 = min(t1, crossing.nearEnd);
        active = inNear;
        return node.child + first;
    }

    const KdNode* nodes_;
    WalkStack::Slot* stack_;
    vec3i origin_;
    FloatN org_[3];
    FloatN reciprocal_[3];
    MaskN backwards_[3];
};

/// Taken as floats say they are: every point of a ray is in one region.
struct SharpPlanes
{
    static constexpr float tiny = 1e-30f; ///< the least component of a direction

    HWY_INLINE static CrossingN crossing(float plane, FloatN org, FloatN reciprocal)
    {
        const FloatN t = (FloatN(plane) - org) * reciprocal;
        return {t, t};
    }
};

/// The walk of everything that integrates.
using RegionWalk = KdWalk<SharpPlanes>;

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
