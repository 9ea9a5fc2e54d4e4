// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferIntegral.h"

#include "brickwall/core/shade/TransferIntegralTables.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brickwall {
namespace {

constexpr double relativeTolerance = 1.3e-5; // of chords; lines between them and the function err by two thirds
constexpr double absoluteTolerance = 1e-9;

/// Between two neighbouring points of colour or opacity: everything is smooth here. Its ends are the floats next to
/// where the points are; what is in between moves along with them.
struct Piece
{
    float lo, hi;              ///< values
    double t0, t1;             ///< of them
    double opacity0, opacity1; ///< times opacityScale, limits from inside
    vec3d color0, color1;
};

enum class Side { below, above };

/// The limit of the points' polygon at t from one side; `get` takes a point's value.
template <class Point, class Get>
auto limitAt(const std::vector<Point>& points, double t, Side side, const Get& get)
{
    const auto end = side == Side::above ? std::upper_bound(points.begin(), points.end(), t,
                                                            [](double x, const Point& p) { return x < double(p.t); })
                                         : std::lower_bound(points.begin(), points.end(), t,
                                                            [](const Point& p, double x) { return double(p.t) < x; });
    if (end == points.begin())
        return get(points.front());
    if (end == points.end())
        return get(points.back());
    const double t0 = double((end - 1)->t), t1 = double(end->t);
    const double f = (t - t0) / (t1 - t0);
    return get(*(end - 1)) * (1.0 - f) + get(*end) * f; // exact at both ends, so that only steps are steps
}

double opacityLimit(const TransferFunction& tf, double t, Side side)
{
    return limitAt(tf.opacity, t, side, [](const OpacityPoint& p) { return double(p.value); }) * tf.opacityScale;
}

vec3d colorLimit(const TransferFunction& tf, double t, Side side)
{
    return limitAt(tf.colors, t, side, [](const ColorPoint& p) { return vec3d(p.color); });
}

/// Where the function is not smooth in t, the ends and the places where the opacity is cut off included.
std::vector<double> breaksOf(const TransferFunction& tf)
{
    std::vector<double> breaks{0.0, 1.0};
    for (const ColorPoint& p : tf.colors)
        breaks.push_back(p.t);
    for (const OpacityPoint& p : tf.opacity)
        breaks.push_back(p.t);
    for (std::size_t i = 1; i < tf.opacity.size() && tf.kind == TransferFunction::Kind::opacity; ++i) {
        const double a = double(tf.opacity[i - 1].value) * tf.opacityScale - TransferFunction::opacityCap;
        const double b = double(tf.opacity[i].value) * tf.opacityScale - TransferFunction::opacityCap;
        if (a * b < 0.0)
            breaks.push_back(std::lerp(double(tf.opacity[i - 1].t), double(tf.opacity[i].t), a / (a - b)));
    }
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return breaks;
}

float valueAt(const TransferFunction& tf, double t)
{
    if (t <= 0.0)
        return tf.range.lo;
    if (t >= 1.0)
        return tf.range.hi;
    const double lo = tf.range.lo, hi = tf.range.hi;
    const double v = tf.scale == Scale::linear ? lo + t * (hi - lo) : lo * std::exp(t * std::log(hi / lo));
    return std::clamp(float(v), tf.range.lo, tf.range.hi);
}

double extinctionOf(const TransferFunction& tf, double opacity)
{
    if (tf.kind == TransferFunction::Kind::extinction)
        return opacity;
    return -std::log1p(-std::min(opacity, double(TransferFunction::opacityCap))) / tf.referenceLength;
}

/// c sigma and sigma.
vec4d densityAt(const TransferFunction& tf, const Piece& piece, double value)
{
    const double x =
        value >= piece.hi ? 1.0 : std::clamp((normalized(tf, value) - piece.t0) / (piece.t1 - piece.t0), 0.0, 1.0);
    const double extinction = extinctionOf(tf, std::lerp(piece.opacity0, piece.opacity1, x));
    return vec4d((piece.color0 * (1.0 - x) + piece.color1 * x) * extinction, extinction);
}

/// Makes the segments, one piece after the other.
class Integrator
{
public:
    Integrator(const TransferFunction& tf, TransferIntegral& result) : tf_(tf), result_(result)
    {
        for (const OpacityPoint& p : tf.opacity)
            largest_ = std::max(largest_, extinctionOf(tf, double(p.value) * tf.opacityScale));
    }

    /// As few segments as the tolerance allows.
    void add(const Piece& piece)
    {
        std::vector<Knot> knots = chordsOf(piece);
        // Chords lie on one side of the function. Knots moved towards the other by two thirds of what the chords err in
        // their middle keep the integral; the ends stay, so that what is continuous stays so.
        for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
            knots[i].density -= (knots[i].sag + knots[i + 1].sag) / 3.0;
            for (int c = 0; c < 4; ++c)
                knots[i].density[c] = std::max(knots[i].density[c], 0.0);
        }
        for (std::size_t i = 1; i < knots.size(); ++i)
            append(knots[i - 1].value, knots[i - 1].density, knots[i].value, knots[i].density);
    }

    /// Whether a segment begins with a step.
    const std::vector<bool>& steps() const { return steps_; }
    bool endsVisible() const { return last_.w > 0.0; }

private:
    static double neighbour(double v, double towards) { return std::nextafter(float(v), float(towards)); }

    struct Knot
    {
        double value;
        vec4d density;
        vec4d sag; ///< of the chord from the knot before, in its middle
    };

    std::vector<Knot> chordsOf(const Piece& piece) const
    {
        const double end = piece.hi;
        std::vector<Knot> knots{{piece.lo, densityAt(tf_, piece, piece.lo), {}}};
        double width = end - piece.lo;
        while (knots.back().value < end) {
            const Knot& from = knots.back();
            const double least = neighbour(from.value, end);
            Knot to = knotAt(piece, std::min(std::max(double(float(from.value + width)), least), end));
            double error = errorOf(piece, from, to);
            while (error > 1.0 && to.value > least) {
                const double shorter = (to.value - from.value) * std::clamp(0.95 / std::sqrt(error), 0.1, 0.8);
                const double most = neighbour(to.value, from.value);
                to = knotAt(piece, std::clamp(double(float(from.value + shorter)), least, most));
                error = errorOf(piece, from, to);
            }
            width = (to.value - from.value) * std::clamp(0.95 / std::sqrt(error + 1e-30), 0.5, 2.0);
            knots.push_back(to);
        }
        return knots;
    }

    Knot knotAt(const Piece& piece, double value) const { return {value, densityAt(tf_, piece, value), {}}; }

    /// Of a chord, over the tolerance.
    double errorOf(const Piece& piece, const Knot& from, Knot& to) const
    {
        double worst = 0.0;
        for (const double f : {0.125, 0.25, 0.75, 0.5}) {
            const vec4d exact = densityAt(tf_, piece, from.value + f * (to.value - from.value));
            const double allowed = relativeTolerance * exact.w + absoluteTolerance * largest_;
            to.sag = from.density * (1.0 - f) + to.density * f - exact;
            for (int c = 0; c < 4; ++c)
                if (const double error = std::abs(to.sag[c]); error > 0.0)
                    worst = std::max(worst, error / allowed);
        }
        return worst; // the middle was last
    }

    void append(double v0, const vec4d& d0, double v1, const vec4d& d1)
    {
        const vec4f rounded(sum_);
        const vec4d slope = (d1 - d0) / (v1 - v0);
        result_.knots.push_back(float(v0));
        result_.segments.push_back({rounded, vec4f(sum_ - vec4d(rounded)), vec4f(d0), vec4f(slope)});
        steps_.push_back(!steps_.empty() && d0 != last_);
        sum_ += 0.5 * (v1 - v0) * (d0 + d1);
        last_ = d1;
        if (d0.w > 0.0 || d1.w > 0.0)
            result_.visible.extend({float(v0), float(v1)});
    }

    const TransferFunction& tf_;
    TransferIntegral& result_;
    double largest_ = 0.0;
    vec4d sum_{0.0};
    vec4d last_{0.0};
    std::vector<bool> steps_;
};

/// Between two breaks: of the steepest component, where it is steepest. Infinite if the colour jumps at the first.
float colorSlopeOf(const TransferFunction& tf, double t0, double t1)
{
    const vec3d change = glm::abs(colorLimit(tf, t1, Side::below) - colorLimit(tf, t0, Side::above));
    const double most = std::max({change.x, change.y, change.z});
    if (colorLimit(tf, t0, Side::below) != colorLimit(tf, t0, Side::above))
        return std::numeric_limits<float>::infinity();
    if (most == 0.0)
        return 0.0f;
    const double lo = tf.range.lo, hi = tf.range.hi;
    const double perValue = tf.scale == Scale::linear ? 1.0 / (hi - lo) : 1.0 / (valueAt(tf, t0) * std::log(hi / lo));
    return static_cast<float>(most / (t1 - t0) * perValue);
}

} // namespace

TransferIntegral integrate(const TransferFunction& tf)
{
    checkTransferFunction(tf, "transfer function");
    TransferIntegral result;
    result.range = tf.range;
    result.scale = tf.scale;
    const std::vector<double> breaks = breaksOf(tf);
    Integrator integrator(tf, result);
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const double t0 = breaks[i - 1], t1 = breaks[i];
        const float lo = valueAt(tf, t0), hi = valueAt(tf, t1);
        result.colorSlope = std::max(result.colorSlope, colorSlopeOf(tf, t0, t1));
        if (lo < hi) // or it is narrower than floats tell
            integrator.add({lo, hi, normalized(tf, lo), normalized(tf, hi), opacityLimit(tf, t0, Side::above),
                            opacityLimit(tf, t1, Side::below), colorLimit(tf, t0, Side::above),
                            colorLimit(tf, t1, Side::below)});
    }
    result.knots.push_back(tf.range.hi);
    result.opensWithStep = result.segments.front().density.w > 0.0f;
    result.closesWithStep = integrator.endsVisible();
    tabulateQueries(result, integrator.steps());
    return result;
}

} // namespace brickwall
