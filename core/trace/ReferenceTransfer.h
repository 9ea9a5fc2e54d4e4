// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/TransferFunction.h"

#include <span>
#include <vector>

namespace brickwall::reference {

/// The knots of a transfer function: the values between which colour and extinction are smooth. These are all its
/// points, the ends of its range, and where its opacity cap sets in.
class Knots
{
public:
    explicit Knots(const TransferFunction& tf);

    /// Those inside the open interval (lo, hi), ascending.
    std::span<const double> within(double lo, double hi) const;

    /// No value in the open interval (lo, hi) has an extinction.
    bool transparent(double lo, double hi) const;

    /// A knot that is no further than `noise` from the value, or else the value.
    double snapped(double value, double noise) const;

    double largestExtinction() const { return largestExtinction_; }

private:
    double largestExtinction_ = 0.0;
    std::vector<double> values_;
    std::vector<bool> transparent_; ///< [i]: below values_[i] and above values_[i - 1]
};

} // namespace brickwall::reference
