// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

/// The numbers of the bounded method that do not follow from mathematics. The error that it keeps is an estimate; these
/// say how far the estimate is trusted. Those marked "tuned" are the cheapest values (time per frame at equal error,
/// `brickwall chart`) with which every scene and transfer function of tests/accuracy still stays within its tolerance,
/// with room to spare; whoever changes one runs these tests. The rest is what 32-bit floats tell apart.
namespace brickwall::tuning {

// The tolerance, and who gets what of it.

/// Of the tolerance that may be spent: the estimates are no proofs. Tuned.
inline constexpr float usedShare = 0.75f;
/// Of the tolerance, within usedShare, for the light behind the place where a ray ends for being nearly opaque.
inline constexpr float endShare = 1.0f / 32.0f;
/// Of the tolerance: where it has been overdrawn, this much is still to be had, so that the work ends.
inline constexpr float leastLeft = 0.05f;

// Steps with one sample each.

/// A sample would err by T variationAlong h^2 / 4 if all went as badly as its region allows (RegionBounds). How much
/// less it is taken to be. Tuned: taken at its word, the bound is some 30 times too pessimistic (steps of 0.01 cells at
/// a tolerance of 1/255).
inline constexpr float trust = 6.0f;
/// How much longer than that steps may be where samples resolve what is there. Tuned.
inline constexpr float resolvedTrust = 2.5f;
/// They do where the extinction changes by at most this share of its largest from one sample to the next.
inline constexpr float resolvedChange = 1.0f;
/// Of a cell: shorter steps pay less than taking each piece between cell centres by itself, in regions of one brick and
/// of several. Tuned for time alone.
inline constexpr float shortestStep = 0.12f;
inline constexpr float shortestStepOfSeveral = 0.06f;
/// Of a cell, too: the first step along a ray.
inline constexpr float firstStep = 0.5f;
/// How much more than by its length a short step may err, squared. Tuned.
inline constexpr float mostShortSteps = 2.0f;
/// A step is taken if it errs by at most this many times its share, and the next one is shorter; else it is tried
/// again. (Errors grow with h^2, their squares per length with h^3, biases per length with h^2: what is over is made up
/// for.)
inline constexpr float acceptedExcess = 4.0f;
inline constexpr float shorten = 0.6f;  ///< the next step, if this one erred by more than its share,
inline constexpr float lengthen = 1.5f; ///< or by less than these parts of it:
inline constexpr float tooFineSquare = 0.3f;
inline constexpr float tooFineBias = 0.4f;

// Parts of pieces.

/// Of the squared change of the cosine over half a part: what its parabola may be wrong by. Tuned.
inline constexpr float turnShare = 0.02f;
/// The same for a part that was looked at at its ends alone: of the change, and whatever it is. Tuned.
inline constexpr float unseenTurnShare = 0.25f;
inline constexpr float unseenTurn = 0.02f;
/// What of the light may be wrong where it may dip between two places.
inline constexpr float unseenDip = 0.5f;
/// Of the difference in colour within a part, per optical depth: how far its mean is off because the front hides the
/// back. (A colour running linearly through a thin part errs by a twelfth of its change times the depth, and by a sixth
/// of what it differs from its mean; rounded up.)
inline constexpr float hidingPerDepth = 0.2f;
/// Of a piece: shorter parts are taken as they are.
inline constexpr float shortestPart = 0x1p-14f;

// What floats tell apart.

/// Of a part's opacity: smaller errors are rounding.
inline constexpr float opacityRounding = 1e-5f;
/// Of the values of B on a piece: some roundings, by which values that should be equal may differ,
inline constexpr float valueRounding = 2e-7f;
/// of a knot of the transfer function: half of the last bit,
inline constexpr float knotRounding = 6e-8f;
/// and what enclosures of restricted cubics, after more operations, may be wider than B by.
inline constexpr float enclosureRounding = 1e-6f;
/// Of a position in cells: what rounding may put it off by.
inline constexpr float planeNoise = 1.2e-7f;
/// Of t, and of a cell: closer than this, rounding says which of two planes comes first.
inline constexpr float planeRounding = 4e-7f;
inline constexpr float planeRoundingInCells = 1e-6f;

} // namespace brickwall::tuning
