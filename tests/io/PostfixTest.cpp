// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Postfix.h"
#include "brickwall/tests/io/IoTest.h"

#include <cmath>
#include <sstream>

namespace brickwall {
namespace {

Postfix parse(const std::string& text, std::size_t fields = 3)
{
    std::istringstream in(text);
    std::vector<std::string> tokens{std::istream_iterator<std::string>(in), {}};
    return Postfix(tokens, fields, "a.exa:3");
}

/// With the fields %0 = a, %1 = b, %2 = c.
float value(const std::string& text, float a = 0, float b = 0, float c = 0)
{
    const Postfix postfix = parse(text);
    const float fields[] = {a, b, c};
    std::vector<std::span<const float>> inputs;
    for (const std::size_t f : postfix.fields())
        inputs.emplace_back(fields + f, 1);
    float out = -999;
    postfix.evaluate(inputs, std::span(&out, 1));
    return out;
}

std::string parseError(const std::string& text)
{
    return errorOf([&] { parse(text); });
}

TEST(Postfix, TakesOperandsInTheirOrder)
{
    EXPECT_EQ(value("%0 %1 -", 7, 2), 5);
    EXPECT_EQ(value("%0 %1 /", 7, 2), 3.5f);
    EXPECT_EQ(value("%1 %0 **", 3, 2), 8);
    EXPECT_EQ(value("%0 %1 %2 * +", 1, 2, 3), 7);
    EXPECT_EQ(value("-2.5e1 %2 +", 0, 0, 3), -22);
    EXPECT_EQ(value("%0", 4), 4);
}

TEST(Postfix, ComparesToOneOrZero)
{
    const char* operators[] = {"==", "!=", "<", ">", "<=", ">="};
    const float ofOneTwo[] = {0, 1, 1, 0, 1, 0}, ofTwoTwo[] = {1, 0, 0, 0, 1, 1}, ofTwoOne[] = {0, 1, 0, 1, 0, 1};
    for (int i = 0; i < 6; ++i) {
        const std::string text = std::string("%0 %1 ") + operators[i];
        EXPECT_EQ(value(text, 1, 2), ofOneTwo[i]) << text;
        EXPECT_EQ(value(text, 2, 2), ofTwoTwo[i]) << text;
        EXPECT_EQ(value(text, 2, 1), ofTwoOne[i]) << text;
    }
}

TEST(Postfix, ConstantsAreFloats)
{
    EXPECT_EQ(value("%0 0.1 ==", 0.1f), 1);
}

TEST(Postfix, HasUnaryFunctions)
{
    EXPECT_FLOAT_EQ(value("%0 log", 10), std::log(10.f));
    EXPECT_EQ(value("%0 abs", -3), 3);
    EXPECT_EQ(value("%0 sqrt", 9), 3);
}

TEST(Postfix, SelectTruncatesItsCondition)
{
    EXPECT_EQ(value("%0 10 20 select", 1), 10);
    EXPECT_EQ(value("%0 10 20 select", 0), 20);
    EXPECT_EQ(value("%0 10 20 select", 0.9f), 20);
    EXPECT_EQ(value("%0 10 20 select", -1.5f), 10);
    EXPECT_EQ(value("%0 5 > %0 0 select", 7), 7);
}

TEST(Postfix, TreatsAllElementsAlike)
{
    const Postfix postfix = parse("%1 %0 - %1 *");
    EXPECT_EQ(postfix.fields(), (std::vector<std::size_t>{0, 1}));
    std::vector<float> a(1000), b(1000), out(1000);
    for (int i = 0; i < 1000; ++i) {
        a[i] = static_cast<float>(i);
        b[i] = static_cast<float>(3 * i + 1);
    }
    const std::span<const float> inputs[] = {a, b};
    postfix.evaluate(inputs, out);
    for (int i = 0; i < 1000; ++i)
        ASSERT_EQ(out[i], (b[i] - a[i]) * b[i]);
}

TEST(Postfix, ErrorsPointAtTheToken)
{
    EXPECT_TRUE(says(parseError("%0 %1 plus"), {"a.exa:3", "token 3", "'plus'"}));
    EXPECT_TRUE(says(parseError("%0 %7 +"), {"a.exa:3", "token 2", "'%7'", "3 fields"}));
    EXPECT_TRUE(says(parseError("%x"), {"token 1", "'%x'"}));
    EXPECT_TRUE(says(parseError("%0 + 2"), {"token 2", "'+'", "expected 2 operands before it, found 1"}));
    EXPECT_TRUE(says(parseError("1 2 select"), {"token 3", "'select'", "expected 3"}));
    EXPECT_TRUE(says(parseError("sqrt"), {"token 1", "'sqrt'"}));
    EXPECT_TRUE(says(parseError("1 2 3 +"), {"leaves 2 values"}));
    EXPECT_TRUE(says(parseError(""), {"is empty"}));
    std::string deep; // memory for evaluation is asked for by how many values wait at a time
    for (int i = 0; i < 100000; ++i)
        deep += "1 ";
    for (int i = 1; i < 100000; ++i)
        deep += "+ ";
    EXPECT_TRUE(says(parseError(deep), {"a.exa:3", "at most 4096 values", "100000"}));
    EXPECT_TRUE(says(parseError("1e99"), {"'1e99'"}));
    EXPECT_TRUE(says(parseError("nan"), {"'nan'"}));
}

} // namespace
} // namespace brickwall
