// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/PieceRoots.h"
#include "brickwall/tests/oracles/RandomLayout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace brickwall {
namespace {

/// The Bernstein coefficients of (x - a) (x - b) (x - c): its blossom.
Cubic withRoots(double a, double b, double c)
{
    const auto blossom = [&](double x, double y, double z) {
        return x * y * z - (a + b + c) / 3.0 * (x * y + y * z + z * x) + (a * b + b * c + c * a) / 3.0 * (x + y + z) -
               a * b * c;
    };
    return {blossom(0, 0, 0), blossom(0, 0, 1), blossom(0, 1, 1), blossom(1, 1, 1)};
}

std::vector<double> rootsOf(const Cubic& n, SurfaceSide side = {}, double tolerance = 1e-15)
{
    const PieceRoots roots = findRoots({n, {1, 1, 1, 1}, 1.0}, 0.0, tolerance, side);
    return {roots.at.begin(), roots.at.begin() + roots.count};
}

TEST(PieceRoots, AreThoseOfTheCubic)
{
    oracles::Random random(2);
    for (int i = 0; i < 100'000; ++i) {
        std::vector<double> wanted, all;
        for (int k = 0; k < 3; ++k) {
            all.push_back(2.0 * random.real() - 0.5);
            if (all.back() > 0.0 && all.back() < 1.0)
                wanted.push_back(all.back());
        }
        std::sort(wanted.begin(), wanted.end());
        bool close = false;
        for (std::size_t k = 1; k < wanted.size(); ++k)
            close = close || wanted[k] - wanted[k - 1] < 1e-4;
        for (const double root : all)
            close = close || std::abs(root) < 1e-4 || std::abs(root - 1.0) < 1e-4;
        if (close)
            continue;
        const std::vector<double> found = rootsOf(withRoots(all[0], all[1], all[2]));
        ASSERT_EQ(found.size(), wanted.size());
        for (std::size_t k = 0; k < found.size(); ++k)
            ASSERT_NEAR(found[k], wanted[k], 1e-10);
    }
}

TEST(PieceRoots, ThatAreDoubleCountOnce)
{
    EXPECT_EQ(rootsOf(withRoots(0.5, 0.5, 2.0)), std::vector<double>{0.5});
    const auto found = rootsOf(withRoots(0.3, 0.3, 0.7));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0], 0.3, 1e-7);
    EXPECT_NEAR(found[1], 0.7, 1e-14);
    EXPECT_EQ(rootsOf(withRoots(0.4, 0.4, 0.4)).size(), 1u);
}

TEST(PieceRoots, AtEndsBelongToOnePiece)
{
    // Through 0 where the pieces meet, up; the second piece knows that it has been counted.
    SurfaceSide side;
    EXPECT_EQ(findRoots({{-1, -0.6, -0.3, 0}, {1, 1, 1, 1}, 1.0}, 0.0, 1e-15, side).count, 1);
    EXPECT_EQ(side.sign, 0);
    EXPECT_EQ(findRoots({{0, 0.3, 0.6, 1}, {1, 1, 1, 1}, 1.0}, 0.0, 1e-15, side).count, 0);
    EXPECT_EQ(side.sign, 1);

    // Touching it there.
    side = {true, -1};
    EXPECT_EQ(findRoots({{-1, -0.6, -0.3, 0}, {1, 1, 1, 1}, 1.0}, 0.0, 1e-15, side).count, 1);
    EXPECT_EQ(findRoots({{0, -0.3, -0.6, -1}, {1, 1, 1, 1}, 1.0}, 0.0, 1e-15, side).count, 0);

    // Lost by rounding between two pieces: found at the second one's start.
    side = {true, -1};
    const PieceRoots roots = findRoots({{1e-9, 0.3, 0.6, 1}, {1, 1, 1, 1}, 1.0}, 0.0, 1e-15, side);
    ASSERT_EQ(roots.count, 1);
    EXPECT_EQ(roots.at[0], 0.0);
}

TEST(PieceRoots, OfAPieceThatIsTheValueIsItsStart)
{
    SurfaceSide side{true, 1};
    const PieceQuotient flat{{2, 2, 2, 2}, {1, 1, 1, 1}, 2.0};
    const PieceRoots roots = findRoots(flat, 2.0, 1e-15, side);
    ASSERT_EQ(roots.count, 1);
    EXPECT_EQ(roots.at[0], 0.0);
    EXPECT_EQ(findRoots(flat, 2.0, 1e-15, side).count, 0);
}

TEST(PieceRoots, AreNotWhereAllTentsEnd)
{
    // B = 1 with D = x^2 (1 - x): n and d vanish at both ends, n - d / 2 as well, but B is not 1/2.
    const Cubic d{0, 0, 1.0 / 3.0, 0};
    PieceQuotient q{{0, 0, 1.0 / 3.0, 0}, d, 1.0};
    q.reduce();
    EXPECT_FALSE(q.hole());
    EXPECT_NEAR(q.n[0] / q.d[0], 1.0, 1e-15);
    EXPECT_NEAR(q.n[3] / q.d[3], 1.0, 1e-15);
    SurfaceSide side;
    EXPECT_EQ(findRoots(q, 0.5, 1e-15, side).count, 0);

    PieceQuotient nothing{{}, {}, 1.0};
    nothing.reduce();
    EXPECT_TRUE(nothing.hole());
}

} // namespace
} // namespace brickwall
