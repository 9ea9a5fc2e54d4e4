// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/bench/BenchScenes.h"

#include "brickwall/core/io/ProceduralSet.h"
#include "brickwall/core/scene/SceneSetup.h"
#include "brickwall/core/shade/DefaultTransferFunction.h"
#include "brickwall/core/trace/SamplePoints.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>

namespace brickwall::bench {
namespace {

const std::vector<std::string> shared = {"exabrick/sphere_laminar.exa", "exabrick/flash_sedov.exa",
                                         "amrex/blast_small_plt00050", "chombo/chk000100.3d.hdf5", "vdb/smoke.vdb"};

std::string pathOf(const std::string& name)
{
    return std::string(BRICKWALL_SOURCE_DIR) + "/../shared/data/" + name;
}

std::unique_ptr<BenchScene> load(const std::string& data)
{
    SceneOptions options;
    options.data = data;
    const Executor all;
    Progress silent;
    PreparedScene prepared = prepareScene(options, all, silent);
    return std::make_unique<BenchScene>(BenchScene{std::move(prepared.scene), prepared.cells});
}

std::vector<Brick> denseBricks(const vec3i& cells, int level)
{
    constexpr int width = 64;
    std::vector<Brick> bricks;
    std::uint64_t begin = 0;
    for (int z = 0; z < cells.z; z += width)
        for (int y = 0; y < cells.y; y += width)
            for (int x = 0; x < cells.x; x += width) {
                const vec3i lower(x, y, z), size = glm::min(cells - lower, vec3i(width));
                bricks.push_back({lower << level, size, level, begin});
                begin += bricks.back().cellCount();
            }
    return bricks;
}

std::unique_ptr<BenchScene> denseScene()
{
    const ProceduralSet set = proceduralWake(2'000'000);
    const Executor all;
    Progress silent;
    Model model;
    // As many root blocks of 8 cells as make two million cells of one level.
    const double blocks = double(set.rootBlocks.x) * set.rootBlocks.y * set.rootBlocks.z;
    const int refined = int(std::round(std::log2(2e6 / 512 / blocks) / 3));
    const int level = set.levels - 1 - refined;
    model.bricks = denseBricks((8 * set.rootBlocks) << refined, level);
    model.worldFromVoxel = set.worldFromVoxel;
    const Field field = sampleField(set.fields.front(), set.worldFromVoxel, model.bricks, all, silent);
    auto regions = std::make_shared<RegionTree>(buildRegions(model.bricks, all, silent));
    auto padded = std::make_shared<PaddedField>(padField(field, model.bricks, *regions, all, silent));
    model.cellCount = field.values.size();
    const TransferFunction tf = chooseTransferFunction(model, field).tf;
    return std::make_unique<BenchScene>(
        BenchScene{{regions, padded, nullptr, tf, set.worldFromVoxel, {}}, field.values.size()});
}

std::unique_ptr<BenchScene> make(const std::string& name)
{
    if (name == "dense")
        return denseScene();
    if (name.rfind("sample:", 0) == 0)
        return load(name + ":2M");
    return std::filesystem::exists(pathOf(name)) ? load(pathOf(name)) : nullptr;
}

} // namespace

Box3d BenchScene::voxelBounds() const
{
    const Box3i& half = scene.regions->bounds;
    return {0.5 * vec3d(half.lower), 0.5 * vec3d(half.upper)};
}

std::vector<std::string> sceneNames()
{
    std::vector<std::string> names{"dense", "sample:wake", "sample:cloud", "sample:impact"};
    names.insert(names.end(), shared.begin(), shared.end());
    return names;
}

const BenchScene* sceneNamed(const std::string& name)
{
    static std::map<std::string, std::unique_ptr<BenchScene>> scenes;
    const auto [at, isNew] = scenes.try_emplace(name);
    if (isNew)
        at->second = make(name);
    return at->second.get();
}

View viewOf(const BenchScene& scene, int pixels)
{
    const Box3d box = scene.voxelBounds();
    const vec3d lower = transformPoint(scene.scene.worldFromVoxel, box.lower);
    const vec3d upper = transformPoint(scene.scene.worldFromVoxel, box.upper);
    const vec3d middle = 0.5 * (lower + upper), extent = upper - lower;
    return viewOfCamera("bench", middle + vec3d(-0.5, 0.4, 1.0) * extent.x * 0.8, middle, {0, 1, 0}, 50.0, pixels,
                        pixels, 0.01 * extent.x, 1000.0 * extent.x);
}

std::vector<RayTile> tilesOf(const ViewRays& rays, int pixels)
{
    std::vector<RayTile> tiles;
    TilePixels places;
    for (int y = 0; y < pixels; y += TilePixels::width)
        for (int x = 0; x < pixels; x += TilePixels::width)
            rays.fill(x, y, places, tiles.emplace_back());
    return tiles;
}

DenseVolume denseTwin(const BenchScene& scene)
{
    const Box3d box = scene.voxelBounds();
    const vec3d extent = box.upper - box.lower;
    const double width = std::cbrt(extent.x * extent.y * extent.z / double(scene.scene.field->values.size()));
    DenseVolume volume(glm::max(vec3i(glm::round(extent / width)), vec3i(2)));
    const mat4d voxelFromGrid = glm::scale(glm::translate(mat4d(1.0), box.lower), extent / vec3d(volume.size - 1));
    volume.worldFromGrid = scene.scene.worldFromVoxel * voxelFromGrid;
    const Executor all;
    all.forEach(std::size_t(volume.size.z), 1, [&](std::size_t begin, std::size_t end) {
        const Executor serial(1);
        std::vector<vec3d> points(std::size_t(volume.size.x));
        std::vector<PointSample> samples(points.size());
        for (std::size_t z = begin; z < end; ++z)
            for (int y = 0; y < volume.size.y; ++y) {
                for (int x = 0; x < volume.size.x; ++x)
                    points[std::size_t(x)] = transformPoint(volume.worldFromGrid, vec3d(x, y, double(z)));
                samplePoints(*scene.scene.regions, *scene.scene.field, scene.scene.worldFromVoxel, points, samples,
                             serial);
                float* row = volume.values.data() + std::size_t(volume.size.x) * (y + z * volume.size.y);
                std::transform(samples.begin(), samples.end(), row, [](const PointSample& s) { return s.value; });
            }
    });
    return volume;
}

} // namespace brickwall::bench
