// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Large data, which the environment variable BRICKWALL_LARGE names. What a new transfer function or isovalue takes;
/// how far the levers of the frame time reach, from the finest setting to the coarsest of one view, and what error that
/// costs. Errors are
/// against `bounded` at a third of the finest tolerance; smaller pictures are brought to the size of the others
/// bilinearly.
#include "brickwall/bench/Clock.h"
#include "brickwall/core/base/Median.h"
#include "brickwall/core/io/PreparedVolume.h"
#include "brickwall/core/render/Compare.h"
#include "brickwall/core/render/Renderer.h"
#include "brickwall/core/shade/DefaultTransferFunction.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace brickwall::bench {
namespace {

constexpr int pixels = 128;

struct Levers
{
    float tolerance, cellPixels;
    int eighths; ///< of the picture's width
};

constexpr std::array settings{Levers{3e-5f, 0.0f, 8},   Levers{1e-4f, 0.0f, 8}, Levers{1e-3f, 0.0f, 8},
                              Levers{1.0f / 255, 0, 8}, Levers{1e-2f, 0.0f, 8}, Levers{3e-2f, 0.0f, 8},
                              Levers{3e-2f, 1.0f, 8},   Levers{3e-2f, 2.0f, 8}, Levers{3e-2f, 2.0f, 6},
                              Levers{3e-2f, 2.0f, 4},   Levers{3e-2f, 2.0f, 2}, Levers{3e-2f, 2.0f, 1}};

/// The blasts, a fifth of the domain, from the side.
View viewOf(const Box3d& bounds, int width)
{
    const double size = bounds.extent().x;
    const vec3d at = vec3d(0.5, 0.5, 0.0) * bounds.extent() + bounds.lower + vec3d(0.03, 0.0, 0.06) * size;
    const vec3d eye = at + glm::normalize(vec3d(0.4, -1.0, 0.3)) * 0.5 * size;
    return viewOfCamera("levers", eye, at, vec3d(0, 0, 1), 30.0, width, width, 0.01 * size, 4.0 * size);
}

struct Large
{
    std::unique_ptr<Renderer> renderer;
    Box3d bounds;
    Frame reference;
};

const Executor& executor()
{
    static const Executor all;
    return all;
}

Frame render(const Large& large, const Levers& levers)
{
    RenderSettings render;
    render.bounded.tolerance = levers.tolerance;
    render.lod.cellPixels = levers.cellPixels;
    Progress silent;
    const View view = viewOf(large.bounds, pixels * levers.eighths / 8);
    return std::move(large.renderer->render({&view, 1}, render, silent).front());
}

const Large* large()
{
    static const std::unique_ptr<Large> made = []() -> std::unique_ptr<Large> {
        const char* name = std::getenv("BRICKWALL_LARGE");
        if (!name)
            return nullptr;
        const auto data = openDataSet(name);
        Progress silent;
        const PreparedVolume volume = prepareVolume(*data, {name, {}, {data->defaultField()}, NonFinite::error, true},
                                                    userCache(), executor(), silent);
        Scene scene;
        scene.regions = volume.regions;
        scene.field = volume.fields.front();
        for (const PyramidMember& member : volume.pyramid)
            scene.pyramid.push_back({member.level, member.regions, member.fields.front()});
        scene.worldFromVoxel = volume.model.worldFromVoxel;
        const auto sample = sampleCells(volume.model, *volume.regions, *volume.fields.front(), sampledForDefault);
        scene.transferFunction =
            chooseTransferFunction(volume.model, volume.model.fields.front(), sample, "Cool Warm").tf;
        auto result = std::make_unique<Large>();
        result->bounds = worldBounds(volume.model);
        result->renderer = std::make_unique<Renderer>(std::move(scene), executor());
        result->reference = render(*result, {1e-5f, 0.0f, 8});
        return result;
    }();
    return made.get();
}

/// The picture in the size of `like`.
Frame enlarged(const Frame& small, const Frame& like)
{
    Frame frame = like;
    for (int y = 0; y < like.height; ++y)
        for (int x = 0; x < like.width; ++x) {
            const auto place = [](int i, int from, int to) {
                return glm::clamp((i + 0.5f) * float(to) / float(from) - 0.5f, 0.0f, float(to - 1));
            };
            const float u = place(x, like.width, small.width), v = place(y, like.height, small.height);
            const int x0 = int(u), y0 = int(v), x1 = std::min(x0 + 1, small.width - 1),
                      y1 = std::min(y0 + 1, small.height - 1);
            const auto row = [&](int at) {
                return glm::mix(small.color[small.index(x0, at)], small.color[small.index(x1, at)], u - float(x0));
            };
            frame.color[frame.index(x, y)] = glm::mix(row(y0), row(y1), v - float(y0));
        }
    return frame;
}

void levers(benchmark::State& state)
{
    if (!large())
        return state.SkipWithError("BRICKWALL_LARGE names no data set");
    std::array<std::vector<double>, settings.size()> times;
    std::array<FrameDifference, settings.size()> errors;
    for (auto _ : state)
        for (std::size_t i = 0; i < settings.size(); ++i) {
            Frame frame;
            times[i].push_back(secondsOf(CLOCK_PROCESS_CPUTIME_ID, [&] { frame = render(*large(), settings[i]); }));
            errors[i] = compareFrames(enlarged(frame, large()->reference), large()->reference);
        }
    const double finest = median(times.front());
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const std::string name = fmt::format("{:02}:{:.3g}/lod{:g}/{}of8:", i, settings[i].tolerance,
                                             settings[i].cellPixels, settings[i].eighths);
        state.counters[name + "cpuMs"] = 1e3 * median(times[i]);
        state.counters[name + "faster"] = finest / median(times[i]);
        state.counters[name + "max"] = errors[i].max;
        state.counters[name + "rms"] = errors[i].rms;
    }
}
BENCHMARK(levers)->Unit(benchmark::kMillisecond)->Iterations(1);

/// With a pyramid, whose members change as well: between the default and one that is a tenth less opaque.
void newTransferFunction(benchmark::State& state)
{
    if (!large())
        return state.SkipWithError("BRICKWALL_LARGE names no data set");
    const TransferFunction before = large()->renderer->scene().transferFunction;
    TransferFunction other = before;
    other.opacityScale *= 0.9f;
    bool changed = false;
    for (auto _ : state)
        large()->renderer->setTransferFunction((changed = !changed) ? other : before);
    large()->renderer->setTransferFunction(before);
}
BENCHMARK(newTransferFunction)->Unit(benchmark::kMillisecond)->UseRealTime();

void newIsovalue(benchmark::State& state)
{
    if (!large())
        return state.SkipWithError("BRICKWALL_LARGE names no data set");
    const Range range = large()->renderer->scene().field->range;
    float part = 0.4f;
    for (auto _ : state) {
        part = part > 0.5f ? 0.4f : part + 0.01f;
        large()->renderer->setSurfaces({{.value = range.lo + part * (range.hi - range.lo)}});
    }
    large()->renderer->setSurfaces({});
}
BENCHMARK(newIsovalue)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace
} // namespace brickwall::bench
