// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/TextCursor.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>
#include <utility>

namespace brickwall {
namespace {

constexpr std::size_t pieceBytes = 1 << 20;
constexpr std::size_t numberBytes = 1 << 12; // more than any number has

bool blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

std::string_view trimmed(std::string_view s)
{
    while (!s.empty() && blank(s.front()))
        s.remove_prefix(1);
    while (!s.empty() && blank(s.back()))
        s.remove_suffix(1);
    return s;
}

} // namespace

TextCursor::TextCursor(std::string place, std::string text)
    : place_(std::move(place)), text_(std::move(text)), read_(text_.size()), size_(text_.size())
{
}

TextCursor::TextCursor(const std::string& file)
    : place_(file), file_(std::make_shared<const InputFile>(file)), size_(file_->size())
{
}

void TextCursor::provide(std::size_t bytes)
{
    while (text_.size() - at_ < bytes && !atLastPiece()) {
        text_.erase(0, std::exchange(at_, 0));
        const std::size_t before = text_.size();
        text_.resize(before + std::min<std::uint64_t>(pieceBytes, size_ - read_));
        file_->readAt(read_, std::span<char>(text_).subspan(before), "its text");
        read_ += text_.size() - before;
    }
}

template <class Stop>
std::size_t TextCursor::findEnd(const Stop& stop, std::string_view what)
{
    std::size_t length = 0;
    while (true) {
        while (at_ + length < text_.size() && !stop(text_[at_ + length]))
            ++length;
        if (at_ + length < text_.size() || atLastPiece())
            return at_ + length;
        if (length > pieceBytes)
            fail(fmt::format("{} of at most {} bytes", what, pieceBytes));
        provide(length + 1);
    }
}

std::string TextCursor::where()
{
    skipBlanks();
    return fmt::format("{}:{}", place_, line_);
}

void TextCursor::skipBlanks()
{
    do {
        if (text_.size() - at_ < numberBytes)
            provide(numberBytes);
        for (; at_ < text_.size() && blank(text_[at_]); ++at_)
            line_ += text_[at_] == '\n';
    } while (text_.size() - at_ < numberBytes && !atLastPiece());
}

bool TextCursor::atEnd()
{
    skipBlanks();
    return at_ == text_.size();
}

bool TextCursor::nextIs(std::string_view start)
{
    skipBlanks();
    // Most are one character, for which a comparison of strings takes long.
    return at_ < text_.size() && text_[at_] == start.front() &&
           (start.size() == 1 || std::string_view(text_).substr(at_, start.size()) == start);
}

void TextCursor::expect(std::string_view start, std::string_view what)
{
    if (!nextIs(start))
        fail(fmt::format("'{}' of {}", start, what));
    at_ += start.size();
}

std::string TextCursor::line(std::string_view what)
{
    const std::size_t end = findEnd([](char c) { return c == '\n'; }, what);
    if (at_ == text_.size())
        fail(what);
    std::string rest(trimmed(std::string_view(text_).substr(at_, end - at_)));
    line_ += end < text_.size();
    at_ = std::min(end + 1, text_.size());
    return rest;
}

std::string TextCursor::word(std::string_view what)
{
    if (atEnd())
        fail(what);
    const std::size_t end = findEnd(blank, what);
    std::string found = text_.substr(at_, end - at_);
    at_ = end;
    return found;
}

std::int64_t TextCursor::integer(std::string_view what, std::int64_t lowest, std::int64_t highest)
{
    skipBlanks();
    std::int64_t value = 0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
    if (error != std::errc() || value < lowest || value > highest || (stop == end && !atLastPiece()))
        fail(fmt::format("{} from {} to {}", what, lowest, highest));
    at_ = static_cast<std::size_t>(stop - text_.data());
    return value;
}

double TextCursor::number(std::string_view what)
{
    skipBlanks();
    double value = 0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
    if (error != std::errc() || !std::isfinite(value) || (stop == end && !atLastPiece()))
        fail(fmt::format("{}, a finite number", what));
    at_ = static_cast<std::size_t>(stop - text_.data());
    return value;
}

void TextCursor::fail(std::string_view expected) const
{
    std::size_t end = at_;
    while (end < text_.size() && !blank(text_[end]) && end - at_ < 40)
        ++end;
    const std::string_view word = std::string_view(text_).substr(at_, end - at_);
    const std::string found = !word.empty()         ? fmt::format("'{}'", word)
                              : at_ == text_.size() ? "the end of the file"
                                                    : "the end of the line";
    throw Error(fmt::format("{}:{}", place_, line_), fmt::format("expected {}, found {}", expected, found));
}

bool parseNumber(std::string_view text, double& number)
{
    if (!text.empty() && text.front() == '+')
        text.remove_prefix(1);
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stop == text.data() + text.size() && !text.empty();
}

} // namespace brickwall
