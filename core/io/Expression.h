// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// An expression of named values, in the notation of muparser: `+ - * / ^`, `< <= > >= == != && ||`, `c ? a : b`,
/// `_pi`, `_e`, and the functions abs acos acosh asin asinh atan atan2 atanh avg cos cosh exp ln log (natural) log10
/// log2 max min pow rint sign sin sinh sqrt sum tan tanh. All other names are values; those that are no words of
/// letters, digits and underscores stand in quotes, of any of the three kinds. Evaluated in double precision.
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

    /// One result per element; inputs[i] are the values of names()[i], at least as many as `out` has elements. May be
    /// called from any thread. What is not defined (1/0, the root of -1) is infinite or a NaN.
    void evaluate(std::span<const std::span<const float>> inputs, std::span<float> out) const;

private:
    std::string formula_; ///< in which names are f0_, f1_, ...: what muparser takes
    std::vector<std::string> names_;
    std::vector<std::size_t> positions_;
};

} // namespace brickwall
