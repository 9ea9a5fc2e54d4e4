// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Whole frames of the renderer against what this core can do at most (Roofline.h), and two threads against one. The
/// sides of a comparison take turns, so that whatever slows the machine down hits both: "ratio" is the median of the
/// turns' ratios, "least" and "most" the ends of the middle half. Rates are per second of processor time, per core.
#include "brickwall/bench/BenchScenes.h"
#include "brickwall/bench/Clock.h"
#include "brickwall/core/simd/Target.h"

#include <benchmark/benchmark.h>

#include <algorithm>

namespace brickwall::bench {
namespace {

constexpr int pixels = 512;
constexpr float dt = 0.5f;

double quantile(std::vector<double> values, double q)
{
    std::sort(values.begin(), values.end());
    return values[std::size_t(q * double(values.size() - 1) + 0.5)];
}

void report(benchmark::State& state, const std::vector<double>& ratios)
{
    state.counters["ratio"] = quantile(ratios, 0.5);
    state.counters["least"] = quantile(ratios, 0.25);
    state.counters["most"] = quantile(ratios, 0.75);
}

/// The dense twin of a scene, seen the same way, its rays made in advance.
class Roofline
{
public:
    explicit Roofline(const BenchScene& scene)
        : volume_(denseTwin(scene)), table_(tabulate(scene.scene.transferFunction))
    {
        const ViewRays rays(viewOf(scene, pixels), {vec3i(0), 2 * (volume_.size - 1)}, volume_.worldFromGrid, false);
        origin_ = rays.origin();
        tiles_ = tilesOf(rays, pixels);
        const Box3d box = scene.voxelBounds();
        lengthPerStep_ = dt * float((box.upper.x - box.lower.x) / (volume_.size.x - 1));
    }

    std::uint64_t operator()(Work work) const
    {
        std::uint64_t samples = 0;
        for (const RayTile& tile : tiles_)
            samples += marchDense(volume_, table_, work, dt, lengthPerStep_, origin_, tile, result_);
        benchmark::DoNotOptimize(result_);
        return samples;
    }

private:
    DenseVolume volume_;
    TransferTable table_;
    std::vector<RayTile> tiles_;
    vec3i origin_{0};
    float lengthPerStep_ = 0.0f;
    mutable TileResult result_;
};

RenderSettings midpoint()
{
    RenderSettings settings;
    settings.method = Method::midpoint;
    settings.step.dt = dt;
    settings.shading = Shading::off;
    return settings;
}

void againstRoofline(benchmark::State& state, const std::string& name)
{
    const BenchScene* scene = sceneNamed(name);
    if (!scene)
        return state.SkipWithError("these data are not there");
    const Roofline roofline(*scene);
    const Executor serial(1);
    const Renderer renderer(scene->scene, serial);
    const View view = viewOf(*scene, pixels);
    std::vector<ViewStatistics> statistics;
    Progress silent;
    std::vector<double> rates, roofs, ratios;
    for (auto _ : state) {
        std::uint64_t samples = 0;
        const double roofSeconds = secondsOf(CLOCK_THREAD_CPUTIME_ID, [&] { samples = roofline(Work::composite); });
        roofs.push_back(double(samples) / roofSeconds);
        const double frameSeconds = secondsOf(CLOCK_THREAD_CPUTIME_ID, [&] {
            benchmark::DoNotOptimize(renderer.render({&view, 1}, midpoint(), silent, &statistics));
        });
        rates.push_back(double(statistics[0].counts.samples) / frameSeconds);
        ratios.push_back(rates.back() / roofs.back());
        state.SetIterationTime(frameSeconds);
    }
    report(state, ratios);
    const TraceCounts& counts = statistics[0].counts;
    state.counters["roofline"] = quantile(roofs, 0.5);
    state.counters["samples"] = quantile(rates, 0.5);
    state.counters["cells"] = double(scene->cells);
    state.counters["samplesPerRay"] = double(counts.samples) / double(statistics[0].rays);
    state.counters["fetchesPerSample"] = double(counts.fetches) / double(std::max<std::uint64_t>(counts.samples, 1));
    state.counters["samplesPerRegion"] =
        double(counts.samples) / double(std::max<std::uint64_t>(counts.regionsVisited, 1));
}

/// "ratio" is one thread's wall time over that of two; "cpu" what one takes of processor time over what both take
/// together, which a loaded machine disturbs less: 1 says that two threads do no more work than one.
void twoThreads(benchmark::State& state, const std::string& name)
{
    const BenchScene* scene = sceneNamed(name);
    if (!scene)
        return state.SkipWithError("these data are not there");
    const Executor executors[] = {Executor(1), Executor(2)};
    const Renderer renderers[] = {{scene->scene, executors[0]}, {scene->scene, executors[1]}};
    const View view = viewOf(*scene, pixels);
    Progress silent;
    std::vector<double> wall, cpu;
    for (auto _ : state) {
        double walls[2], cpus[2];
        for (int i = 0; i < 2; ++i)
            walls[i] = secondsOf(CLOCK_MONOTONIC, [&] {
                cpus[i] = secondsOf(CLOCK_PROCESS_CPUTIME_ID, [&] {
                    benchmark::DoNotOptimize(renderers[i].render({&view, 1}, midpoint(), silent));
                });
            });
        wall.push_back(walls[0] / walls[1]);
        cpu.push_back(cpus[0] / cpus[1]);
        state.SetIterationTime(walls[1]);
    }
    report(state, wall);
    state.counters["best"] = *std::max_element(wall.begin(), wall.end());
    state.counters["cpu"] = quantile(cpu, 0.5);
}

/// Fetching alone: what of the roofline memory and interpolation take.
void fetch(benchmark::State& state)
{
    const Roofline roofline(*sceneNamed("sample:wake"));
    std::uint64_t samples = 0;
    for (auto _ : state)
        samples += roofline(Work::fetch);
    state.counters["samples"] = benchmark::Counter(double(samples), benchmark::Counter::kIsRate);
}
BENCHMARK(fetch)->Unit(benchmark::kMillisecond);

const bool registered = [] {
    benchmark::AddCustomContext("instruction_set", laneTarget());
    benchmark::AddCustomContext("lanes", std::to_string(laneCount()));
    for (const std::string& name : sceneNames()) {
        benchmark::RegisterBenchmark(("againstRoofline/" + name).c_str(), againstRoofline, name)
            ->Iterations(9)
            ->Repetitions(1)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
        benchmark::RegisterBenchmark(("twoThreads/" + name).c_str(), twoThreads, name)
            ->Iterations(9)
            ->Repetitions(1)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
    }
    return true;
}();

} // namespace
} // namespace brickwall::bench
