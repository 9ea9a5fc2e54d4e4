// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Regions.h"
#include "brickwall/core/render/Frame.h"
#include "brickwall/core/shade/TransferFunction.h"
#include "brickwall/core/trace/TriangleScene.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

enum class Shading {
    off,
    headlight, ///< colour times |cos| of gradient and ray, two-sided, no ambient term (ExaBrick's)
};

enum class Method {
    midpoint, ///< ExaBrick: steps of dt x finest cell width of the region, sampled at the middle of every segment
};

struct MidpointConfig
{
    float dt = 0.5f;                   ///< step, in finest cell widths of the region; > 0
    bool interleave = true;            ///< a different offset of the sample planes for every pixel
    float terminationOpacity = 0.998f; ///< a ray ends when it is this opaque
};

struct RenderSettings
{
    Method method = Method::midpoint;
    MidpointConfig midpoint;
    Shading shading = Shading::headlight;
};

/// What is rendered. Immutable parts are shared, so that a scene with another transfer function costs nothing.
struct Scene
{
    std::shared_ptr<const RegionTree> regions;
    std::shared_ptr<const PaddedField> field;
    std::shared_ptr<const TriangleScene> triangles; ///< may be null
    TransferFunction transferFunction;
    mat4d worldFromVoxel{1.0};
};

struct ViewStatistics
{
    std::string name;
    double milliseconds = 0.0; ///< the view's part of the call: the time spent on its tiles / threads
    std::uint64_t rays = 0;
    std::uint64_t samples = 0;        ///< evaluations of B
    std::uint64_t regionsVisited = 0; ///< that were not skipped
};

/// Renders views of one scene. Construction does what all views share (the table of the transfer function, the regions
/// that it makes visible); `render` may be called from one thread at a time and works on all threads of the executor.
class Renderer
{
public:
    Renderer(Scene scene, const Executor& executor);
    ~Renderer();

    const Scene& scene() const;

    /// Frames of all views, all tiles of all views in one pool, so that no core waits for another view. The same view
    /// gives the same bits whatever it is rendered with, by how many threads, and whatever its window. Throws
    /// Cancelled.
    std::vector<Frame> render(std::span<const View> views, const RenderSettings& settings, Progress& progress,
                              std::vector<ViewStatistics>* statistics = nullptr) const;

    /// Only the visible part changes: the regions and the field stay.
    void setTransferFunction(const TransferFunction& transferFunction);

    /// Rays that one instruction handles, and the name of the instruction set, as chosen on this machine.
    static int lanes();
    static std::string target();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace brickwall
