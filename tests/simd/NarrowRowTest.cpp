// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/simd/NarrowRow.h"
#include "brickwall/core/simd/Target.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace brickwall {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// All instruction sets that this machine has, one after the other.
class NarrowRow : public testing::Test
{
protected:
    template <class Check>
    void onEachTarget(const Check& check)
    {
        for (const std::string& target : laneTargets()) {
            SCOPED_TRACE(target);
            chooseLaneTarget(target);
            check();
        }
        chooseLaneTarget("");
    }
};

TEST_F(NarrowRow, NarrowsAsACastDoesAndFindsTheRange)
{
    onEachTarget([] {
        for (int count = 0; count < 70; ++count) {
            std::vector<double> in;
            for (int i = 0; i < count; ++i)
                in.push_back(std::sin(1.0 + i * i) * (i % 5 == 0 ? 1e-300 : 1e30)); // some are zero as float
            std::vector<float> out(static_cast<std::size_t>(count) + 1, -7.0f);
            const OrderedRange range = narrowRow(in.data(), count, out.data());
            Range expected;
            for (int i = 0; i < count; ++i) {
                const auto k = static_cast<std::size_t>(i);
                EXPECT_EQ(out[k], static_cast<float>(in[k]));
                expected.extend(out[k]);
            }
            EXPECT_EQ(out.back(), -7.0f); // not beyond the row
            EXPECT_TRUE(range.finite());
            if (count > 0) {
                EXPECT_EQ(range.range(), expected) << count;
            }
        }
    });
}

TEST_F(NarrowRow, SeesEveryValueThatIsNotFiniteAsFloat)
{
    onEachTarget([] {
        for (const double bad : {infinity, -infinity, std::nan(""), -std::nan(""), 1e300, -1e39})
            for (std::size_t at = 0; at < 19; ++at) {
                std::vector<double> in(19, 0.5);
                in[at] = bad;
                std::vector<float> out(19);
                EXPECT_FALSE(narrowRow(in.data(), 19, out.data()).finite()) << bad << " at " << at;
            }
        const double largest[]{3.4028234663852886e38, -3.4028234663852886e38};
        float out[2];
        EXPECT_TRUE(narrowRow(largest, 2, out).finite());
    });
}

} // namespace
} // namespace brickwall
