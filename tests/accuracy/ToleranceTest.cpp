// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Table.h"

#include "brickwall/tests/oracles/RealFiles.h"

#include <gtest/gtest.h>

#include <cctype>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

/// The bounded method's promise: no component of any pixel is off by more than the tolerance, or the statistics say for
/// how many pixels it may be. Over data x transfer function x shading x views x tolerance.
namespace brickwall::test {
namespace {

struct Case
{
    std::string subject, transferFunction;
};

void PrintTo(const Case& c, std::ostream* out)
{
    *out << c.subject << ", " << c.transferFunction;
}

/// Skips where there are no data, or where the transfer function makes no sense for them.
void expectKept(const Case& c, int size, bool intoTable)
{
    std::string missing;
    const auto subject = subjectNamed(c.subject, missing);
    if (!subject)
        GTEST_SKIP() << missing;
    const TransferFunction tf = transferFunctionNamed(c.transferFunction, *subject);
    if (tf.opacity.empty())
        GTEST_SKIP() << c.subject << " has values that are not positive";
    const KeptOfShading off = measure(*subject, tf, Shading::off, size);
    const KeptOfShading headlight = measure(*subject, tf, Shading::headlight, size);
    EXPECT_GT(off.opacity, 0.02) << "nothing to see";
    for (std::size_t e = 0; e < tolerances.size(); ++e) {
        EXPECT_EQ(off.of[e].broken, "") << c.subject << ", " << c.transferFunction << ", shading off";
        EXPECT_EQ(headlight.of[e].broken, "") << c.subject << ", " << c.transferFunction << ", headlight";
    }
    EXPECT_GT(off.of.back().differing, 0u) << "compared with itself?";
    if (intoTable)
        addToTable(c.subject, c.transferFunction, off, headlight);
}

/// gtest wants letters and digits.
std::string nameOf(const testing::TestParamInfo<Case>& info)
{
    std::string name;
    for (const char c : info.param.subject + "__" + info.param.transferFunction)
        name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

std::vector<Case> allOf(const std::vector<std::string>& subjects)
{
    std::vector<Case> cases;
    for (const std::string& subject : subjects)
        for (const std::string& tf : transferFunctionNames())
            cases.push_back({subject, tf});
    return cases;
}

std::vector<Case> someOf(const std::vector<std::string>& subjects)
{
    std::vector<Case> cases;
    for (const std::string& subject : subjects)
        for (const char* tf : {"default", "ramp to 1", "window of 1/200", "step to 1", "noisy xf"})
            cases.push_back({subject, tf});
    return cases;
}

class Tolerance : public testing::TestWithParam<Case>
{
};

TEST_P(Tolerance, IsKept)
{
    expectKept(GetParam(), 16, false);
}

INSTANTIATE_TEST_SUITE_P(Oracles, Tolerance, testing::ValuesIn(someOf(oracleNames())), nameOf);
INSTANTIATE_TEST_SUITE_P(Samples, Tolerance, testing::ValuesIn(someOf(sampleNames())), nameOf);

class ToleranceLong : public testing::TestWithParam<Case>
{
};

TEST_P(ToleranceLong, IsKept)
{
    expectKept(GetParam(), 32, true);
}

INSTANTIATE_TEST_SUITE_P(Oracles, ToleranceLong, testing::ValuesIn(allOf(oracleNames())), nameOf);
INSTANTIATE_TEST_SUITE_P(Samples, ToleranceLong, testing::ValuesIn(allOf(sampleNames())), nameOf);
INSTANTIATE_TEST_SUITE_P(Files, ToleranceLong, testing::ValuesIn(allOf(oracles::realFiles)), nameOf);

} // namespace
} // namespace brickwall::test
