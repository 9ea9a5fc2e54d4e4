// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Range.h"
#include "brickwall/core/base/Vec.h"
#include "brickwall/core/shade/TransferFunction.h"

#include <vector>

namespace brickwall {

/// A transfer function as segments that are linear in the value v, and its antiderivatives
///   S(v) = int_lo^v sigma dv     and     Q(v) = int_lo^v c sigma dv,
/// so that the mean extinction and emission of a field that runs linearly from a to b are (S(b) - S(a)) / (b - a) and
/// (Q(b) - Q(a)) / (b - a): the one-dimensional pre-integration of Williams, Max and others, without a table's blur.
///
/// Extinction is per finest cell, S and Q in units of the value times that; both are continuous, constant outside the
/// range, where the density is 0. sigma(v) and c(v) sigma(v) are met within 1e-5 of sigma(v) plus 1e-9 of the largest
/// extinction, as far as a float tells values from each other. Steps (points at equal t) stay steps, the upper side's
/// limit at the knot itself; at range.hi the lower side's. Spikes of any width keep their knots, but for those that lie
/// between two neighbouring floats.
///
/// Plain data, immutable once made, the lanes' layout documented for TransferIntegralLookup.
struct TransferIntegral
{
    /// From its lower knot to the next; four components each: red, green, blue of Q, or of c sigma, then S, or sigma.
    struct alignas(64) Segment
    {
        vec4f integral; ///< at the lower knot, as a float,
        vec4f rest;     ///< and what that lacks to nearly double precision
        vec4f density;  ///< at the lower knot, the limit from above
        vec4f slope;    ///< d density / dv
    };

    Range range;
    Scale scale = Scale::linear;
    std::vector<float> knots;      ///< ascending; the lower one of every segment, then range.hi
    std::vector<Segment> segments; ///< at least one
    float colorSlope = 0.0f;       ///< how fast a component of the colour changes with the value, at most
    Range visible;                 ///< the hull of the values with an extinction above 0; may be empty
    bool opensWithStep = false;    ///< visible at range.lo,
    bool closesWithStep = false;   ///< and at range.hi

    /// Buckets of values, uniform in v, or in the bits of v if the scale is logarithmic. The segments that reach into
    /// bucket b are firstSegments[b] to firstSegments[b + 1], as floats, which hold such integers exactly: nearly
    /// always one or two. The same arithmetic in the same order gives the same bucket in lanes.
    std::vector<float> firstSegments;
    float bucketsPerUnit = 0.0f; ///< linear: bucket = int((v - range.lo) * bucketsPerUnit)
    int bucketShift = 0;         ///< logarithmic: bucket = (bits(v) - bits(range.lo)) >> bucketShift

    /// The density in a bucket as a line, where that meets the segments within 1e-4 of sigma(v) plus 1e-6 of the
    /// largest extinction; NaN where it does not, as at steps and spikes.
    struct alignas(32) Bucket
    {
        vec4f density; ///< at the lower end
        vec4f rise;    ///< to the upper end
    };
    std::vector<Bucket> buckets;

    /// Sparse tables: [k][i] = max over segments i .. i + 2^k - 1.
    std::vector<std::vector<float>> maxExtinction;
    std::vector<std::vector<float>> maxVariation;    ///< infinite where a segment begins with a step
    std::vector<std::vector<float>> maxLogVariation; ///< the same per ln v; only if the scale is logarithmic

    int bucketCount() const { return int(firstSegments.size()) - 1; }
    /// Of a value inside the range.
    int bucketOf(float value) const;
    /// The segment that a value of the range lies in, the upper one at a knot.
    int segmentOf(float value) const;

    /// The largest extinction over the values of `r`, spikes of any width included. O(1).
    float largestExtinction(const Range& r) const;

    /// How fast what is seen changes with the value, at most, over the segments that the values of `r` touch: the
    /// largest of |d(c sigma)/dv|, |d((1 - c) sigma)/dv| and |d sigma/dv|; infinite if there is a step inside. O(1).
    float largestVariation(const Range& r) const;
    /// The same per ln v; infinite, too, if the scale is not logarithmic.
    float largestLogVariation(const Range& r) const;
};

/// Checks `tf`, then integrates it, in double.
TransferIntegral integrate(const TransferFunction& tf);

} // namespace brickwall
