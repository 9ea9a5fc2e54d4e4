// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/scene/SceneSetup.h"

#include "brickwall/core/base/Stopwatch.h"
#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/model/Pyramid.h"
#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/DefaultTransferFunction.h"
#include "brickwall/core/shade/TransferFunctionFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace brickwall {
namespace {

TransferFunction chooseTransferFunctionFor(const SceneOptions& options, const Model& model, Field& field,
                                           Progress& progress)
{
    if (!options.range.empty())
        field.preferredRange = {static_cast<float>(options.range[0]), static_cast<float>(options.range[1])};
    const std::string colors = options.colorMap.empty() ? "Cool Warm" : options.colorMap;
    TransferFunction tf;
    if (options.transferFunction.empty()) {
        DefaultChoice choice = chooseTransferFunction(model, field, colors);
        progress.note(choice.explanation);
        tf = std::move(choice.tf);
    } else {
        const Range& range = field.preferredRange.empty() ? field.range : field.preferredRange;
        tf = readTransferFunction(options.transferFunction, colorMap(colors), range);
        if (!options.colorMap.empty())
            tf.colors = colorMap(colors);
        if (!options.range.empty())
            tf.range = range;
    }
    tf.opacityScale *= options.volume == "off" ? 0.0f : static_cast<float>(options.opacityScale);
    checkTransferFunction(tf, options.transferFunction.empty() ? "--range" : options.transferFunction);
    return tf;
}

void noteWhatIsNotSeen(const Scene& scene, const Field& field, Progress& progress)
{
    for (const IsoSurface& surface : scene.surfaces)
        if (!(surface.value >= field.range.lo && surface.value <= field.range.hi))
            progress.note(fmt::format("--iso {}: no surface, the values of {} are from {} to {}", surface.value,
                                      field.name, field.range.lo, field.range.hi));
    if (scene.transferFunction.opacityScale == 0.0f && scene.surfaces.empty() && scene.planes.empty() &&
        !scene.triangles)
        progress.note("nothing can be seen: the volume is off and there is no surface (--iso) or plane (--plane)");
}

} // namespace

PreparedScene prepareScene(const SceneOptions& options, const Executor& executor, Progress& progress,
                           std::vector<TriangleMesh> more)
{
    const Stopwatch loading;
    const auto data = openData(options);
    const std::string fieldName = options.field.empty() ? data->defaultField() : options.field;
    if (fieldName.empty())
        throw Error(options.data, "there is no field to show");
    std::vector<TriangleMesh> meshes = readMeshes(options, progress); // what is wrong there is said before the work
    Model model = data->load(std::vector{fieldName}, executor, progress, nonFiniteOf(options));
    for (const std::string& note : model.notes)
        progress.note(note);
    PreparedScene prepared;
    prepared.loadMilliseconds = loading.milliseconds();

    const Stopwatch preparing;
    Field& field = model.fields.front();
    prepared.scene.transferFunction = chooseTransferFunctionFor(options, model, field, progress);
    auto regions = std::make_shared<RegionTree>(buildRegions(model.bricks, executor, progress));
    auto padded = std::make_shared<PaddedField>(padField(field, model.bricks, *regions, executor, progress));
    prepared.bytes = regions->bytes() + padded->bytes();
    if (options.lod > 0.0) {
        for (const PyramidMember& member : buildPyramid(model, {}, executor, progress)) {
            prepared.scene.pyramid.push_back({member.level, member.regions, member.fields.front()});
            prepared.bytes += member.bytes();
        }
    }
    prepared.prepareMilliseconds = preparing.milliseconds();

    prepared.scene.regions = std::move(regions);
    prepared.scene.field = std::move(padded);
    std::ranges::move(meshes, std::back_inserter(model.meshes));
    std::ranges::move(more, std::back_inserter(model.meshes));
    if (!model.meshes.empty())
        prepared.scene.triangles = std::make_shared<TriangleScene>(model.meshes);
    prepared.scene.worldFromVoxel = model.worldFromVoxel;
    prepared.scene.surfaces = isoSurfaces(options, prepared.scene.transferFunction);
    prepared.scene.planes = contourPlanes(options);
    prepared.scene.clip = clipRegion(options);
    noteWhatIsNotSeen(prepared.scene, field, progress);
    prepared.name = model.name;
    prepared.field = field.name;
    prepared.unit = field.unit;
    prepared.bounds = worldBounds(model);
    prepared.cells = model.cellCount;
    progress.end();
    return prepared;
}

} // namespace brickwall
