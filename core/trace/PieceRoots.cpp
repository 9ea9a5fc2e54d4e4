// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/PieceRoots.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

/// A cubic that is 0 at 0, divided by x and written as a cubic again.
Cubic withoutRootAtStart(const Cubic& c)
{
    const double a = 3.0 * c[1], b = 1.5 * c[2], e = c[3];
    return {a, (a + 2.0 * b) / 3.0, (2.0 * b + e) / 3.0, e};
}

Cubic reversed(const Cubic& c)
{
    return {c[3], c[2], c[1], c[0]};
}

void removeCommonRootsAtStart(PieceQuotient& q)
{
    for (int i = 0; i < 3 && q.d[0] == 0.0; ++i) {
        q.n = withoutRootAtStart(q.n);
        q.d = withoutRootAtStart(q.d);
    }
}

/// Ends of the stretches in [0, 1] on which a cubic is monotone.
struct Stretches
{
    int count = 1; ///< of stretches
    std::array<double, 4> ends{0.0, 1.0};

    explicit Stretches(const Cubic& c)
    {
        const double p = c[1] - c[0], q = c[2] - c[1], r = c[3] - c[2];
        const double a = p - 2.0 * q + r, halfB = q - p;
        const double discriminant = halfB * halfB - a * p;
        if (!(discriminant > 0.0))
            return;
        const double s = -(halfB + std::copysign(std::sqrt(discriminant), halfB));
        add(std::min(s / a, p / s));
        add(std::max(s / a, p / s));
    }

private:
    void add(double x)
    {
        if (x > ends[count - 1] && x < 1.0) {
            ends[count++] = x;
            ends[count] = 1.0;
        }
    }
};

double slope(const Cubic& c, double x)
{
    const double y = 1.0 - x;
    return 3.0 * (y * y * (c[1] - c[0]) + 2.0 * x * y * (c[2] - c[1]) + x * x * (c[3] - c[2]));
}

/// The root in [a, b], where the signs at the ends differ: Newton's steps, halved intervals where those leave it.
double refine(const Cubic& c, double a, double b, double atA, double atB)
{
    double x = a + (b - a) * (atA / (atA - atB));
    for (int i = 0; i < 100 && b - a > 1e-15; ++i) {
        const double f = evaluate(c, x);
        if (f == 0.0)
            return x;
        ((f > 0.0) == (atA > 0.0) ? a : b) = x;
        const double newton = x - f / slope(c, x);
        if (std::abs(newton - x) < 1e-16)
            return std::clamp(newton, a, b);
        x = newton > a && newton < b ? newton : 0.5 * (a + b);
    }
    return x;
}

/// Goes along the ends of the stretches, from sign to sign.
class Collector
{
public:
    Collector(const Cubic& f, const Cubic& d, double tolerance, SurfaceSide& side)
        : f_(f), d_(d), tolerance_(tolerance), side_(side)
    {
    }

    void start()
    {
        last_ = 0.0;
        lastValue_ = f_[0];
        // What has been counted as zero at the end of the piece before is zero here.
        if (side_.known && side_.sign == 0)
            return;
        const int sign = signOf(f_[0], d_[0]);
        if (side_.known ? sign != side_.sign : sign == 0)
            add(0.0);
        side_ = {true, sign};
    }

    void goTo(double x)
    {
        const double value = evaluate(f_, x);
        const int sign = signOf(value, evaluate(d_, x));
        if (side_.sign * sign < 0)
            add(refine(f_, last_, x, lastValue_, value));
        else if (side_.sign != 0 && sign == 0)
            add(x);
        side_.sign = sign;
        last_ = x;
        lastValue_ = value;
    }

    PieceRoots roots;

private:
    int signOf(double value, double d) const { return std::abs(value) <= tolerance_ * d ? 0 : value > 0.0 ? 1 : -1; }

    void add(double x) { roots.at[roots.count++] = x; }

    const Cubic& f_;
    const Cubic& d_;
    double tolerance_;
    SurfaceSide& side_;
    double last_ = 0.0, lastValue_ = 0.0;
};

} // namespace

void PieceQuotient::reduce()
{
    removeCommonRootsAtStart(*this);
    if (d[3] != 0.0)
        return;
    *this = {reversed(n), reversed(d), largest};
    removeCommonRootsAtStart(*this);
    *this = {reversed(n), reversed(d), largest};
}

double evaluate(const Cubic& c, double x)
{
    const double y = 1.0 - x;
    return y * y * (y * c[0] + 3.0 * x * c[1]) + x * x * (3.0 * y * c[2] + x * c[3]);
}

PieceRoots findRoots(const PieceQuotient& piece, double value, double tolerance, SurfaceSide& side)
{
    Cubic f;
    for (int i = 0; i < 4; ++i)
        f[i] = piece.n[i] - value * piece.d[i];
    const double most = tolerance * std::max({piece.d[0], piece.d[1], piece.d[2], piece.d[3]});
    const bool above = f[0] > most && f[1] > most && f[2] > most && f[3] > most;
    const bool below = f[0] < -most && f[1] < -most && f[2] < -most && f[3] < -most;
    Collector collector(f, piece.d, tolerance, side);
    collector.start();
    if (above || below) {
        side.sign = above ? 1 : -1;
    } else {
        const Stretches stretches(f);
        for (int i = 1; i <= stretches.count; ++i)
            collector.goTo(stretches.ends[i]);
    }
    return collector.roots;
}

} // namespace brickwall
