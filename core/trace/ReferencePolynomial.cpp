// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/ReferencePolynomial.h"

#include <algorithm>

namespace brickwall::reference {
namespace {

/// Zeros do not count.
template <int degree>
int signChanges(const Bernstein<degree>& p)
{
    int changes = 0;
    double last = 0.0;
    for (double c : p.b) {
        if (c == 0.0)
            continue;
        changes += last != 0.0 && std::signbit(last) != std::signbit(c);
        last = c;
    }
    return changes;
}

/// Roots in (a, b) of a polynomial that has the form `part` over it.
template <int degree>
void isolate(const Bernstein<degree>& part, double a, double b, std::vector<double>& roots)
{
    const int changes = signChanges(part);
    if (changes == 0)
        return;
    if (b - a < 1e-12) {
        if (changes % 2 == 1)
            roots.push_back(0.5 * (a + b));
        return;
    }
    if (changes == 1) {
        const auto zero = [](double c) { return c == 0.0; };
        const double first = *std::find_if_not(part.b.begin(), part.b.end(), zero);
        const double last = *std::find_if_not(part.b.rbegin(), part.b.rend(), zero);
        roots.push_back(a + bracketedRoot(part, 0.0, 1.0, first, last) * (b - a));
        return;
    }
    const double middle = 0.5 * (a + b);
    const auto [left, right] = part.halves();
    isolate(left, a, middle, roots);
    if (left.b[degree] == 0.0)
        roots.push_back(middle);
    isolate(right, middle, b, roots);
}

} // namespace

template <int degree>
void appendSignChanges(const Bernstein<degree>& p, std::vector<double>& roots)
{
    isolate(p, 0.0, 1.0, roots);
}

template void appendSignChanges(const Bernstein<2>&, std::vector<double>&);
template void appendSignChanges(const Bernstein<5>&, std::vector<double>&);

Bernstein<2> derivative(const Cubic& p)
{
    return {{3.0 * (p.b[1] - p.b[0]), 3.0 * (p.b[2] - p.b[1]), 3.0 * (p.b[3] - p.b[2])}};
}

Bernstein<5> slopeNumerator(const Cubic& n, const Cubic& d)
{
    constexpr double binomial2[3] = {1, 2, 1}, binomial3[4] = {1, 3, 3, 1}, binomial5[6] = {1, 5, 10, 10, 5, 1};
    const Bernstein<2> dn = derivative(n), dd = derivative(d);
    Bernstein<5> q;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 4; ++j)
            q.b[i + j] += binomial2[i] * binomial3[j] * (dn.b[i] * d.b[j] - n.b[j] * dd.b[i]);
    for (int k = 0; k < 6; ++k)
        q.b[k] /= binomial5[k];
    return q;
}

} // namespace brickwall::reference
