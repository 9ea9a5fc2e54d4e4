// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"
#include "brickwall/core/io/ArrayFields.h"
#include "brickwall/core/io/LeafFields.h"
#include "brickwall/core/io/VtkXml.h"

#include <memory>
#include <string>
#include <vector>

namespace brickwall {

/// A `.vti` file with one piece: the cells of one box.
class VtkPiece
{
public:
    /// Throws Error unless it is image data with one piece.
    explicit VtkPiece(const std::string& path);

    const VtkXml& xml() const { return xml_; }
    vec3i size() const { return size_; } ///< in cells
    vec3d lower() const { return lower_; }
    vec3d spacing() const { return spacing_; }
    /// The fields of all arrays of cell data, without VTK's own ghost arrays.
    std::vector<ArrayField> fields() const;
    /// The array of that name; an Error lists those there are.
    pugi::xml_node array(const std::string& name) const;

private:
    VtkXml xml_;
    pugi::xml_node cellData_;
    vec3i size_{0};
    vec3d lower_{0.0};
    vec3d spacing_{1.0};
};

/// The values of a field in the file of a piece whose box is `box`. Keeps the array as the file has it.
std::unique_ptr<BoxReader> openVtkPiece(const std::string& path, const Box3i& box, const ArrayField& field);

/// The numbers of an attribute. Throws Error, naming file, element and attribute, unless there are three or six.
vec3d vtkVector(const VtkXml& xml, const pugi::xml_node& node, const char* attribute);
/// "x0 x1 y0 y1 z0 z1", each at most 2^30 from 0, as lower and upper corner.
Box3i vtkExtent(const VtkXml& xml, const pugi::xml_node& node, const char* attribute);

} // namespace brickwall
