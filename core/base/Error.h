// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace brickwall {

/// The one error that bad input causes. `what()` is a single line, "PLACE: MESSAGE": the place names the file and the
/// position in it (line, byte offset, record, attribute), the message says what was expected, what was found and, where
/// it helps, what to do. Commands print it and exit with 2; the plugin turns it into a notice. Never caught to be
/// ignored.
class Error : public std::runtime_error
{
public:
    /// An empty place leaves the message alone.
    Error(std::string_view place, std::string_view message);
};

/// An Error in a text that the user typed. Its line says at which character; commands print `excerpt` under it.
class TextError : public Error
{
public:
    /// `at` is the byte of `text` that the message is about; its size: behind the end.
    TextError(std::string_view place, std::string_view message, std::string_view text, std::size_t at);

    /// The text and, in a second line, a caret under the character.
    const std::string& excerpt() const { return excerpt_; }

private:
    std::string excerpt_;
};

/// Thrown by long work after the user asked to stop (Progress::check). It is no error: commands exit with 130.
class Cancelled : public std::exception
{
public:
    const char* what() const noexcept override { return "cancelled"; }
};

} // namespace brickwall
