// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

#include <array>

namespace brickwall::reference {

/// The Gauss-Kronrod pair of 7 and 15 points over [-1, 1] (Piessens et al., "QUADPACK", 1983).
struct KronrodRule
{
    static constexpr int count = 15;

    std::array<double, count> node; ///< ascending
    std::array<double, count> weight;
    std::array<double, count> gaussWeight; ///< 0 at nodes that the 7-point rule does not have
    /// [j][i]: the integral from -1 to node[j] of the polynomial that is 1 at node[i] and 0 at the others.
    std::array<std::array<double, count>, count> upTo;

    static const KronrodRule& get();

private:
    KronrodRule();
};

/// What a ray has collected, front to back.
struct Collected
{
    static constexpr double leastTransmittance = 1e-14; ///< behind it nothing counts

    vec3d color{0.0};
    double transmittance = 1.0;
    double weightedDistance = 0.0;

    bool opaque() const { return transmittance < leastTransmittance; }

    /// A thin layer at t.
    void addLayer(double t, const vec3d& layerColor, double opacity);
};

/// Extinction and colour at a place.
struct Medium
{
    double extinction;
    vec3d color;
};

/// Integrates c sigma T dt over stretches in which c and sigma are smooth, by bisection until the rules of 7 and 15
/// points agree. The optical depth at the 15 points is the exact integral of the polynomial through all 15 extinctions.
class EmissionAbsorption
{
public:
    /// `largestExtinction` is what there is to be expected anywhere: next to it, too little is not worth more digits.
    EmissionAbsorption(double relativeTolerance, double largestExtinction);

    /// `medium(s)` is the place at t0 + s length; the stretch is [a, b] in s, whose ends are never asked for.
    template <class Function>
    void add(const Function& medium, double t0, double length, double a, double b, Collected& ray) const;

private:
    /// One application of the rules to a stretch.
    struct Estimate
    {
        double depth;           ///< optical depth
        double absorbed;        ///< of what enters the stretch
        vec3d color;            ///< per transmittance at the stretch's start, as is the next
        double distance;        ///< sum of what is absorbed times its t
        double distrust = 0.0;  ///< error estimate relative to `absorbed`
        vec3d firstColor{0.0};  ///< at the first node
        double firstDistance{}; ///< t there
    };
    using Media = std::array<Medium, KronrodRule::count>;

    Estimate estimate(const Media& media, double tMiddle, double halfLength) const;
    static void accept(const Estimate& e, Collected& ray);

    /// The stretch in hand; `distrust` is that of the stretch it is half of.
    struct Half
    {
        double a, b;
        int depth;
        double distrust;
    };

    bool goodEnough(const Estimate& e, const Half& half, int estimates) const;

    template <class Function>
    void bisect(const Function& medium, double t0, double length, const Half& half, int& estimates,
                Collected& ray) const;

    double tolerance_;
    double largestExtinction_;
};

template <class Function>
void EmissionAbsorption::add(const Function& medium, double t0, double length, double a, double b, Collected& ray) const
{
    int estimates = 0;
    bisect(medium, t0, length, {a, b, 0, 0.0}, estimates, ray);
}

template <class Function>
void EmissionAbsorption::bisect(const Function& medium, double t0, double length, const Half& half, int& estimates,
                                Collected& ray) const
{
    if (ray.opaque())
        return;
    const double middle = 0.5 * (half.a + half.b), radius = 0.5 * (half.b - half.a);
    Media media;
    for (int i = 0; i < KronrodRule::count; ++i)
        media[i] = medium(middle + radius * KronrodRule::get().node[i]);
    const Estimate e = estimate(media, t0 + middle * length, radius * length);
    if (goodEnough(e, half, ++estimates))
        return accept(e, ray);
    bisect(medium, t0, length, {half.a, middle, half.depth + 1, e.distrust}, estimates, ray);
    bisect(medium, t0, length, {middle, half.b, half.depth + 1, e.distrust}, estimates, ray);
}

} // namespace brickwall::reference
