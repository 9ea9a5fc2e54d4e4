// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What each stage costs by itself, from loose cells to a picture, on one thread: `sample:wake` of 2 million cells.
#include "brickwall/bench/BenchScenes.h"
#include "brickwall/core/io/Sample.h"
#include "brickwall/core/model/BrickBuilder.h"
#include "brickwall/core/model/Pyramid.h"
#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/core/scene/SceneOptions.h"
#include "brickwall/core/trace/VisibleNodes.h"

#include <benchmark/benchmark.h>

#include <string>
#include <vector>

namespace brickwall::bench {
namespace {

const std::string sampleName = "sample:wake:2M";

const Executor& serial()
{
    static const Executor executor(1);
    return executor;
}

const Model& model()
{
    static const Model loaded = [] {
        const auto data = openSample(sampleName);
        Progress silent;
        return data->load(std::vector{data->defaultField()}, Executor(), silent);
    }();
    return loaded;
}

const Scene& scene()
{
    return sceneNamed("sample:wake")->scene;
}

void perCell(benchmark::State& state)
{
    state.counters["cells"] =
        benchmark::Counter(double(model().cellCount) * double(state.iterations()), benchmark::Counter::kIsRate);
}

/// A file of ExaBrick: mapped, checked, its values copied.
void load(benchmark::State& state)
{
    SceneOptions options;
    options.data = std::string(BRICKWALL_SOURCE_DIR) + "/../shared/data/exabrick/sphere_laminar.exa";
    Progress silent;
    std::uint64_t cells = 0;
    for (auto _ : state) {
        const auto data = openData(options);
        cells = data->load(std::vector{data->defaultField()}, serial(), silent).cellCount;
    }
    state.counters["cells"] =
        benchmark::Counter(double(cells) * double(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(load)->Unit(benchmark::kMillisecond);

void bricks(benchmark::State& state)
{
    std::vector<Cell> cells;
    for (const Brick& b : model().bricks)
        for (int z = 0; z < b.size.z; ++z)
            for (int y = 0; y < b.size.y; ++y)
                for (int x = 0; x < b.size.x; ++x)
                    cells.push_back({b.lower + (vec3i(x, y, z) << b.level), b.level});
    Progress silent;
    for (auto _ : state)
        benchmark::DoNotOptimize(buildBricks(cells, "bench", {}, serial(), silent));
    perCell(state);
}
BENCHMARK(bricks)->Unit(benchmark::kMillisecond);

void regions(benchmark::State& state)
{
    Progress silent;
    for (auto _ : state)
        benchmark::DoNotOptimize(buildRegions(model().bricks, serial(), silent));
    perCell(state);
}
BENCHMARK(regions)->Unit(benchmark::kMillisecond);

void padding(benchmark::State& state)
{
    Progress silent;
    for (auto _ : state)
        benchmark::DoNotOptimize(padField(model().fields.front(), model().bricks, *scene().regions, serial(), silent));
    perCell(state);
}
BENCHMARK(padding)->Unit(benchmark::kMillisecond);

void pyramid(benchmark::State& state)
{
    Progress silent;
    std::size_t bytes = 0;
    for (auto _ : state) {
        bytes = 0;
        for (const PyramidMember& member : buildPyramid(model(), {}, serial(), silent))
            bytes += member.bytes();
    }
    perCell(state);
    state.counters["ofTheData"] = double(bytes) / double(scene().regions->bytes() + scene().field->bytes());
}
BENCHMARK(pyramid)->Unit(benchmark::kMillisecond);

/// A new transfer function: its tables.
void rangeTables(benchmark::State& state)
{
    for (auto _ : state) {
        benchmark::DoNotOptimize(tabulate(scene().transferFunction));
        benchmark::DoNotOptimize(integrate(scene().transferFunction));
    }
}
BENCHMARK(rangeTables)->Unit(benchmark::kMillisecond);

/// And what of each region it shows, and the nodes that are left.
void rangeQueries(benchmark::State& state)
{
    const TransferIntegral integral = integrate(scene().transferFunction);
    for (auto _ : state) {
        const auto bounds = regionBounds(*scene().field, integral, serial());
        benchmark::DoNotOptimize(visibleNodes(*scene().regions, bounds, serial()));
    }
    state.counters["regions"] = benchmark::Counter(double(scene().regions->regions.size()) * double(state.iterations()),
                                                   benchmark::Counter::kIsRate);
}
BENCHMARK(rangeQueries)->Unit(benchmark::kMillisecond);

constexpr int pixels = 256;

void walk(benchmark::State& state)
{
    const ViewRays rays(viewOf(*sceneNamed("sample:wake"), pixels), scene().regions->bounds, scene().worldFromVoxel,
                        true);
    const std::vector<RayTile> tiles = tilesOf(rays, pixels);
    const auto bounds = regionBounds(*scene().field, integrate(scene().transferFunction), serial());
    const std::vector<KdNode> nodes = visibleNodes(*scene().regions, bounds, serial());
    TraceScene trace;
    trace.regions = scene().regions.get();
    trace.nodes = nodes;
    trace.field = scene().field.get();
    trace.origin = rays.origin();
    std::uint64_t visited = 0;
    for (auto _ : state)
        for (const RayTile& tile : tiles)
            visited += countRegions(trace, tile);
    state.counters["regions"] = benchmark::Counter(double(visited), benchmark::Counter::kIsRate);
}
BENCHMARK(walk)->Unit(benchmark::kMillisecond);

/// A whole frame: rays, walk, samples, compositing, depth.
void integration(benchmark::State& state, Method method, Shading shading)
{
    const Renderer renderer(scene(), serial());
    const View view = viewOf(*sceneNamed("sample:wake"), pixels);
    RenderSettings settings;
    settings.method = method;
    settings.shading = shading;
    std::vector<ViewStatistics> statistics;
    Progress silent;
    for (auto _ : state)
        benchmark::DoNotOptimize(renderer.render({&view, 1}, settings, silent, &statistics));
    state.counters["samples"] = benchmark::Counter(double(statistics[0].counts.samples) * double(state.iterations()),
                                                   benchmark::Counter::kIsRate);
    state.counters["samplesPerRay"] = double(statistics[0].counts.samples) / double(statistics[0].rays);
}
BENCHMARK_CAPTURE(integration, midpoint, Method::midpoint, Shading::off)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(integration, midpointHeadlight, Method::midpoint, Shading::headlight)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(integration, bounded, Method::bounded, Shading::off)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(integration, boundedHeadlight, Method::bounded, Shading::headlight)->Unit(benchmark::kMillisecond);

/// Frame to picture.
void resolve(benchmark::State& state)
{
    const View view = viewOf(*sceneNamed("sample:wake"), pixels);
    Progress silent;
    const Frame frame = Renderer(scene(), serial()).render({&view, 1}, {}, silent).front();
    for (auto _ : state)
        benchmark::DoNotOptimize(imageOver(frame, vec3f(0.0f)));
    state.counters["pixels"] =
        benchmark::Counter(double(pixels) * pixels * double(state.iterations()), benchmark::Counter::kIsRate);
}
BENCHMARK(resolve)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace brickwall::bench
