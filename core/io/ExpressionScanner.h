// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/Expression.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// The name at byte `at` of `text`: a word, or anything in quotes. Moves `at` behind it. Throws TextError at `place` if
/// there is none, or no closing quote.
std::string scanName(std::string_view text, std::size_t& at, const std::string& place);

/// An expression with its names replaced by words that muparser takes, and the way back to the text that was typed.
struct ScannedExpression
{
    std::string formula;
    std::vector<std::size_t> origin; ///< for each byte of the formula and its end: the byte of the text
    std::vector<std::string> names;
    std::vector<std::size_t> positions; ///< of the names' first use, in the text
    std::vector<FlowCall> calls;
};

/// Takes apart what `text` has from byte `begin` on. Throws TextError at `place` for what muparser would take, but
/// nobody means: assignments, several results, and functions that it does not know by their name.
ScannedExpression scanExpression(std::string_view text, std::size_t begin, const std::string& place);

} // namespace brickwall
