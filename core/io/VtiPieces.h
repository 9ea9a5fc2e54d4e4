// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/CellSelection.h"
#include "brickwall/core/io/OutputFile.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// One VTK ImageData file (.vti) that grows by one field after the other: cell data, float32, appended raw,
/// little-endian, with UInt64 headers; compressed with zlib by request. Its header names all fields from the start;
/// where their values begin is filled in as they come, as numbers of a fixed width. Format: VTK File Formats, "XML File
/// Formats".
class VtiPiece
{
public:
    /// `path` is where it is written, `name` what messages call it. `lower` and `cellSize` are in world space.
    VtiPiece(std::string path, std::string name, const vec3i& size, const vec3d& lower, const vec3d& cellSize,
             const std::vector<std::string>& fieldNames, bool compress);

    void create() const;
    /// Appends the values of field number `field`, those of brick number `brick` of the selection.
    void append(std::size_t field, const SelectedValues& values, std::size_t brick, Progress& progress) const;
    void finish() const;

private:
    void appendRaw(OutputFile& file, const SelectedValues& values, std::size_t brick, Progress& progress) const;
    void appendCompressed(OutputFile& file, const SelectedValues& values, std::size_t brick, Progress& progress) const;

    std::string path_, name_;
    std::uint64_t cellCount_;
    bool compress_;
    std::string header_;                      ///< up to the appended data
    std::vector<std::uint64_t> offsetPlaces_; ///< where in the file each field's offset stands
};

/// A text as the value of an XML attribute.
std::string xmlAttribute(const std::string& text);

} // namespace brickwall
