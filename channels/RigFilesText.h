// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// A display configuration as it was read: errors and notes name `file`, and count lines in `text`.
struct RigText
{
    std::string file;
    std::string text;
};

/// "FILE:LINE", the line counted from 1; offsets behind the end mean the last line.
std::string placeOfLine(const RigText& source, int line);
int lineOfOffset(std::string_view text, std::size_t offset);

/// A decimal number that is the whole of `word`; nothing for "0/05", "12px", "nan" or "". A leading '+' is allowed.
std::optional<double> parseNumber(std::string_view word);
std::optional<int> parseInteger(std::string_view word);

std::vector<std::string> splitWords(std::string_view text, std::string_view separators);
std::string lowerCase(std::string_view text);

/// The mode of a word of COVISE's or ours, whatever its case, with or without '_' and '-': "HORIZONTAL_SPLIT",
/// "left_eye", "STIPPLE", "mono", "none". Nothing for other words.
std::optional<StereoMode> stereoModeOf(std::string_view word);
/// COVISE's word.
std::string coviseWordOf(StereoMode mode);

/// "a, b and c", for messages.
std::string enumerate(const std::vector<std::string>& words);

/// `name`, or `name`-2, `name`-3, ... so that it is none of `taken`.
std::string uniqueName(const std::string& name, const std::vector<std::string>& taken);

} // namespace brickwall
