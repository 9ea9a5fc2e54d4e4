// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/render/Renderer.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace brickwall {

/// What the user says about the scene, the same words in every command.
struct SceneOptions
{
    std::string data;
    std::string field;            ///< empty: the data set's default
    std::string transferFunction; ///< .xf or JSON file; empty: chosen from the data
    std::string colorMap;         ///< empty: that of the transfer function, or cool-warm
    std::vector<double> range;    ///< empty, or lo and hi
    double opacityScale = 1.0;
    std::string shading = "headlight";
    std::vector<double> background; ///< empty (black, or the rig's), or r, g, b in sRGB
    std::string method = "midpoint";
    double dt = 0.5;
    int threads = 0;
};

void addDataOption(CLI::App& command, SceneOptions& options);
void addSceneOptions(CLI::App& command, SceneOptions& options);
void addThreadsOption(CLI::App& command, int& threads);

RenderSettings renderSettings(const SceneOptions& options);

/// The background as linear RGB; `otherwise` if the user did not say.
vec3f backgroundColor(const SceneOptions& options, const vec3f& otherwise = vec3f(0.0f));

/// A scene ready to be rendered, and what is worth telling about it.
struct PreparedScene
{
    Scene scene;
    std::string name;
    std::string field;
    std::string unit;
    Box3d bounds; ///< world
    std::uint64_t cells = 0;
    std::uint64_t bytes = 0;          ///< that regions and field take
    double loadMilliseconds = 0.0;    ///< from the file to bricks
    double prepareMilliseconds = 0.0; ///< bricks to regions and padded field
};

/// Opens, reads, builds regions and chooses the transfer function; says in notes what was repaired or chosen.
PreparedScene prepareScene(const SceneOptions& options, const Executor& executor, Progress& progress);

/// The largest memory that this process had so far, in bytes.
std::uint64_t peakMemory();

} // namespace brickwall
