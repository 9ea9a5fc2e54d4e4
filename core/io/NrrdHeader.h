// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/core/io/TextCursor.h"

#include <cstdint>
#include <map>
#include <string>

namespace brickwall {

/// The header of a NRRD file (https://teem.sourceforge.net/nrrd/format.html): lines "FIELD: DESCRIPTION" after the
/// magic, up to an empty line or, where the data are in another file, the end. Names of fields are kept in lower case
/// and without blanks, as the format lets writers choose. Errors name file and line.
class NrrdHeader
{
public:
    explicit NrrdHeader(const std::string& path);

    /// Of the header with the empty line at its end; 0 if there is none.
    std::uint64_t bytes() const { return bytes_; }
    bool has(const std::string& field) const { return fields_.contains(field); }
    std::string where(const std::string& field) const; ///< "FILE:LINE" of a field that is there
    TextCursor cursor(const std::string& field) const; ///< at its description; an Error if it is missing
    /// The number of a field; 0 without it.
    std::int64_t integer(const std::string& field, std::int64_t lowest, std::int64_t highest) const;
    /// The number for an axis of a field that has one each; NaN without it.
    double perAxis(const std::string& field, int axis) const;
    /// Whether the field "centers" says so of the axis.
    bool isNode(int axis) const;

private:
    struct Line
    {
        std::string text;
        int number = 0;
    };

    std::string path_;
    std::uint64_t bytes_ = 0;
    std::map<std::string, Line> fields_;
};

/// "(1,0,0)"; "none" is an Error.
vec3d readNrrdVector(TextCursor& text);

/// The byte after so many lines from `offset` of a file.
std::uint64_t afterLines(const std::string& path, std::uint64_t offset, std::int64_t lines);

} // namespace brickwall
