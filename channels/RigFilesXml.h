// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFilesText.h"

#include <pugixml.hpp>

namespace brickwall {

/// An XML file whose elements and attributes know their lines.
struct RigXml
{
    RigText source;
    pugi::xml_document document;

    /// Throws Error with the line of the first mistake in the XML.
    explicit RigXml(RigText text);

    std::string placeOf(const pugi::xml_node& element) const;
    /// The line that the attribute stands in: elements are often written over several lines.
    std::string placeOf(const pugi::xml_node& element, std::string_view attribute) const;

private:
    std::vector<std::size_t> lineBegins;
    int lineAt(std::size_t offset) const;
};

} // namespace brickwall
