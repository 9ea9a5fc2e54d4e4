// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ExpressionScanner.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace brickwall {
namespace {

constexpr std::array<std::string_view, 27> functions{
    "abs",   "acos", "acosh", "asin", "asinh", "atan", "atan2", "atanh", "avg",  "cos",  "cosh", "exp", "ln",  "log",
    "log10", "log2", "max",   "min",  "pow",   "rint", "sign",  "sin",   "sinh", "sqrt", "sum",  "tan", "tanh"};

constexpr std::string_view blanks = " \t\r\n";

bool isDigit(char c)
{
    return c >= '0' && c <= '9';
}

/// Bytes of UTF-8 count as letters.
bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

bool isQuote(char c)
{
    return c == '"' || c == '\'' || c == '`';
}

std::size_t wordEnd(std::string_view text, std::size_t at)
{
    while (at < text.size() && (isLetter(text[at]) || isDigit(text[at])))
        ++at;
    return at;
}

class Scanner
{
public:
    Scanner(std::string_view text, std::size_t begin, const std::string& place) : text_(text), at_(begin), place_(place)
    {
    }

    ScannedExpression scan()
    {
        while (at_ < text_.size())
            token();
        result_.origin.push_back(text_.size());
        return std::move(result_);
    }

private:
    void token()
    {
        const char c = text_[at_];
        if (isDigit(c) || (c == '.' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1])))
            number();
        else if (isLetter(c))
            word();
        else if (isQuote(c))
            value();
        else
            symbol(c);
    }

    void number()
    {
        std::size_t end = at_;
        while (end < text_.size() && (isDigit(text_[end]) || text_[end] == '.'))
            ++end;
        if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
            std::size_t exponent = end + 1;
            if (exponent < text_.size() && (text_[exponent] == '+' || text_[exponent] == '-'))
                ++exponent;
            if (exponent < text_.size() && isDigit(text_[exponent]))
                for (end = exponent; end < text_.size() && isDigit(text_[end]);)
                    ++end;
        }
        if (end < text_.size() && isLetter(text_[end]))
            fail("expected an operator behind the number, or quotes around a name that starts with a digit");
        copy(end);
    }

    void word()
    {
        const std::size_t end = wordEnd(text_, at_);
        const std::string_view name = text_.substr(at_, end - at_);
        const std::size_t next = text_.find_first_not_of(blanks, end);
        if (next != std::string_view::npos && text_[next] == '(') {
            if (const auto op = flowOperatorNamed(name))
                return call(*op, next);
            if (std::find(functions.begin(), functions.end(), name) == functions.end())
                fail(fmt::format("there is no function {}; there are {} {}", name, fmt::join(functions, " "),
                                 fmt::join(flowOperatorNames, " ")));
            copy(end);
        } else if (name == "_pi" || name == "_e") {
            copy(end);
        } else {
            value();
        }
    }

    void value()
    {
        const std::size_t start = at_;
        const std::string name = scanName(text_, at_, place_);
        const auto known = std::find(result_.names.begin(), result_.names.end(), name);
        const auto index = known - result_.names.begin();
        if (known == result_.names.end()) {
            result_.names.push_back(name);
            result_.positions.push_back(start);
        }
        result_.formula += fmt::format("f{}_", index);
        result_.origin.resize(result_.formula.size(), start);
    }

    /// An operator of derivatives, whose parenthesis is at `open`: of a name alone, as it needs the cells around.
    void call(FlowOperator op, std::size_t open)
    {
        const auto skipBlanks = [&] { at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size()); };
        const std::size_t start = at_;
        at_ = open + 1;
        skipBlanks();
        const std::string_view expected = componentsOf(op) == 3 ? "the name of a vector" : "the name of a field";
        if (at_ == text_.size() || !(isLetter(text_[at_]) || isQuote(text_[at_])))
            fail(fmt::format("expected {}", expected));
        const std::size_t position = at_;
        const FlowCall call{op, scanName(text_, at_, place_), position};
        skipBlanks();
        if (at_ == text_.size() || text_[at_] != ')')
            fail(fmt::format("expected ) behind {}; what is computed needs a name first, by a definition of its own",
                             expected));
        ++at_;
        const auto known = std::find(result_.calls.begin(), result_.calls.end(), call);
        result_.formula += fmt::format("d{}_", known - result_.calls.begin());
        result_.origin.resize(result_.formula.size(), start);
        if (known == result_.calls.end())
            result_.calls.push_back(call);
    }

    void symbol(char c)
    {
        const bool equalsNext = at_ + 1 < text_.size() && text_[at_ + 1] == '=';
        const bool comparison = c == '=' || c == '<' || c == '>' || c == '!';
        if (c == '=' && !equalsNext)
            fail("expected ==, which compares, found =");
        depth_ += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && depth_ <= 0)
            fail("expected one expression, found a comma outside a function");
        copy(at_ + (comparison && equalsNext ? 2 : 1));
    }

    void copy(std::size_t end)
    {
        for (; at_ < end; ++at_) {
            result_.formula += text_[at_];
            result_.origin.push_back(at_);
        }
    }

    [[noreturn]] void fail(const std::string& message) const { throw TextError(place_, message, text_, at_); }

    std::string_view text_;
    std::size_t at_;
    const std::string& place_;
    int depth_ = 0; ///< of parentheses
    ScannedExpression result_;
};

} // namespace

std::string scanName(std::string_view text, std::size_t& at, const std::string& place)
{
    if (at < text.size() && isQuote(text[at])) {
        const std::size_t end = text.find(text[at], at + 1);
        if (end == std::string_view::npos)
            throw TextError(place, "expected a closing quote behind this one", text, at);
        if (end == at + 1)
            throw TextError(place, "expected a name between the quotes", text, at);
        const std::string name(text.substr(at + 1, end - at - 1));
        at = end + 1;
        return name;
    }
    if (at >= text.size() || !isLetter(text[at]))
        throw TextError(place, "expected a name, in quotes if it is more than a word", text, std::min(at, text.size()));
    const std::size_t end = wordEnd(text, at);
    const std::string name(text.substr(at, end - at));
    at = end;
    return name;
}

ScannedExpression scanExpression(std::string_view text, std::size_t begin, const std::string& place)
{
    return Scanner(text, begin, place).scan();
}

} // namespace brickwall
