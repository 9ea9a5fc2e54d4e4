// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/ExaGeometry.h"
#include "brickwall/core/io/Postfix.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// A field of an ExaBrick data set as it is declared: a file, the magnitude of three files, or an expression of fields
/// declared before it.
struct ExaField
{
    std::string name;
    std::string place;              ///< of the declaration, for messages
    std::vector<std::string> files; ///< one, three, or none
    std::optional<Postfix> expression;
    Range preferredRange;
};

/// The fields with these indices, read and evaluated for the cells of `geometry` alone. Throws Error, naming file or
/// declaration and the cell, for IDs outside a file and, unless these make a cell empty, for values that are not
/// finite.
std::vector<Field> readExaFields(std::span<const ExaField> all, std::span<const std::size_t> wanted,
                                 const ExaGeometry& geometry, NonFinite nonFinite, const Executor& executor,
                                 Progress& progress);

} // namespace brickwall
