// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/TextCursor.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace brickwall {
namespace {

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

std::string TextCursor::where()
{
    skipBlanks();
    return fmt::format("{}:{}", place_, line_);
}

void TextCursor::skipBlanks()
{
    for (; at_ < text_.size() && blank(text_[at_]); ++at_)
        line_ += text_[at_] == '\n';
}

bool TextCursor::atEnd()
{
    skipBlanks();
    return at_ == text_.size();
}

bool TextCursor::nextIs(std::string_view start)
{
    skipBlanks();
    return std::string_view(text_).substr(at_, start.size()) == start;
}

void TextCursor::expect(std::string_view start, std::string_view what)
{
    if (!nextIs(start))
        fail(fmt::format("'{}' of {}", start, what));
    at_ += start.size();
}

std::string TextCursor::line(std::string_view what)
{
    if (at_ == text_.size())
        fail(what);
    const std::size_t end = text_.find('\n', at_);
    const std::string_view rest = std::string_view(text_).substr(at_, end == std::string::npos ? end : end - at_);
    at_ = end == std::string::npos ? text_.size() : end + 1;
    line_ += end != std::string::npos;
    return std::string(trimmed(rest));
}

std::string TextCursor::word(std::string_view what)
{
    if (atEnd())
        fail(what);
    const std::size_t begin = at_;
    while (at_ < text_.size() && !blank(text_[at_]))
        ++at_;
    return text_.substr(begin, at_ - begin);
}

std::int64_t TextCursor::integer(std::string_view what, std::int64_t lowest, std::int64_t highest)
{
    skipBlanks();
    std::int64_t value = 0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
    if (error != std::errc() || value < lowest || value > highest)
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
    if (error != std::errc() || !std::isfinite(value))
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
