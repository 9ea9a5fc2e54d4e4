// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"
#include "brickwall/core/render/Renderer.h"
#include "brickwall/core/scene/SceneOptions.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// A scene ready to be rendered, and what is worth telling about it.
struct PreparedScene
{
    Scene scene;
    std::string name;
    std::string field;
    std::string unit;
    std::string colorField; ///< what colours are of, and its unit: the field itself, or another one
    std::string colorUnit;
    TransferFunction transferFunction; ///< that of the scene, as it is if the volume is not switched off
    Box3d bounds;                      ///< world
    std::uint64_t cells = 0;
    std::uint64_t bytes = 0;          ///< that regions and field take
    double loadMilliseconds = 0.0;    ///< from the file to bricks
    double prepareMilliseconds = 0.0; ///< bricks to regions and padded field
};

/// Opens, reads, builds regions, chooses the transfer function and makes the surfaces; says in notes what was repaired
/// or chosen, and what will not be seen. The options are within their limits.
PreparedScene prepareScene(const SceneOptions& options, const Executor& executor, Progress& progress);

} // namespace brickwall
