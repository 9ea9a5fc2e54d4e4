// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/ExactPieces.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

/// The cell pairs of one brick around a piece: per axis the lower cell (padded index), and what counts of the two.
struct CellPairs
{
    vec3i index;
    bool counts[3][2];
    const float* corner; ///< the lowest of the eight cells
    std::size_t strideY, strideZ;
    double reciprocalWidth; ///< per half voxel
    vec3d center;           ///< of the lowest cell, half voxels relative to the ray's origin

    CellPairs(const PaddedBrick& brick, bool ownCellsOnly, const float* values, const ExactPieces& piece,
              const ExactRay& ray)
        : reciprocalWidth(0.5 / brick.cellWidth())
    {
        const vec3i n = brick.paddedSize();
        for (int axis = 0; axis < 3; ++axis) {
            const int plane = piece.centerBelow(axis, brick.level);
            const int half = brick.cellWidth();
            index[axis] = std::clamp((plane - 2 * brick.lower[axis] + half) / (2 * half), 0, brick.size[axis]);
            counts[axis][0] = !ownCellsOnly || index[axis] > 0;
            counts[axis][1] = !ownCellsOnly || index[axis] < brick.size[axis];
            center[axis] = plane - ray.origin[axis];
        }
        strideY = std::size_t(n.x);
        strideZ = std::size_t(n.x) * n.y;
        corner = values + brick.begin + index.x + strideY * index.y + strideZ * index.z;
    }

    double value(int x, int y, int z) const { return corner[x + strideY * y + strideZ * z]; }

    /// Weights of the two cells at a position; 0 for those that do not count.
    void weigh(int axis, double position, double* w) const
    {
        const double f = std::clamp((position - center[axis]) * reciprocalWidth, 0.0, 1.0);
        w[0] = counts[axis][0] ? 1.0 - f : 0.0;
        w[1] = counts[axis][1] ? f : 0.0;
    }
};

/// A function that is linear along each axis on the box between a piece's ends, [z][y][x], as a cubic along the piece:
/// its blossom.
Cubic alongDiagonal(const double (&t)[2][2][2])
{
    return {t[0][0][0], (t[0][0][1] + t[0][1][0] + t[1][0][0]) / 3.0, (t[0][1][1] + t[1][0][1] + t[1][1][0]) / 3.0,
            t[1][1][1]};
}

void addBrick(const CellPairs& cells, const ExactPieces& piece, double reference, PieceQuotient& sum)
{
    double w[3][2][2], sums[3][2]; // [axis][end of the piece][cell]
    for (int axis = 0; axis < 3; ++axis) {
        cells.weigh(axis, piece.startPosition[axis], w[axis][0]);
        cells.weigh(axis, piece.endPosition[axis], w[axis][1]);
        for (int end = 0; end < 2; ++end)
            sums[axis][end] = w[axis][end][0] + w[axis][end][1];
    }
    double rows[2][2][2], planes[2][2][2], n[2][2][2], d[2][2][2];
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y) {
            const double a = cells.value(0, y, z) - reference, b = cells.value(1, y, z) - reference;
            for (int x = 0; x < 2; ++x)
                rows[z][y][x] = w[0][x][0] * a + w[0][x][1] * b;
            sum.largest = std::max({sum.largest, std::abs(a), std::abs(b)});
        }
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x)
                planes[z][y][x] = w[1][y][0] * rows[z][0][x] + w[1][y][1] * rows[z][1][x];
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x) {
                n[z][y][x] = w[2][z][0] * planes[0][y][x] + w[2][z][1] * planes[1][y][x];
                d[z][y][x] = sums[0][x] * sums[1][y] * sums[2][z];
            }
    const Cubic cubicN = alongDiagonal(n), cubicD = alongDiagonal(d);
    for (int i = 0; i < 4; ++i) {
        sum.n[i] += cubicN[i];
        sum.d[i] += cubicD[i];
    }
}

/// The gradient of N - reference D, which at B = reference is D times that of B.
void addGradient(const CellPairs& cells, const vec3d& position, double reference, vec3d& gradient, double& d)
{
    double w[3][2], slope[3][2];
    for (int axis = 0; axis < 3; ++axis) {
        cells.weigh(axis, position[axis], w[axis]);
        for (int i = 0; i < 2; ++i)
            slope[axis][i] = cells.counts[axis][i] ? (i ? 1.0 : -1.0) * cells.reciprocalWidth : 0.0;
    }
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 2; ++x) {
                const double v = cells.value(x, y, z) - reference;
                gradient.x += v * slope[0][x] * w[1][y] * w[2][z];
                gradient.y += v * w[0][x] * slope[1][y] * w[2][z];
                gradient.z += v * w[0][x] * w[1][y] * slope[2][z];
                d += w[0][x] * w[1][y] * w[2][z];
            }
}

template <class Visit>
void forEachBrick(const RegionTree& tree, const Region& region, const float* values, const ExactPieces& piece,
                  const ExactRay& ray, const Visit& visit)
{
    for (std::uint32_t i = 0; i < region.brickCount; ++i)
        visit(
            CellPairs(tree.bricks[tree.brickLists[region.firstBrick + i]], region.brickCount > 1, values, piece, ray));
}

} // namespace

ExactRay::ExactRay(const RayTile& rays, int ray, const vec3i& sceneOrigin)
    : origin(sceneOrigin), tNear(rays.tNear[ray]), tFar(rays.tFar[ray])
{
    for (int axis = 0; axis < 3; ++axis) {
        // The threshold of WideWalk.
        const float direction = rays.dir[axis][ray];
        flat[axis] = std::abs(direction) < 1e-28f;
        org[axis] = 2.0 * rays.org[axis][ray];
        dir[axis] = flat[axis] ? 0.0 : 2.0 * direction;
        reciprocal[axis] = flat[axis] ? 0.0 : 1.0 / dir[axis];
    }
}

int ExactRay::nearPlane(const Region& region, int axis) const
{
    return backwards(axis) ? region.upper[axis] : region.lower[axis];
}

int ExactRay::farPlane(const Region& region, int axis) const
{
    return backwards(axis) ? region.lower[axis] : region.upper[axis];
}

ExactPieces::ExactPieces(const Region& region, const ExactRay& ray, double from)
    : start(std::max(from, ray.tNear)), region_(region), ray_(ray), tOut_(ray.tFar)
{
    for (int axis = 0; axis < 3; ++axis) {
        start = std::max(start, ray.time(axis, ray.nearPlane(region, axis)));
        tOut_ = std::min(tOut_, ray.time(axis, ray.farPlane(region, axis)));
    }
    if (done())
        return;
    startPosition = ray.at(start);
    for (int axis = 0; axis < 3; ++axis) {
        const int plane = ray.nearPlane(region, axis);
        if (ray.time(axis, plane) == start)
            startPosition[axis] = plane - ray.origin[axis];
        for (int level = region.finestLevel; level <= region.coarsestLevel; ++level)
            findPlane(axis, level);
    }
    findEnd();
}

/// The first plane behind `start`: a guess from the position, put right by the planes' own times.
void ExactPieces::findPlane(int axis, int level)
{
    const int half = 1 << level;
    const double cells = 0.5 * ((startPosition[axis] + ray_.origin[axis]) / half - 1.0);
    const bool backwards = ray_.backwards(axis);
    const int step = backwards ? -2 * half : 2 * half;
    const double i = backwards ? std::ceil(cells) - 1.0 : std::floor(cells) + 1.0;
    int plane = (2 * static_cast<int>(i) + 1) * half;
    while (!(ray_.time(axis, plane) > start))
        plane += step;
    while (ray_.time(axis, plane - step) > start)
        plane -= step;
    plane_[axis][level] = plane;
    time_[axis][level] = ray_.time(axis, plane);
}

void ExactPieces::findEnd()
{
    end = tOut_;
    for (int axis = 0; axis < 3; ++axis)
        for (int level = region_.finestLevel; level <= region_.coarsestLevel; ++level)
            end = std::min(end, time_[axis][level]);
    endPosition = ray_.at(end);
    for (int axis = 0; axis < 3; ++axis) {
        // Rounding must not carry a position beyond the next plane, nor back.
        const int far = ray_.farPlane(region_, axis);
        double limit = ray_.time(axis, far) == end ? far - ray_.origin[axis] : endPosition[axis];
        for (int level = region_.finestLevel; level <= region_.coarsestLevel; ++level)
            if (time_[axis][level] == end)
                limit = plane_[axis][level] - ray_.origin[axis];
        endPosition[axis] = limit;
    }
}

void ExactPieces::next()
{
    start = end;
    startPosition = endPosition;
    if (done())
        return;
    for (int axis = 0; axis < 3; ++axis)
        for (int level = region_.finestLevel; level <= region_.coarsestLevel; ++level)
            while (!(time_[axis][level] > start)) {
                plane_[axis][level] += (ray_.backwards(axis) ? -2 : 2) * (1 << level);
                time_[axis][level] = ray_.time(axis, plane_[axis][level]);
            }
    findEnd();
}

int ExactPieces::centerBelow(int axis, int level) const
{
    return ray_.backwards(axis) ? plane_[axis][level] : plane_[axis][level] - 2 * (1 << level);
}

PieceQuotient quotientOf(const RegionTree& tree, const Region& region, const float* values, const ExactPieces& piece,
                         const ExactRay& ray, double reference)
{
    PieceQuotient sum{{}, {}, 0.0};
    forEachBrick(tree, region, values, piece, ray,
                 [&](const CellPairs& cells) { addBrick(cells, piece, reference, sum); });
    sum.reduce();
    return sum;
}

vec3d gradientAt(const RegionTree& tree, const Region& region, const float* values, const ExactPieces& piece,
                 const ExactRay& ray, const vec3d& position, double reference)
{
    vec3d gradient(0.0);
    double d = 0.0;
    forEachBrick(tree, region, values, piece, ray,
                 [&](const CellPairs& cells) { addGradient(cells, position, reference, gradient, d); });
    return d > 0.0 ? gradient / d : vec3d(0.0);
}

} // namespace brickwall
