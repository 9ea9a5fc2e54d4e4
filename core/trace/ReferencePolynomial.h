// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace brickwall::reference {

/// A polynomial over s in [0, 1] in Bernstein form: bounded by its coefficients, and with no more roots in (0, 1) than
/// they change their sign.
template <int degree>
struct Bernstein
{
    std::array<double, degree + 1> b{};

    /// By de Casteljau's algorithm, in the form that keeps relative precision where all coefficients have one sign.
    double operator()(double s) const
    {
        std::array<double, degree + 1> c = b;
        for (int last = degree; last > 0; --last)
            for (int i = 0; i < last; ++i)
                c[i] = (1.0 - s) * c[i] + s * c[i + 1];
        return c[0];
    }

    /// The parts over [0, 1/2] and [1/2, 1], each over a parameter of its own in [0, 1].
    std::pair<Bernstein, Bernstein> halves() const
    {
        std::pair<Bernstein, Bernstein> parts{*this, *this};
        auto& left = parts.first.b;
        auto& right = parts.second.b;
        for (int last = degree; last > 0; --last) {
            left[degree - last] = right[0];
            for (int i = 0; i < last; ++i)
                right[i] = 0.5 * (right[i] + right[i + 1]);
        }
        left[degree] = right[0];
        return parts;
    }
};

using Cubic = Bernstein<3>;

/// Appends where `p` changes its sign inside (0, 1), ascending; an interval of roots counts as none, roots closer than
/// 1e-12 may count as one or none.
template <int degree>
void appendSignChanges(const Bernstein<degree>& p, std::vector<double>& roots);

extern template void appendSignChanges(const Bernstein<2>&, std::vector<double>&);
extern template void appendSignChanges(const Bernstein<5>&, std::vector<double>&);

/// n' d - n d', the numerator of the derivative of n / d.
Bernstein<5> slopeNumerator(const Cubic& n, const Cubic& d);

/// The derivative.
Bernstein<2> derivative(const Cubic& p);

/// Where a continuous f changes its sign in [a, b], to the last bits (Chandrupatla, "A new hybrid quadratic/bisection
/// algorithm for finding the zero of a nonlinear function", 1997). `fa` and `fb` have the signs that count at the ends,
/// which those of f may differ from by rounding or where it is 0 at an end; they must differ from each other.
template <class Function>
double bracketedRoot(const Function& f, double a, double b, double fa, double fb)
{
    double x1 = a, x2 = b, f1 = fa, f2 = fb, t = 0.5;
    for (int step = 0; step < 200; ++step) {
        const double x = x1 + t * (x2 - x1), fx = f(x);
        if (fx == 0.0)
            return x;
        double x3 = x1, f3 = f1;
        if (std::signbit(fx) != std::signbit(f1)) {
            x3 = x2, f3 = f2;
            x2 = x1, f2 = f1;
        }
        x1 = x, f1 = fx;
        const double best = std::abs(f1) < std::abs(f2) ? x1 : x2;
        const double least = 2.3e-16 * (std::abs(best) + 1e-3 * (b - a)) / std::abs(x2 - x1);
        if (least > 0.5)
            return best;
        const double xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);
        t = 0.5;
        if (phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi)
            t = f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
        t = std::isfinite(t) ? std::fmin(std::fmax(t, least), 1.0 - least) : 0.5;
    }
    return x1;
}

} // namespace brickwall::reference
