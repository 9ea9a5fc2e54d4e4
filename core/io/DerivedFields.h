// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/Expression.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// A field that the user defines: "speed = sqrt(velx^2 + vely^2 + velz^2)".
struct DerivedField
{
    std::string name;
    std::string text; ///< as it was typed, for messages
    Expression expression;
};

/// Takes definitions NAME = EXPRESSION apart, without a look at any data. A name that is no word of letters, digits and
/// underscores stands in quotes, here too. Throws TextError at `place`, also for a name that is defined twice.
std::vector<DerivedField> parseDerivedFields(std::span<const std::string> definitions, const std::string& place);

/// A data set with more fields: those that are defined, behind its own in the list of names; and the magnitudes of the
/// vectors among its own fields (VectorFields.h), which are loaded by name and not listed. A definition may use stored
/// fields, magnitudes, and definitions before it, and vectors whose components are among those. Only stored fields that
/// are needed are read; values are computed cell by cell, in parallel. Cells where a result is not finite are treated
/// as those where a stored value is not; differences are taken as if they were not there.
///
/// Throws TextError at `place` for a name that a definition uses and nobody has, Error for one that the data have
/// already.
std::unique_ptr<DataSet> deriveFields(std::unique_ptr<DataSet> stored, std::vector<DerivedField> definitions,
                                      const std::string& place);

} // namespace brickwall
