// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The walk through regions both ways: the kd-tree's order, and Embree's nearest box (docs/decisions/0045). In turns,
/// one thread, processor time.
#include "brickwall/bench/BenchScenes.h"
#include "brickwall/bench/Clock.h"
#include "brickwall/bench/EmbreeRegions.h"
#include "brickwall/core/base/Median.h"
#include "brickwall/core/simd/Target.h"
#include "brickwall/core/trace/VisibleNodes.h"

#include <benchmark/benchmark.h>

#include <optional>
#include <string>
#include <vector>

namespace brickwall::bench {
namespace {

constexpr int pixels = 256;

void walks(benchmark::State& state, const std::string& name)
{
    const BenchScene* data = sceneNamed(name);
    if (!data || laneCount() != 16)
        return state.SkipWithError("these data are not there, or no lanes for packets of 16 rays");
    const Executor serial(1);
    const Scene& scene = data->scene;
    const View view = viewOf(*data, pixels);
    const ViewRays rays(view, scene.regions->bounds, scene.worldFromVoxel, true);
    const std::vector<RayTile> tiles = tilesOf(rays, pixels);
    const Renderer renderer(scene, serial);
    const TransferIntegral integral = integrate(scene.transferFunction);
    std::vector<RegionBounds> bounds;
    std::vector<KdNode> nodes;
    const double kdBuild = secondsOf(CLOCK_THREAD_CPUTIME_ID, [&] {
        bounds = regionBounds(*scene.field, integral, serial);
        nodes = visibleNodes(*scene.regions, bounds, serial);
    });
    TraceScene trace;
    trace.regions = scene.regions.get();
    trace.nodes = nodes;
    trace.field = scene.field.get();
    trace.regionBounds = bounds;
    trace.origin = rays.origin();
    std::optional<EmbreeRegions> embree;
    const double embreeBuild = secondsOf(CLOCK_THREAD_CPUTIME_ID, [&] { embree.emplace(trace); });

    RenderSettings settings;
    settings.shading = Shading::off;
    Progress silent;
    std::vector<double> kd, boxes, ratios, frames;
    std::uint64_t kdRegions = 0, boxRegions = 0;
    for (auto _ : state) {
        kdRegions = boxRegions = 0;
        kd.push_back(secondsOf(CLOCK_THREAD_CPUTIME_ID, [&] {
            for (const RayTile& tile : tiles)
                kdRegions += countRegions(trace, tile);
        }));
        boxes.push_back(secondsOf(CLOCK_THREAD_CPUTIME_ID, [&] {
            for (const RayTile& tile : tiles)
                boxRegions += embree->count(tile);
        }));
        ratios.push_back(boxes.back() / kd.back());
        frames.push_back(secondsOf(CLOCK_THREAD_CPUTIME_ID, [&] {
            benchmark::DoNotOptimize(renderer.render({&view, 1}, settings, silent));
        }));
        state.SetIterationTime(kd.back());
    }
    state.counters["ratio"] = median(ratios);
    state.counters["kdMs"] = 1e3 * median(kd);
    state.counters["embreeMs"] = 1e3 * median(boxes);
    state.counters["frameMs"] = 1e3 * median(frames);
    state.counters["frameWithEmbree"] = (median(frames) - median(kd) + median(boxes)) / median(frames);
    state.counters["kdBuildMs"] = 1e3 * kdBuild;
    state.counters["embreeBuildMs"] = 1e3 * embreeBuild;
    state.counters["regions"] = double(kdRegions);
    state.counters["sameRegions"] = double(boxRegions) / double(kdRegions);
}
BENCHMARK_CAPTURE(walks, wake, "sample:wake")->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
BENCHMARK_CAPTURE(walks, cloud, "sample:cloud")->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
BENCHMARK_CAPTURE(walks, impact, "sample:impact")->UseManualTime()->Unit(benchmark::kMillisecond)->Iterations(9);
BENCHMARK_CAPTURE(walks, sphere, "exabrick/sphere_laminar.exa")
    ->UseManualTime()
    ->Unit(benchmark::kMillisecond)
    ->Iterations(9);

} // namespace
} // namespace brickwall::bench
