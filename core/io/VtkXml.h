// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/InputFile.h"

#include <pugixml.hpp>

#include <cstdint>
#include <string>

namespace brickwall {

/// A VTK XML file (https://docs.vtk.org, "VTK XML Formats"), parsed up to its appended data, which need not be XML.
/// Every error is an Error that names the file. Reading from it changes no state.
class VtkXml
{
public:
    /// Throws Error for what is no VTK XML file, and for more than `limit` bytes of it without the appended data.
    explicit VtkXml(const std::string& path, std::uint64_t limit = std::uint64_t(1) << 30);

    const InputFile& file() const { return file_; }
    const std::string& path() const { return file_.path(); }
    std::string type() const { return root().attribute("type").as_string(); }
    /// The element VTKFile.
    pugi::xml_node root() const { return document_.child("VTKFile"); }
    /// The element in it that is named as its type says. Throws Error if there is none.
    pugi::xml_node content() const;

    bool bigEndian() const;
    int headerBytes() const; ///< of a number in front of binary data
    bool compressed() const; ///< by zlib; an Error for other compressors

    bool hasAppended() const { return appendedBegin_ > 0; }
    bool appendedBase64() const { return appendedBase64_; }
    std::uint64_t appendedBegin() const { return appendedBegin_; } ///< the byte after the underscore

private:
    /// The text in front of the appended data.
    std::string head(std::uint64_t limit);
    void findAppended(std::uint64_t element);

    InputFile file_;
    std::uint64_t appendedBegin_ = 0; ///< found while text_ is read
    bool appendedBase64_ = false;
    std::string text_; ///< parsed in place
    pugi::xml_document document_;
};

/// The type that a file claims, without reading more than its beginning; empty if it is no VTK XML file.
std::string vtkXmlType(const std::string& path);

} // namespace brickwall
