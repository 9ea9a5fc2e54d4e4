// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "TransferFunctions.h"

#include <array>
#include <string>

namespace brickwall::test {

inline constexpr std::array tolerances = {1e-1f, 1.0f / 255.0f, 1e-3f, 1e-4f};

/// The error of all views of a subject with one transfer function, shading and tolerance.
struct Kept
{
    double largest = 0.0;        ///< of any component of any pixel, against Method::reference
    double rms = 0.0;            ///< of all components of all pixels
    std::uint64_t pixels = 0;    ///< in all views
    std::uint64_t over = 0;      ///< pixels where a component is off by more than the tolerance
    std::uint64_t admitted = 0;  ///< pixels that the statistics say are beyond it
    std::uint64_t differing = 0; ///< pixels that are not the reference's, bit for bit
    std::string broken;          ///< empty, or the views that are off by more than the statistics admit
};

struct KeptOfShading
{
    std::array<Kept, tolerances.size()> of; ///< in the order of `tolerances`
    double opacity = 0.0;                   ///< the largest in the reference: whether there is anything to see
};

/// A known weakness (docs/accuracy.md, "What is outside"): with the headlight, a ray may enter the data where floats
/// hardly resolve the gradient. So many pixels of a view of 1024 may be over the tolerance without being admitted; of
/// smaller views none.
inline constexpr std::uint64_t unadmittedPixels = 2;

/// Renders three views of `size` x `size` pixels: from outside, from inside, and from outside through translucent
/// isosurfaces onto triangles in the middle of the data. By the reference once, by the bounded method for all
/// tolerances.
KeptOfShading measure(const Subject& subject, const TransferFunction& tf, Shading shading, int size);

} // namespace brickwall::test
