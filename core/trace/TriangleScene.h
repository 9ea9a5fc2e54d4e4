// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <memory>
#include <span>

namespace brickwall {

struct TriangleHit
{
    float t = 0.0f;     ///< along the direction that was given; only meaningful if `hit`
    vec3f normal{0.0f}; ///< geometric, world space, unit length, not oriented
    bool hit = false;
    vec3f color{0.8f}; ///< of its mesh
};

/// Opaque triangles in world space, to be hit by rays. The only part that knows Embree (3.13). Immutable after
/// construction; `intersect` may be called from any number of threads.
class TriangleScene
{
public:
    /// Throws Error for indices out of range and vertices that are not finite.
    explicit TriangleScene(std::span<const TriangleMesh> meshes);
    ~TriangleScene();
    TriangleScene(TriangleScene&&) noexcept;
    TriangleScene& operator=(TriangleScene&&) noexcept;

    bool empty() const;
    /// The nearest hits with t > 0 of rays in world space. All spans are equally long.
    void intersect(std::span<const vec3d> origins, std::span<const vec3d> directions,
                   std::span<TriangleHit> hits) const;

private:
    struct Embree;
    std::unique_ptr<Embree> embree_;
};

} // namespace brickwall
