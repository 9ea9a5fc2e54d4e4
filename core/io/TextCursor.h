// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace brickwall {

/// Reads a text from front to back; every error is an Error with file and line. Blanks include line ends, except in
/// line(). Numbers do not depend on the locale.
class TextCursor
{
public:
    TextCursor(std::string place, std::string text) : place_(std::move(place)), text_(std::move(text)) {}

    std::string where(); ///< "FILE:LINE" of the next word
    std::size_t position() const { return at_; }
    std::size_t size() const { return text_.size(); }

    bool atEnd(); ///< nothing but blanks is left
    bool nextIs(std::string_view start);
    void expect(std::string_view start, std::string_view what);

    /// The rest of this line without blanks at its ends; continues on the next line.
    std::string line(std::string_view what);
    std::string word(std::string_view what); ///< up to the next blank
    std::int64_t integer(std::string_view what, std::int64_t lowest, std::int64_t highest);
    /// A number of things that each take at least one byte of this text: a larger one is refused before memory is asked
    /// for.
    std::int64_t count(std::string_view what, std::int64_t lowest) { return integer(what, lowest, text_.size()); }
    double number(std::string_view what); ///< finite

    [[noreturn]] void fail(std::string_view expected) const;

private:
    void skipBlanks();

    std::string place_;
    std::string text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

/// A number in `text`, which has to be used up; false if it is none.
bool parseNumber(std::string_view text, double& number);

} // namespace brickwall
