// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Renderer.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/InTurn.h"
#include "brickwall/core/render/RenderChecks.h"
#include "brickwall/core/render/TileRenderer.h"
#include "brickwall/core/simd/Target.h"
#include "brickwall/core/trace/BrickLimits.h"
#include "brickwall/core/trace/VisibleNodes.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <utility>

namespace brickwall {
namespace {

using Clock = std::chrono::steady_clock;

/// Entries at t = i / 1016: the 128 points of an ExaBrick transfer function, at k / 127, fall on every eighth.
constexpr int tableSize = 8 * 127 + 1;

std::array<double, 6> gradientMetric(const mat4d& worldFromVoxel)
{
    const glm::dmat3 inverse = stretchOf(worldFromVoxel) * glm::inverse(glm::dmat3(worldFromVoxel));
    const glm::dmat3 g = inverse * glm::transpose(inverse);
    return {g[0][0], g[1][1], g[2][2], g[0][1], g[0][2], g[1][2]};
}

std::array<float, 6> toFloat(const std::array<double, 6>& a)
{
    return {float(a[0]), float(a[1]), float(a[2]), float(a[3]), float(a[4]), float(a[5])};
}

struct Tile
{
    std::size_t view;
    int x, y; ///< in the frame
};

std::vector<Tile> tilesOf(const std::vector<Frame>& frames)
{
    std::vector<Tile> tiles;
    for (std::size_t i = 0; i < frames.size(); ++i)
        for (int y = 0; y < frames[i].height; y += TilePixels::width)
            for (int x = 0; x < frames[i].width; x += TilePixels::width)
                tiles.push_back({i, x, y});
    return tiles;
}

struct Counters
{
    std::mutex mutex;
    TileCounts counts;
    std::int64_t nanoseconds = 0; ///< of all threads

    void add(const TileCounts& tile, std::int64_t tileNanoseconds)
    {
        const std::lock_guard lock(mutex);
        counts += tile;
        nanoseconds += tileNanoseconds;
    }
};

ViewStatistics statisticsOf(const View& view, const Counters& counters, std::uint64_t rays,
                            const RenderSettings& settings, int threads)
{
    const TileCounts& c = counters.counts;
    ViewStatistics s;
    s.name = view.name;
    s.milliseconds = double(counters.nanoseconds) / 1e6 / threads;
    s.rays = rays;
    s.counts = c.trace;
    s.surfaceHits = c.surfaceHits;
    s.largestBound = c.largestBound;
    s.pixelsBeyond = c.pixelsBeyond;
    const auto used = std::find_if(c.memberSamples.rbegin(), c.memberSamples.rend(), [](auto n) { return n > 0; });
    s.memberSamples.assign(c.memberSamples.begin(), std::max(used.base(), c.memberSamples.begin() + 1));
    if (c.pixelsBeyond > 0)
        s.beyondBecause = fmt::format("their own estimate of the error is above {:g}, where rounding of 32-bit floats "
                                      "decides (rays that touch thin shells) or parts could not be split any further",
                                      settings.bounded.tolerance);
    return s;
}

} // namespace

struct Renderer::State
{
    Scene scene;
    const Executor& executor;
    TransferTable table;
    TransferIntegral integral;
    TransferTable colorTable; ///< these two if the colours are of another field
    TransferIntegral colorIntegral;
    /// Of the data, or of a member of the pyramid.
    struct Visible
    {
        std::vector<RegionBounds> bounds;
        std::vector<KdNode> nodes; ///< of the tree, without what the transfer function hides
    };
    Visible visible;
    std::vector<Visible> pyramid; ///< one per member
    std::vector<KdNode> surfaceNodes;

    bool isColoredByField() const { return scene.transferFunction.colorField.has_value(); }

    TraceScene volume(const RegionTree& regions, const PaddedField& field, const PaddedField* colorField,
                      const Visible& itsVisible) const
    {
        TraceScene s;
        s.regions = &regions;
        s.nodes = itsVisible.nodes;
        s.field = &field;
        s.table = &table;
        s.integral = &integral;
        s.regionBounds = itsVisible.bounds;
        s.gradientMetric = toFloat(gradientMetric(scene.worldFromVoxel));
        if (isColoredByField())
            s.colors = {colorField, &colorTable, &colorIntegral};
        return s;
    }

    TileScene tileScene() const
    {
        TileScene s;
        s.volume = volume(*scene.regions, *scene.field, scene.colorField.get(), visible);
        for (std::size_t i = 0; i < scene.pyramid.size(); ++i) {
            const SceneMember& member = scene.pyramid[i];
            s.pyramid.push_back(
                {member.level, volume(*member.regions, *member.field, member.colorField.get(), pyramid[i])});
        }
        s.surfaces = scene.surfaces;
        s.surfaceNodes = surfaceNodes;
        s.planes = scene.planes;
        s.transferFunction = &scene.transferFunction;
        s.clip = &scene.clip;
        s.worldFromVoxel = scene.worldFromVoxel;
        s.triangles = scene.triangles.get();
        s.occluders = scene.occluders.get();
        return s;
    }

    /// It knows of no planes and no light but the eye's: with others, surfaces are found as for the other methods.
    bool referenceHasSurfaces(const RenderSettings& settings) const
    {
        return settings.method == Method::reference && scene.planes.empty() && !settings.light &&
               !settings.ambientOcclusion && settings.specular.strength == 0.0f;
    }

    /// For one call of render: it is small, and made anew only for that method.
    std::optional<ReferenceIntegrator> reference(const RenderSettings& settings) const
    {
        if (settings.method != Method::reference)
            return {};
        const std::span<const IsoSurface> surfaces =
            referenceHasSurfaces(settings) ? scene.surfaces : std::span<const IsoSurface>();
        return ReferenceIntegrator(*scene.regions, *scene.field, scene.transferFunction, surfaces,
                                   gradientMetric(scene.worldFromVoxel), settings.shading == Shading::headlight,
                                   scene.colorField.get());
    }
};

Renderer::Renderer(Scene scene, const Executor& executor)
{
    checkScene(scene);
    const TransferFunction transferFunction = scene.transferFunction;
    state_ = std::make_unique<State>(State{std::move(scene), executor, {}, {}, {}, {}, {}, {}, {}});
    setTransferFunction(transferFunction);
    setSurfaces(std::vector<IsoSurface>(state_->scene.surfaces));
    setPlanes(std::vector<ContourPlane>(state_->scene.planes));
    setClip(ClipRegion(state_->scene.clip));
}

Renderer::~Renderer() = default;

const Scene& Renderer::scene() const
{
    return state_->scene;
}

void Renderer::setTransferFunction(const TransferFunction& transferFunction)
{
    checkTransferFunction(transferFunction, "transfer function");
    State& state = *state_;
    checkColorField(state.scene, transferFunction);
    const bool colored = transferFunction.colorField.has_value();
    const TransferFunction own = colored ? extinctionFunction(transferFunction) : transferFunction;
    state.table = tabulate(own, tableSize);
    state.integral = integrate(own);
    if (colored) {
        state.colorTable = tabulate(colorFunction(transferFunction), tableSize);
        state.colorIntegral = integrate(colorFunction(transferFunction));
    }
    const auto visibleOf = [&](const RegionTree& regions, const PaddedField& field, const PaddedField* colorField) {
        State::Visible v;
        v.bounds = regionBounds(field, state.integral, state.executor);
        if (colored)
            addColors(v.bounds, *colorField, state.colorIntegral, state.executor);
        v.nodes = visibleNodes(regions, v.bounds, state.executor);
        return v;
    };
    state.visible = visibleOf(*state.scene.regions, *state.scene.field, state.scene.colorField.get());
    state.pyramid.clear();
    for (const SceneMember& member : state.scene.pyramid)
        state.pyramid.push_back(visibleOf(*member.regions, *member.field, member.colorField.get()));
    state.scene.transferFunction = transferFunction;
}

void Renderer::setSurfaces(std::vector<IsoSurface> surfaces)
{
    for (const IsoSurface& surface : surfaces)
        checkSurface(surface);
    const Scene& scene = state_->scene;
    if (!surfaces.empty())
        state_->surfaceNodes = surfaceNodes(*scene.regions, *scene.field, surfaces, state_->executor);
    state_->scene.surfaces = std::move(surfaces);
}

void Renderer::setPlanes(std::vector<ContourPlane> planes)
{
    for (const ContourPlane& plane : planes)
        checkPlane(plane);
    state_->scene.planes = std::move(planes);
}

void Renderer::setClip(ClipRegion clip)
{
    checkClipRegion(clip);
    state_->scene.clip = std::move(clip);
}

void Renderer::setOccluders(std::shared_ptr<const TriangleScene> occluders)
{
    state_->scene.occluders = std::move(occluders);
}

std::vector<Frame> Renderer::render(std::span<const View> views, const RenderSettings& settings, Progress& progress,
                                    std::vector<ViewStatistics>* statistics) const
{
    const Scene& scene = state_->scene;
    checkSettings(settings, scene.regions->bounds);
    const std::optional<ReferenceIntegrator> reference = state_->reference(settings);
    TileScene tileScene = state_->tileScene();
    tileScene.reference = reference ? &*reference : nullptr;
    tileScene.referenceHasSurfaces = state_->referenceHasSurfaces(settings);
    std::vector<TileRenderer> renderers;
    std::vector<Frame> frames;
    for (const View& view : views) {
        renderers.emplace_back(
            ViewRays(view, scene.regions->bounds, scene.worldFromVoxel, settings.step.interleave, scene.clip),
            tileScene, settings);
        frames.push_back(emptyFrame(view));
    }

    const std::vector<Tile> tiles = tilesOf(frames);
    std::vector<Counters> counters(views.size());
    progress.begin("rendering", tiles.size());
    forEachInTurn(state_->executor, tiles.size(), [&](std::size_t i) {
        progress.check();
        const Tile& tile = tiles[i];
        const auto tileStart = Clock::now();
        const TileCounts counts = renderers[tile.view].render(tile.x, tile.y, frames[tile.view]);
        counters[tile.view].add(counts, std::chrono::nanoseconds(Clock::now() - tileStart).count());
        progress.advance(1);
    });
    progress.end();

    if (statistics) {
        statistics->clear();
        for (std::size_t i = 0; i < views.size(); ++i)
            statistics->push_back(
                statisticsOf(views[i], counters[i], frames[i].color.size(), settings, state_->executor.threads()));
    }
    return frames;
}

int Renderer::lanes()
{
    return laneCount();
}

std::string Renderer::target()
{
    return laneTarget();
}

} // namespace brickwall
