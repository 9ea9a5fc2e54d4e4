// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "ShowPictures.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/TransferIntegral.h"
#include "brickwall/core/trace/RegionBounds.h"
#include "brickwall/core/trace/VisibleNodes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace brickwall {
namespace {

using Numbers = std::vector<float>; ///< per pixel, as in a frame

/// From the statistics of views of one pixel, a row at a time.
template <class NumberOf>
Numbers numbersOf(const Renderer& renderer, const View& view, const RenderSettings& settings, Progress& progress,
                  const NumberOf& numberOf)
{
    Numbers numbers;
    Progress silent;
    for (int y = 0; y < view.window.height; ++y) {
        progress.check();
        std::vector<View> pixels;
        for (int x = 0; x < view.window.width; ++x)
            pixels.push_back(tileOf(view, {x, y, 1, 1}));
        std::vector<ViewStatistics> statistics;
        renderer.render(pixels, settings, silent, &statistics);
        for (const ViewStatistics& s : statistics)
            numbers.push_back(static_cast<float>(numberOf(s)));
        progress.advance(std::size_t(view.window.width));
    }
    return numbers;
}

/// The part of a ray in a node's box, through all of the nodes below it.
class FinestLevel
{
public:
    FinestLevel(const RegionTree& tree, std::span<const KdNode> nodes, const vec3d& org, const vec3d& dir)
        : tree_(tree), nodes_(nodes), org_(org), dir_(dir)
    {
    }

    /// -1 if there is nothing on the way.
    int operator()(double t0, double t1, std::uint32_t index = 0) const
    {
        if (!(t0 < t1))
            return -1;
        const KdNode& node = nodes_[index];
        if (node.axis == 3)
            return node.child == KdNode::emptyLeaf ? -1 : int(tree_.regions[node.child].finestLevel);
        const double away = 0.5 * node.plane - org_[node.axis], along = dir_[node.axis];
        const bool upwards = along > 0.0 || (along == 0.0 && away <= 0.0);
        // Where the ray is on the plane; one that runs beside it stays on its side.
        const double t = along == 0.0 ? t0 : std::clamp(away / along, t0, t1);
        const std::uint32_t lower = node.child, upper = node.child + 1;
        const int first = (*this)(t0, t, upwards ? lower : upper), second = (*this)(t, t1, upwards ? upper : lower);
        return first < 0 ? second : second < 0 ? first : std::min(first, second);
    }

private:
    const RegionTree& tree_;
    std::span<const KdNode> nodes_;
    vec3d org_, dir_; ///< voxels
};

Numbers levelsOf(const Scene& scene, const View& view, const Executor& executor)
{
    const auto bounds = regionBounds(*scene.field, integrate(scene.transferFunction), executor);
    const std::vector<KdNode> nodes = visibleNodes(*scene.regions, bounds, executor);
    const ViewRays rays(view, scene.regions->bounds, scene.worldFromVoxel, false, scene.clip);
    Numbers numbers(std::size_t(view.window.width) * view.window.height);
    TilePixels pixels;
    RayTile tile;
    for (int y = 0; y < view.window.height; y += TilePixels::width)
        for (int x = 0; x < view.window.width; x += TilePixels::width) {
            rays.fill(x, y, pixels, tile);
            for (int i = 0; i < tile.count; ++i) {
                const vec3d org = vec3d(tile.org[0][i], tile.org[1][i], tile.org[2][i]) + 0.5 * vec3d(rays.origin());
                const vec3d dir(tile.dir[0][i], tile.dir[1][i], tile.dir[2][i]);
                numbers[std::size_t(pixels.y[i]) * view.window.width + pixels.x[i]] =
                    static_cast<float>(FinestLevel(*scene.regions, nodes, org, dir)(tile.tNear[i], tile.tFar[i]));
            }
        }
    return numbers;
}

Numbers numbersOf(const Renderer& renderer, const View& view, const RenderSettings& settings, Show what,
                  const Executor& executor, Progress& progress)
{
    switch (what) {
    case Show::cost:
        return numbersOf(renderer, view, settings, progress, [](const auto& s) { return s.counts.samples; });
    case Show::regions:
        return numbersOf(renderer, view, settings, progress, [](const auto& s) { return s.counts.regionsVisited; });
    case Show::error:
        return numbersOf(renderer, view, settings, progress, [](const auto& s) { return s.largestBound; });
    case Show::levels:
        break;
    }
    return levelsOf(renderer.scene(), view, executor);
}

/// Above all but a thousandth: a ray along a surface may take a hundred times what the others do, and would leave them
/// black.
float topOf(Numbers numbers)
{
    const auto top = numbers.begin() + std::ptrdiff_t(std::ceil(0.999 * double(numbers.size() - 1)));
    std::nth_element(numbers.begin(), top, numbers.end());
    return *top;
}

} // namespace

ShownView showView(const Renderer& renderer, const View& view, const RenderSettings& settings, Show what,
                   const Executor& executor, Progress& progress)
{
    if (what == Show::error && settings.method != Method::bounded)
        throw Error("--show error", "only the method bounded says how much it errs");
    constexpr std::array titles = {"samples per pixel", "regions per pixel", "finest level", "error bound"};
    progress.begin("counting pixel by pixel", std::size_t(view.window.width) * view.window.height);
    const Numbers numbers = numbersOf(renderer, view, settings, what, executor, progress);
    progress.end();

    ShownView shown{emptyFrame(view), emptyFrame(view), {}, titles.at(std::size_t(what)), 0.0};
    const float least = what == Show::levels ? -1.0f : 0.0f, largest = topOf(numbers);
    shown.scale.range = {least, std::max(largest, least + (what == Show::error ? 1e-6f : 1.0f))};
    shown.scale.colors = colorMap("Inferno");
    shown.scale.opacity = {{0.0f, 1.0f}};
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        shown.numbers.color[i] = vec4f(vec3f(numbers[i]), 1.0f);
        shown.colors.color[i] = vec4f(vec3f(colorAt(shown.scale, numbers[i])), 1.0f);
    }
    shown.mean = std::accumulate(numbers.begin(), numbers.end(), 0.0) / double(numbers.size());
    return shown;
}

} // namespace brickwall
