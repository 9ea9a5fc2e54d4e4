// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/ExaFields.h"

#include <string>
#include <vector>

namespace brickwall {

/// What an ExaBrick data set consists of, gathered from an .exa file or from what lies beside a .bricks or .cells file.
struct ExaParts
{
    std::string data;     ///< as it was opened, for messages
    std::string geometry; ///< the .bricks or .cells file
    bool cells = false;   ///< it has loose cells, not bricks
    std::vector<ExaField> fields;
    std::string triangles; ///< empty if there are none
    mat4d worldFromVoxel{1.0};
};

/// Files are read when fields are asked for; their existence has been checked by whoever filled in the parts.
std::unique_ptr<DataSet> makeExaDataSet(ExaParts parts);

/// The fields of the files beside BASE.bricks or BASE.cells: BASE.scalars and BASE.scalar are "scalar";
/// BASE.NAME.scalars and BASE.NAME.scalar are "NAME", in alphabetical order, but for those that belong to a
/// BASE.NAME.bricks or .cells. Where a name has both endings, the second is "NAME.scalars".
std::vector<ExaField> companionFields(const std::string& geometry);

} // namespace brickwall
