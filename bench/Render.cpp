// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What a picture of a wake behind a ball costs, on one thread. "samples" and "regions" are rates per second of its
/// processor time, so per core.
#include "brickwall/core/io/ProceduralSet.h"
#include "brickwall/core/render/Renderer.h"
#include "brickwall/core/simd/Target.h"

#include <benchmark/benchmark.h>

#include <utility>

namespace brickwall {
namespace {

struct Data
{
    Executor serial{1};
    mat4d worldFromVoxel{1.0};
    std::vector<Brick> bricks;
    Field field;
    std::shared_ptr<RegionTree> regions;
    std::shared_ptr<PaddedField> padded;

    Data(const ProceduralSet& set, std::vector<Brick> itsBricks)
        : worldFromVoxel(set.worldFromVoxel), bricks(std::move(itsBricks))
    {
        const Executor all;
        Progress silent;
        field = sampleField(set.fields.front(), worldFromVoxel, bricks, all, silent);
        regions = std::make_shared<RegionTree>(buildRegions(bricks, all, silent));
        padded = std::make_shared<PaddedField>(padField(field, bricks, *regions, all, silent));
    }
};

const Data& wake()
{
    static const ProceduralSet set = proceduralWake(2'000'000);
    Progress silent;
    static const Data data(set, refineBlocks(set, Executor(), silent));
    return data;
}

/// The same field in one brick: what is left is the march of a dense volume.
const Data& dense()
{
    static const ProceduralSet set = proceduralWake(2'000'000);
    static const Data data(set, {Brick{vec3i(0), 8 * set.rootBlocks, set.levels - 1, 0}});
    return data;
}

/// From the side and in front, filling the picture.
View viewOf(const Data& data, int pixels)
{
    const Box3i half = data.regions->bounds;
    const vec3d lower = transformPoint(data.worldFromVoxel, 0.5 * vec3d(half.lower));
    const vec3d upper = transformPoint(data.worldFromVoxel, 0.5 * vec3d(half.upper));
    const vec3d middle = 0.5 * (lower + upper), extent = upper - lower;
    return viewOfCamera("bench", middle + vec3d(-0.5, 0.4, 1.0) * extent.x * 0.8, middle, {0, 1, 0}, 50.0, pixels,
                        pixels, 0.01, 1000.0);
}

/// Opacity rises over the range, so that rays go deep; `cut` hides the values below that part of the range.
TransferFunction translucent(const Data& data, float cut)
{
    TransferFunction tf;
    tf.range = data.padded->range;
    tf.colors = {{0.0f, {0.1f, 0.2f, 0.9f}}, {0.5f, {0.9f, 0.9f, 0.9f}}, {1.0f, {0.9f, 0.2f, 0.1f}}};
    tf.opacity = {{cut, 0.0f}, {1.0f, 0.05f}};
    return tf;
}

void march(benchmark::State& state, const Data& (*source)(), Shading shading, float cut)
{
    const Data& data = source();
    const Renderer renderer({data.regions, data.padded, nullptr, translucent(data, cut), data.worldFromVoxel, {}},
                            data.serial);
    const View view = viewOf(data, 512);
    RenderSettings settings;
    settings.method = Method::midpoint;
    settings.shading = shading;
    settings.step.terminationOpacity = 1.0f;
    std::vector<ViewStatistics> statistics;
    Progress silent;
    for (auto _ : state)
        benchmark::DoNotOptimize(renderer.render({&view, 1}, settings, silent, &statistics));
    using benchmark::Counter;
    const auto runs = double(state.iterations());
    state.counters["samples"] = Counter(runs * double(statistics[0].counts.samples), Counter::kIsRate);
    state.counters["regions"] = Counter(runs * double(statistics[0].counts.regionsVisited), Counter::kIsRate);
    state.counters["samplesPerRay"] = double(statistics[0].counts.samples) / double(statistics[0].rays);
    state.counters["regionsPerRay"] = double(statistics[0].counts.regionsVisited) / double(statistics[0].rays);
    state.SetLabel(Renderer::target() + ", " + std::to_string(Renderer::lanes()) + " lanes");
}

BENCHMARK_CAPTURE(march, unshaded, wake, Shading::off, 0.0f)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, headlight, wake, Shading::headlight, 0.0f)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, partHidden, wake, Shading::headlight, 0.8f)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(march, oneBrick, dense, Shading::headlight, 0.0f)->Unit(benchmark::kMillisecond);

void marchOn(benchmark::State& state)
{
    const auto targets = laneTargets();
    const auto wanted = static_cast<std::size_t>(state.range(0));
    if (wanted >= targets.size())
        return state.SkipWithError("this machine, or this build, has no further instruction set");
    chooseLaneTarget(targets[wanted]);
    march(state, wake, Shading::headlight, 0.0f);
    chooseLaneTarget("");
}
BENCHMARK(marchOn)->DenseRange(1, 2)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace brickwall
