// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Regions.h"
#include "brickwall/core/trace/PieceRoots.h"
#include "brickwall/core/trace/TraceTile.h"

#include <array>
#include <limits>

namespace brickwall {

/// A ray of a tile in double. Planes are given in half voxels and met at one time, whoever asks: what lies between two
/// planes along an axis is an interval of t, and the regions' and pieces' intervals leave neither gaps nor overlaps.
struct ExactRay
{
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    vec3i origin{0}; ///< half voxels, of the scene
    vec3d org{0.0};  ///< half voxels, relative to `origin`
    vec3d dir{0.0};  ///< half voxels per t
    vec3d reciprocal{0.0};
    std::array<bool, 3> flat{}; ///< along planes across this axis; a ray in such a plane is on its upper side
    double tNear = 0.0, tFar = 0.0;

    ExactRay() = default;
    ExactRay(const RayTile& rays, int ray, const vec3i& origin);

    double time(int axis, int plane) const
    {
        const double distance = double(plane - origin[axis]) - org[axis];
        if (flat[axis])
            return distance > 0.0 ? infinity : -infinity;
        return distance * reciprocal[axis];
    }
    bool backwards(int axis) const { return dir[axis] < 0.0; }
    /// Half voxels, relative to `origin`.
    vec3d at(double t) const { return org + t * dir; }
    /// The planes across an axis between which the ray has a box behind it and before it.
    int nearPlane(const Region& region, int axis) const;
    int farPlane(const Region& region, int axis) const;
};

/// The pieces of a ray in a region, in order: between them lie the planes through the centres of the region's cells, so
/// that in each of them B is a quotient of cubics. All in double; a piece starts bit for bit where the one before ends.
class ExactPieces
{
public:
    /// From t = `from` on, or from where the ray enters the region.
    ExactPieces(const Region& region, const ExactRay& ray, double from);

    bool done() const { return !(start < tOut_); }
    void next();
    /// The plane through cell centres of a level at or below the piece.
    int centerBelow(int axis, int level) const;

    double start = 0.0, end = 0.0;
    vec3d startPosition{0.0}, endPosition{0.0}; ///< half voxels relative to the ray's origin, exact on planes

private:
    void findPlane(int axis, int level);
    void findEnd();

    const Region& region_;
    const ExactRay& ray_;
    double tOut_;
    std::array<std::array<int, maxLevel + 1>, 3> plane_; ///< the next one that the ray meets, per axis and level
    std::array<std::array<double, maxLevel + 1>, 3> time_;
};

/// B less `reference` along a piece, reduced.
PieceQuotient quotientOf(const RegionTree& tree, const Region& region, const float* values, const ExactPieces& piece,
                         const ExactRay& ray, double reference);

/// The direction in which B changes, at a position (as in ExactPieces) of a piece where B is `reference`: its gradient
/// per half voxel. Zero where no tent reaches.
vec3d gradientAt(const RegionTree& tree, const Region& region, const float* values, const ExactPieces& piece,
                 const ExactRay& ray, const vec3d& position, double reference);

} // namespace brickwall
