// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/ReferenceQuadrature.h"

#include <algorithm>
#include <cmath>

namespace brickwall::reference {
namespace {

struct HalfNode
{
    double node, weight, gaussWeight;
};

constexpr HalfNode halfNodes[8] = {
    {0.991455371120812639206854697526329, 0.022935322010529224963732008058970, 0.0},
    {0.949107912342758524526189684047851, 0.063092092629978553290700663189204, 0.129484966168869693270611432679082},
    {0.864864423359769072789712788640926, 0.104790010322250183839876322541518, 0.0},
    {0.741531185599394439863864773280788, 0.140653259715525918745189590510238, 0.279705391489276667901467771423780},
    {0.586087235467691130294144691258357, 0.169004726639267902826583426598550, 0.0},
    {0.405845151377397166906606412076961, 0.190350578064785409913256402421014, 0.381830050505118944950369775488975},
    {0.207784955007898467600689403773245, 0.204432940075298892414161999234649, 0.0},
    {0.000000000000000000000000000000000, 0.209482141084727828012999174891714, 0.417959183673469387755102040816327}};

/// The polynomial that is 1 at node i and 0 at the others.
double lagrange(const std::array<double, KronrodRule::count>& nodes, int i, double x)
{
    double product = 1.0;
    for (int k = 0; k < KronrodRule::count; ++k)
        if (k != i)
            product *= (x - nodes[k]) / (nodes[i] - nodes[k]);
    return product;
}

/// QUADPACK's estimate of the error of the finer of two rules from their difference.
double errorOf(double difference, double scale)
{
    return scale > 0.0 ? std::pow(200.0 * std::abs(difference) / scale, 1.5) : 0.0;
}

} // namespace

KronrodRule::KronrodRule()
{
    for (int i = 0; i < count; ++i) {
        const HalfNode& half = halfNodes[i < 8 ? i : 14 - i];
        node[i] = i < 8 ? -half.node : half.node;
        weight[i] = half.weight;
        gaussWeight[i] = half.gaussWeight;
    }
    // The rule itself is exact up to degree 22, and so for these of degree 14.
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) {
            const double half = 0.5 * (node[j] + 1.0);
            upTo[j][i] = 0.0;
            for (int k = 0; k < count; ++k)
                upTo[j][i] += half * weight[k] * lagrange(node, i, half * (1.0 + node[k]) - 1.0);
        }
}

const KronrodRule& KronrodRule::get()
{
    static const KronrodRule rule;
    return rule;
}

void Collected::addLayer(double t, const vec3d& layerColor, double opacity)
{
    color += transmittance * opacity * layerColor;
    weightedDistance += transmittance * opacity * t;
    transmittance *= 1.0 - opacity;
}

EmissionAbsorption::EmissionAbsorption(double relativeTolerance, double largestExtinction)
    : tolerance_(std::max(relativeTolerance, 1e-12)), // below it there is only rounding
      largestExtinction_(largestExtinction)
{
}

/// Rounding of B next to a knot or of a gradient next to none may keep the rules apart for ever. That is so if halving
/// does not help any more, and likely after many estimates; what is left must not take for ever either.
bool EmissionAbsorption::goodEnough(const Estimate& e, const Half& half, int estimates) const
{
    const double allowed = estimates < 300 ? 0.0 : estimates < 1000 ? 1e-7 : 1e-3;
    if (e.distrust <= std::max(tolerance_, allowed))
        return true;
    if (half.depth >= 8 && e.distrust < 1e-8 && e.distrust > 0.1 * half.distrust)
        return true;
    const int deepest = estimates < 3000 ? 50 : 12; // 50: the stretch is then shorter than the rounding of s
    return half.depth >= deepest;
}

EmissionAbsorption::Estimate EmissionAbsorption::estimate(const Media& media, double tMiddle, double halfLength) const
{
    const KronrodRule& rule = KronrodRule::get();
    Estimate e{};
    double gaussDepth = 0.0, absorbedSum = 0.0, gaussAbsorbed = 0.0;
    vec3d gaussColor(0.0);
    for (int j = 0; j < KronrodRule::count; ++j) {
        double depth = 0.0;
        for (int i = 0; i < KronrodRule::count; ++i)
            depth += rule.upTo[j][i] * media[i].extinction;
        const double extinction = media[j].extinction * halfLength;
        const double emitted = extinction * std::exp(-depth * halfLength);
        e.depth += rule.weight[j] * extinction;
        gaussDepth += rule.gaussWeight[j] * extinction;
        absorbedSum += rule.weight[j] * emitted;
        gaussAbsorbed += rule.gaussWeight[j] * emitted;
        e.color += rule.weight[j] * emitted * media[j].color;
        gaussColor += rule.gaussWeight[j] * emitted * media[j].color;
        e.distance += rule.weight[j] * emitted * rule.node[j] * halfLength;
    }
    e.absorbed = -std::expm1(-e.depth);
    e.distance += e.absorbed * tMiddle;
    e.firstColor = media[0].color;
    e.firstDistance = tMiddle + halfLength * rule.node[0];
    if (!(e.depth > 0.0))
        return e;
    const vec3d difference = e.color - gaussColor;
    const double unit = e.absorbed + 1e-15 / tolerance_ * std::min(1.0, largestExtinction_);
    e.distrust = std::max({std::abs(absorbedSum - e.absorbed) / unit, errorOf(gaussAbsorbed - absorbedSum, unit),
                           errorOf((gaussDepth - e.depth) * std::exp(-e.depth), unit), errorOf(difference.x, unit),
                           errorOf(difference.y, unit), errorOf(difference.z, unit)});
    return e;
}

/// Where a stretch absorbs faster than its parameter can be divided, all comes from its very start.
void EmissionAbsorption::accept(const Estimate& e, Collected& ray)
{
    const bool sharp = e.distrust > 1e-3;
    ray.color += ray.transmittance * (sharp ? e.absorbed * e.firstColor : e.color);
    ray.weightedDistance += ray.transmittance * (sharp ? e.absorbed * e.firstDistance : e.distance);
    ray.transmittance *= std::exp(-e.depth);
}

} // namespace brickwall::reference
