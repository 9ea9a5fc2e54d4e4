// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Postfix.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/TextCursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace brickwall {
namespace {

struct BinaryOperator
{
    std::string_view token;
    float (*apply)(float, float);
};

constexpr std::array<BinaryOperator, 11> binaryOperators{{
    {"+", [](float a, float b) { return a + b; }},
    {"-", [](float a, float b) { return a - b; }},
    {"*", [](float a, float b) { return a * b; }},
    {"/", [](float a, float b) { return a / b; }},
    {"**", [](float a, float b) { return std::pow(a, b); }},
    {"==", [](float a, float b) { return a == b ? 1.f : 0.f; }},
    {"!=", [](float a, float b) { return a != b ? 1.f : 0.f; }},
    {"<", [](float a, float b) { return a < b ? 1.f : 0.f; }},
    {">", [](float a, float b) { return a > b ? 1.f : 0.f; }},
    {"<=", [](float a, float b) { return a <= b ? 1.f : 0.f; }},
    {">=", [](float a, float b) { return a >= b ? 1.f : 0.f; }},
}};

struct UnaryOperator
{
    std::string_view token;
    float (*apply)(float);
};

constexpr std::array<UnaryOperator, 3> unaryOperators{{
    {"log", [](float a) { return std::log(a); }},
    {"abs", [](float a) { return std::fabs(a); }},
    {"sqrt", [](float a) { return std::sqrt(a); }},
}};

constexpr std::size_t blockSize = 256;  // of values that go through one step together
constexpr std::size_t mostDepth = 4096; // of the stack, of such blocks

} // namespace

Postfix::Step Postfix::parseToken(const std::string& token, std::size_t declaredFields)
{
    if (token.starts_with('%')) {
        std::size_t index = 0;
        const char* const end = token.data() + token.size();
        const auto [stop, error] = std::from_chars(token.data() + 1, end, index);
        if (error != std::errc() || stop != end)
            throw Error("", "expected % and the number of a field");
        if (index >= declaredFields)
            throw Error("", fmt::format("{} fields are declared before this one, numbered from %0", declaredFields));
        return {.kind = Step::Field, .input = index};
    }
    if (token == "select")
        return {.kind = Step::Select};
    for (const BinaryOperator& op : binaryOperators)
        if (op.token == token)
            return {.kind = Step::Binary, .binary = op.apply};
    for (const UnaryOperator& op : unaryOperators)
        if (op.token == token)
            return {.kind = Step::Unary, .unary = op.apply};
    double constant = 0;
    if (!parseNumber(token, constant) || !std::isfinite(static_cast<float>(constant)))
        throw Error("", "expected %K, a number, + - * / ** == != < > <= >= select log abs or sqrt");
    return {.kind = Step::Constant, .constant = static_cast<float>(constant)};
}

Postfix::Postfix(std::span<const std::string> tokens, std::size_t declaredFields, const std::string& place)
{
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        try {
            steps_.push_back(parseToken(tokens[i], declaredFields));
        } catch (const Error& e) {
            throw Error(place, fmt::format("token {} of the expression, '{}': {}", i + 1, tokens[i], e.what()));
        }
        if (steps_.back().kind == Step::Field)
            fields_.push_back(steps_.back().input);
    }
    std::sort(fields_.begin(), fields_.end());
    fields_.erase(std::unique(fields_.begin(), fields_.end()), fields_.end());
    for (Step& step : steps_)
        if (step.kind == Step::Field)
            step.input = std::lower_bound(fields_.begin(), fields_.end(), step.input) - fields_.begin();
    checkStack(tokens, place);
}

void Postfix::checkStack(std::span<const std::string> tokens, const std::string& place)
{
    std::size_t height = 0;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
        const Step::Kind kind = steps_[i].kind;
        const std::size_t needed = kind == Step::Select ? 3 : kind == Step::Binary ? 2 : kind == Step::Unary ? 1 : 0;
        if (height < needed)
            throw Error(place, fmt::format("token {} of the expression, '{}': expected {} operands before it, found {}",
                                           i + 1, tokens[i], needed, height));
        height = height - needed + 1;
        depth_ = std::max(depth_, height);
    }
    if (depth_ > mostDepth)
        throw Error(place, fmt::format("expected an expression that keeps at most {} values at a time, found one that "
                                       "keeps {}",
                                       mostDepth, depth_));
    if (height != 1)
        throw Error(place, steps_.empty() ? std::string("the expression is empty")
                                          : fmt::format("the expression leaves {} values after its last token, '{}'; "
                                                        "expected one",
                                                        height, tokens.back()));
}

void Postfix::evaluate(std::span<const std::span<const float>> inputs, std::span<float> out) const
{
    std::vector<std::array<float, blockSize>> stack(depth_);
    for (std::size_t begin = 0; begin < out.size(); begin += blockSize) {
        const std::size_t n = std::min(blockSize, out.size() - begin);
        std::size_t top = 0; // height of the stack
        for (const Step& step : steps_) {
            switch (step.kind) {
            case Step::Field:
                std::copy_n(inputs[step.input].data() + begin, n, stack[top++].begin());
                break;
            case Step::Constant:
                stack[top++].fill(step.constant);
                break;
            case Step::Binary:
                --top;
                for (std::size_t i = 0; i < n; ++i)
                    stack[top - 1][i] = step.binary(stack[top - 1][i], stack[top][i]);
                break;
            case Step::Unary:
                for (std::size_t i = 0; i < n; ++i)
                    stack[top - 1][i] = step.unary(stack[top - 1][i]);
                break;
            case Step::Select:
                top -= 2;
                for (std::size_t i = 0; i < n; ++i)
                    stack[top - 1][i] = std::fabs(stack[top - 1][i]) >= 1 ? stack[top][i] : stack[top + 1][i];
                break;
            }
        }
        std::copy_n(stack[0].begin(), n, out.data() + begin);
    }
}

} // namespace brickwall
