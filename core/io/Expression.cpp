// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Expression.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ExpressionScanner.h"

#include <muParser.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace brickwall {
namespace {

/// A parser whose variables f0_, f1_, ..., of which there are `names`, and then d0_, d1_, ... are these numbers.
mu::Parser parserOf(const std::string& formula, std::size_t names, std::vector<double>& variables)
{
    mu::Parser parser;
    parser.DefineConst("_pi", std::numbers::pi); // muparser's own have 13 digits
    parser.DefineConst("_e", std::numbers::e);
    parser.DefineFun("pow", [](double base, double exponent) { return std::pow(base, exponent); });
    for (std::size_t i = 0; i < variables.size(); ++i)
        parser.DefineVar(i < names ? fmt::format("f{}_", i) : fmt::format("d{}_", i - names), &variables[i]);
    parser.SetExpr(formula);
    return parser;
}

/// muparser's own messages have the words and positions of the formula that it was given, which the user never saw.
std::string messageOf(const mu::ParserError& error)
{
    switch (error.GetCode()) {
    case mu::ecUNEXPECTED_OPERATOR:
        return fmt::format("expected a value, found the operator {}", error.GetToken());
    case mu::ecUNEXPECTED_EOF:
        return "expected a value, found the end of the expression";
    case mu::ecUNEXPECTED_ARG_SEP:
    case mu::ecUNEXPECTED_ARG:
        return "expected a value, found a comma";
    case mu::ecUNEXPECTED_VAL:
    case mu::ecUNEXPECTED_VAR:
    case mu::ecUNEXPECTED_FUN:
        return "expected an operator before this value";
    case mu::ecUNEXPECTED_PARENS:
        return fmt::format("unexpected parenthesis {}", error.GetToken());
    case mu::ecMISSING_PARENS:
        return "expected a closing parenthesis";
    case mu::ecTOO_MANY_PARAMS:
        return fmt::format("too many arguments of {}", error.GetToken());
    case mu::ecTOO_FEW_PARAMS:
        return fmt::format("too few arguments of {}", error.GetToken());
    case mu::ecEMPTY_EXPRESSION:
        return "expected an expression, found nothing";
    case mu::ecMISSING_ELSE_CLAUSE:
        return "expected : and a value after ? and a value";
    case mu::ecMISPLACED_COLON:
        return "expected ? before :";
    case mu::ecEXPRESSION_TOO_LONG:
        return "expected at most 10000 characters";
    default:
        return "this cannot be understood";
    }
}

std::size_t placeOf(const mu::ParserError& error, const ScannedExpression& scanned)
{
    const std::size_t end = scanned.formula.size();
    const int at = error.GetPos();
    return scanned.origin[at < 0 ? end : std::min(static_cast<std::size_t>(at), end)];
}

} // namespace

Expression::Expression(std::string_view text, std::size_t begin, const std::string& place)
{
    ScannedExpression scanned = scanExpression(text, begin, place);
    std::vector<double> variables(scanned.names.size() + scanned.calls.size(), 1.0);
    try {
        parserOf(scanned.formula, scanned.names.size(), variables).Eval();
    } catch (const mu::ParserError& error) {
        throw TextError(place, messageOf(error), text, placeOf(error, scanned));
    }
    formula_ = std::move(scanned.formula);
    names_ = std::move(scanned.names);
    positions_ = std::move(scanned.positions);
    calls_ = std::move(scanned.calls);
}

bool Expression::isOneCall() const
{
    constexpr const char* blanks = " \t\r\n";
    const std::size_t begin = formula_.find_first_not_of(blanks), end = formula_.find_last_not_of(blanks) + 1;
    return formula_.substr(begin, end - begin) == "d0_";
}

void Expression::evaluate(std::span<const std::span<const float>> inputs, std::span<float> out) const
{
    std::vector<double> variables(names_.size() + calls_.size(), 1.0);
    const mu::Parser parser = parserOf(formula_, names_.size(), variables); // of this thread alone
    for (std::size_t i = 0; i < out.size(); ++i) {
        for (std::size_t v = 0; v < variables.size(); ++v)
            variables[v] = inputs[v][i];
        out[i] = static_cast<float>(parser.Eval());
    }
}

} // namespace brickwall
