// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Renderer.h"

#include <memory>
#include <string>
#include <vector>

namespace brickwall::test {

/// Data on which the tolerance is to be kept: one field, ready to be rendered.
struct Subject
{
    std::string name;
    Box3d bounds; ///< world space
    mat4d worldFromVoxel{1.0};
    std::shared_ptr<const RegionTree> regions;
    std::shared_ptr<const PaddedField> field;
    Range range;               ///< of the field's values
    TransferFunction standard; ///< the default for this field
    /// Of the cells' t under the standard transfer function, those in (0.05, 0.95), ascending: where there is something
    /// other than background. All in [0, 1] if there are no others.
    std::vector<float> shown;

    /// t below which this share of `shown` lies.
    float quantile(double share) const;
};

/// Random layouts, by their seed and what is special about them; the shipped samples; files of the shared folder.
std::vector<std::string> oracleNames();
std::vector<std::string> sampleNames();

/// The subject of that name, kept until another is asked for. Null, with the reason in `missing`, for a file that is
/// not there or whose format nobody reads.
std::shared_ptr<const Subject> subjectNamed(const std::string& name, std::string& missing);

} // namespace brickwall::test
