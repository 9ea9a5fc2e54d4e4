// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"
#include "brickwall/core/scene/SceneOptions.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace brickwall {

/// What the user says about streamlines. There are none without seeds.
struct StreamlineOptions
{
    std::vector<std::string> seeds; ///< COUNT or NXxNYxNZ, and behind a colon a box: "5x5x5:0,0,0,1,1,1"
    std::string vector;             ///< its name; empty: the first that the data have
    double length = 0.0;            ///< in world units, to either side of a seed; 0: chosen from the data
    double radius = 0.0;            ///< of the tubes; 0: chosen from the data
};

/// Adds --streamlines and what belongs to it.
void addStreamlineOptions(CLI::App& command, StreamlineOptions& options);

/// Limits, without a look at any data. Throws Error.
void checkStreamlineOptions(const StreamlineOptions& options, const PlaceOfOption& placeOf);

/// Traces the lines of these options through the data of a scene and makes tubes of them; nothing without seeds. Says
/// in a note how many lines there are and where they end. Throws Error for a vector that is not there and for seeds of
/// which none is in a cell.
std::vector<TriangleMesh> streamlineTubes(const SceneOptions& scene, const StreamlineOptions& options,
                                          const Executor& executor, Progress& progress);

} // namespace brickwall
