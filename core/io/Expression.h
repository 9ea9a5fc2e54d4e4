// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/FlowOperators.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// An operator that an expression applies to a vector or a field: qcriterion(velocity).
struct FlowCall
{
    FlowOperator op;
    std::string argument;
    std::size_t position; ///< of the argument's first use, in the text

    bool operator==(const FlowCall& other) const { return op == other.op && argument == other.argument; }
};

/// An expression of named values, in the notation of muparser: `+ - * / ^`, `< <= > >= == != && ||`, `c ? a : b`,
/// `_pi`, `_e`, and the functions abs acos acosh asin asinh atan atan2 atanh avg cos cosh exp ln log (natural) log10
/// log2 max min pow rint sign sin sinh sqrt sum tan tanh. All other names are values; those that are no words of
/// letters, digits and underscores stand in quotes, of any of the three kinds. Operators of FlowOperators.h take a name
/// in parentheses; whoever evaluates the expression knows their values. Evaluated in double precision.
class Expression
{
public:
    /// The expression is what `text` has from byte `begin` on. Throws TextError at `place`, which points at the
    /// character in `text`.
    Expression(std::string_view text, std::size_t begin, const std::string& place);

    /// The values that are used, in the order of their first use, each once.
    const std::vector<std::string>& names() const { return names_; }
    /// Where in `text` a name is used first.
    std::size_t positionOf(std::size_t name) const { return positions_[name]; }

    /// The operators that are applied, in the order of their first use, each once.
    const std::vector<FlowCall>& calls() const { return calls_; }
    /// Whether the expression is the first of them and nothing else.
    bool isOneCall() const;

    /// One result per element; inputs[i] are the values of names()[i], and behind those those of calls(), at least as
    /// many as `out` has elements. May be called from any thread. What is not defined (1/0, the root of -1) is infinite
    /// or a NaN.
    void evaluate(std::span<const std::span<const float>> inputs, std::span<float> out) const;

private:
    std::string formula_; ///< in which names are f0_, f1_, ..., calls d0_, d1_, ...: what muparser takes
    std::vector<std::string> names_;
    std::vector<std::size_t> positions_;
    std::vector<FlowCall> calls_;
};

} // namespace brickwall
