// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/InputFile.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace brickwall {

/// Reads a text from front to back; every error is an Error with file and line. Blanks include line ends, except in
/// line(). Numbers do not depend on the locale.
class TextCursor
{
public:
    TextCursor(std::string place, std::string text);
    /// The text of a file, of which a piece at a time is in memory. Words and lines end within 1 MiB.
    explicit TextCursor(const std::string& file);

    std::string where(); ///< "FILE:LINE" of the next word

    bool atEnd(); ///< nothing but blanks is left
    bool nextIs(std::string_view start);
    void expect(std::string_view start, std::string_view what);

    /// The rest of this line without blanks at its ends; continues on the next line.
    std::string line(std::string_view what);
    std::string word(std::string_view what); ///< up to the next blank
    std::int64_t integer(std::string_view what, std::int64_t lowest, std::int64_t highest);
    /// A number of things that each take at least one byte of this text: a larger one is refused before memory is asked
    /// for.
    std::int64_t count(std::string_view what, std::int64_t lowest)
    {
        return integer(what, lowest, static_cast<std::int64_t>(size_));
    }
    double number(std::string_view what); ///< finite

    [[noreturn]] void fail(std::string_view expected) const;

private:
    void skipBlanks();
    /// Has at least so many bytes from `at_` on in text_, unless the text ends before.
    void provide(std::size_t bytes);
    bool atLastPiece() const { return read_ == size_; }
    /// The index in text_, from `at_` on, of the first character for which `stop` holds, or the text's end.
    template <class Stop>
    std::size_t findEnd(const Stop& stop, std::string_view what);

    std::string place_;
    std::shared_ptr<const InputFile> file_; ///< shared by copies; null for a text that is in memory
    std::string text_;                      ///< the piece at hand
    std::size_t at_ = 0;
    std::uint64_t read_ = 0, size_ = 0; ///< bytes that have been in text_, and all
    int line_ = 1;
};

/// A number in `text`, which has to be used up; false if it is none.
bool parseNumber(std::string_view text, double& number);

} // namespace brickwall
