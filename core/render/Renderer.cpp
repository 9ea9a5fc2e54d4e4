// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Renderer.h"

#include "brickwall/core/base/Error.h"
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

void checkData(const RegionTree* regions, const PaddedField* field)
{
    if (!regions || !field)
        throw Error("scene", "expected regions and a field, found none");
    if (field->values.size() != regions->paddedCellCount || field->regionRanges.size() != regions->regions.size())
        throw Error("scene", "the field belongs to other regions: pad it for these");
    checkBrickSizes(*regions);
}

void checkScene(const Scene& scene)
{
    checkData(scene.regions.get(), scene.field.get());
    int last = 0;
    for (const SceneMember& member : scene.pyramid) {
        checkData(member.regions.get(), member.field.get());
        if (member.level <= std::exchange(last, member.level) || member.level > maxLevel)
            throw Error("scene", "expected members of a pyramid with levels above 0 in ascending order");
    }
}

void checkLod(const LodConfig& config)
{
    if (!(config.cellPixels >= 0.0f) || !std::isfinite(config.cellPixels))
        throw Error("lod", fmt::format("expected a finite number of 0 or more, found {:g}", config.cellPixels));
}

/// Ray parameters are floats: steps have to be more than their rounding, or a ray would stand still.
void checkSteps(const StepConfig& config, const Box3i& halfBounds)
{
    const double extent = 0.5 * glm::length(vec3d(halfBounds.extent()));
    const double least = extent * 0x1p-22;
    if (!(config.dt > least) || !std::isfinite(config.dt))
        throw Error("dt", fmt::format("expected a step of more than {:.2g} cells for data of this extent, found {:g}",
                                      least, config.dt));
    if (!(config.terminationOpacity > 0.0f && config.terminationOpacity <= 1.0f))
        throw Error("termination opacity",
                    fmt::format("expected more than 0 and at most 1, found {:g}", config.terminationOpacity));
}

void checkSurface(const IsoSurface& surface)
{
    if (!std::isfinite(surface.value))
        throw Error("isosurface", fmt::format("expected a finite value, found {:g}", surface.value));
    for (int c = 0; c < 3; ++c)
        if (!(surface.color[c] >= 0.0f && surface.color[c] <= 1.0f))
            throw Error("isosurface",
                        fmt::format("expected a colour with components in [0, 1], found {:g}", surface.color[c]));
    if (!(surface.opacity > 0.0f && surface.opacity <= 1.0f))
        throw Error("isosurface",
                    fmt::format("expected an opacity of more than 0 and at most 1, found {:g}", surface.opacity));
}

void checkPlane(const ContourPlane& contour)
{
    checkPlane(contour.plane, "contour plane");
    if (!(contour.opacity > 0.0f && contour.opacity <= 1.0f))
        throw Error("contour plane",
                    fmt::format("expected an opacity of more than 0 and at most 1, found {:g}", contour.opacity));
}

void checkTolerance(const BoundedConfig& config)
{
    if (!(config.tolerance > 0.0f && config.tolerance <= 1.0f))
        throw Error("tolerance", fmt::format("expected more than 0 and at most 1, found {:g}", config.tolerance));
}

void checkLight(const Light& light)
{
    const double length = glm::length(light.towards);
    if (!(length > 0.0) || !std::isfinite(length))
        throw Error("light", fmt::format("expected a finite direction, not of length 0, found ({:g}, {:g}, {:g})",
                                         light.towards.x, light.towards.y, light.towards.z));
    if (!(light.ambient >= 0.0f && light.ambient <= 1.0f))
        throw Error("light", fmt::format("expected an ambient part from 0 to 1, found {:g}", light.ambient));
    if (!(light.tolerance > 0.0f && light.tolerance <= 1.0f))
        throw Error("light",
                    fmt::format("expected a tolerance of more than 0 and at most 1, found {:g}", light.tolerance));
}

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

Frame emptyFrame(const View& view)
{
    Frame frame{view, view.window.width, view.window.height, {}, {}};
    const std::size_t pixels = std::size_t(frame.width) * frame.height;
    frame.color.resize(pixels, vec4f(0.0f));
    frame.depth.resize(pixels, 1.0f);
    return frame;
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
    /// Of the data, or of a member of the pyramid.
    struct Visible
    {
        std::vector<RegionBounds> bounds;
        std::vector<KdNode> nodes; ///< of the tree, without what the transfer function hides
    };
    Visible visible;
    std::vector<Visible> pyramid; ///< one per member
    std::vector<KdNode> surfaceNodes;

    TraceScene volume(const RegionTree& regions, const PaddedField& field, const Visible& itsVisible) const
    {
        TraceScene s;
        s.regions = &regions;
        s.nodes = itsVisible.nodes;
        s.field = &field;
        s.table = &table;
        s.integral = &integral;
        s.regionBounds = itsVisible.bounds;
        s.gradientMetric = toFloat(gradientMetric(scene.worldFromVoxel));
        return s;
    }

    Visible visibleOf(const RegionTree& regions, const PaddedField& field) const
    {
        Visible v;
        v.bounds = regionBounds(field, integral, executor);
        v.nodes = visibleNodes(regions, v.bounds, executor);
        return v;
    }

    TileScene tileScene() const
    {
        TileScene s;
        s.volume = volume(*scene.regions, *scene.field, visible);
        for (std::size_t i = 0; i < scene.pyramid.size(); ++i) {
            const SceneMember& member = scene.pyramid[i];
            s.pyramid.push_back({member.level, volume(*member.regions, *member.field, pyramid[i])});
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

    /// For one call of render: it is small, and made anew only for that method.
    std::optional<ReferenceIntegrator> reference(const RenderSettings& settings) const
    {
        if (settings.method != Method::reference)
            return {};
        const std::span<const IsoSurface> surfaces = settings.light || !scene.planes.empty()
                                                         ? std::span<const IsoSurface>()
                                                         : scene.surfaces; // TileRenderer adds them
        return ReferenceIntegrator(*scene.regions, *scene.field, scene.transferFunction, surfaces,
                                   gradientMetric(scene.worldFromVoxel), settings.shading == Shading::headlight);
    }
};

Renderer::Renderer(Scene scene, const Executor& executor)
{
    checkScene(scene);
    const TransferFunction transferFunction = scene.transferFunction;
    state_ = std::make_unique<State>(State{std::move(scene), executor, {}, {}, {}, {}, {}});
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
    const Scene& scene = state_->scene;
    TransferTable table = tabulate(transferFunction, tableSize);
    state_->integral = integrate(transferFunction);
    state_->visible = state_->visibleOf(*scene.regions, *scene.field);
    state_->pyramid.clear();
    for (const SceneMember& member : scene.pyramid)
        state_->pyramid.push_back(state_->visibleOf(*member.regions, *member.field));
    state_->table = std::move(table);
    state_->scene.transferFunction = transferFunction;
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
    checkSteps(settings.step, scene.regions->bounds);
    checkTolerance(settings.bounded);
    if (settings.light)
        checkLight(*settings.light);
    checkLod(settings.lod);
    const std::optional<ReferenceIntegrator> reference = state_->reference(settings);
    TileScene tileScene = state_->tileScene();
    tileScene.reference = reference ? &*reference : nullptr;
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
    state_->executor.forEach(tiles.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            progress.check();
            const Tile& tile = tiles[i];
            const auto tileStart = Clock::now();
            const TileCounts counts = renderers[tile.view].render(tile.x, tile.y, frames[tile.view]);
            counters[tile.view].add(counts, std::chrono::nanoseconds(Clock::now() - tileStart).count());
            progress.advance(1);
        }
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
