// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/scene/SceneSetup.h"

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/PreparedVolume.h"
#include "brickwall/core/scene/StreamlineTubes.h"
#include "brickwall/core/shade/CellSample.h"
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

constexpr const char* defaultColors = "Cool Warm";

TransferFunction readFile(const SceneOptions& options, const Range& xfRange)
{
    return readTransferFunction(options.transferFunction,
                                colorMap(options.colorMap.empty() ? defaultColors : options.colorMap), xfRange);
}

/// What the user, or the user's file, says that colours are of; empty: the field itself.
std::string colorFieldName(const SceneOptions& options)
{
    if (!options.colorField.empty() || options.transferFunction.empty())
        return options.colorField;
    const auto colorField = readFile(options, {0.0f, 1.0f}).colorField;
    return colorField ? colorField->name : std::string();
}

void prefer(const std::vector<double>& range, Field& field)
{
    if (!range.empty())
        field.preferredRange = {static_cast<float>(range[0]), static_cast<float>(range[1])};
}

/// By what the cells of a field are, of which the model has no values any more.
DefaultChoice chooseFor(const PreparedVolume& volume, const Field& field, const PaddedField& padded,
                        const std::string& colors)
{
    return chooseTransferFunction(volume.model, field,
                                  sampleCells(volume.model, *volume.regions, padded, sampledForDefault), colors);
}

TransferFunction chooseTransferFunctionFor(const SceneOptions& options, const PreparedVolume& volume,
                                           Progress& progress)
{
    Field field = volume.model.fields.front();
    prefer(options.range, field);
    TransferFunction tf;
    if (options.transferFunction.empty()) {
        DefaultChoice choice = chooseFor(volume, field, *volume.fields.front(),
                                         options.colorMap.empty() ? defaultColors : options.colorMap);
        progress.note(choice.explanation);
        tf = std::move(choice.tf);
    } else {
        const Range& range = field.preferredRange.empty() ? field.range : field.preferredRange;
        tf = readFile(options, range);
        if (!options.colorMap.empty())
            tf.colors = colorMap(options.colorMap);
        if (!options.range.empty())
            tf.range = range;
    }
    tf.opacityScale *= static_cast<float>(options.opacityScale);
    checkTransferFunction(tf, options.transferFunction.empty() ? "--range" : options.transferFunction);
    return tf;
}

/// Colours by another field: over the range that the user says, or else that of the file, if it is of this field, or
/// else one that fits the data.
void colorBy(const SceneOptions& options, const PreparedVolume& volume, TransferFunction& tf, Progress& progress)
{
    Field field = volume.model.fields.back();
    prefer(options.colorRange, field);
    if (!tf.colorField || tf.colorField->name != field.name) {
        const DefaultChoice choice = chooseFor(volume, field, *volume.fields.back(), defaultColors);
        tf.colorField = ColorField{field.name, choice.tf.range, choice.tf.scale};
    } else if (!options.colorRange.empty()) {
        tf.colorField->range = field.preferredRange;
    }
    checkTransferFunction(tf, "--color-range");
    progress.note(fmt::format("colours: {} from {:.3g} to {:.3g}{}{}", field.name, tf.colorField->range.lo,
                              tf.colorField->range.hi, field.unit.empty() ? "" : " ", field.unit));
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

/// The field that is shown, and behind it the one that it has its colours from if that is another.
std::vector<std::string> fieldNames(const SceneOptions& options, const DataSet& data, const std::string& colorName)
{
    std::vector<std::string> names{options.field.empty() ? data.defaultField() : options.field};
    if (names.front().empty())
        throw Error(options.data, "there is no field to show");
    if (colorName.empty() && !options.colorRange.empty())
        throw Error("--color-range", "has no effect: neither --color-field nor the transfer function names a field");
    if (!colorName.empty() && colorName != names.front())
        names.push_back(colorName);
    return names;
}

void place(const PreparedVolume& volume, bool isColored, Scene& scene)
{
    scene.regions = volume.regions;
    scene.field = volume.fields.front();
    if (isColored)
        scene.colorField = volume.fields.back();
    for (const PyramidMember& member : volume.pyramid)
        scene.pyramid.push_back(
            {member.level, member.regions, member.fields.front(), isColored ? member.fields.back() : nullptr});
    scene.worldFromVoxel = volume.model.worldFromVoxel;
}

} // namespace

PreparedScene prepareScene(const SceneOptions& options, const Executor& executor, Progress& progress)
{
    const auto data = openData(options);
    const std::string colorName = colorFieldName(options);
    const std::vector<std::string> names = fieldNames(options, *data, colorName);
    std::vector<TriangleMesh> meshes = readMeshes(options, progress); // what is wrong there is said before the work
    std::ranges::move(streamlineTubes(options, *data, executor, progress), std::back_inserter(meshes));
    const PreparedVolume volume =
        prepareVolume(*data, {options.data, options.derive, names, nonFiniteOf(options), options.lod > 0.0},
                      userCache(), executor, progress);
    const Model& model = volume.model;
    for (const std::string& note : model.notes)
        progress.note(note);

    PreparedScene prepared;
    prepared.transferFunction = chooseTransferFunctionFor(options, volume, progress);
    if (!colorName.empty())
        colorBy(options, volume, prepared.transferFunction, progress);
    Scene& scene = prepared.scene;
    place(volume, !colorName.empty(), scene);
    scene.transferFunction = prepared.transferFunction;
    if (options.volume == "off")
        scene.transferFunction.opacityScale = 0.0f;
    std::ranges::copy(model.meshes, std::back_inserter(meshes));
    if (!meshes.empty())
        scene.triangles = std::make_shared<TriangleScene>(meshes);
    scene.surfaces = isoSurfaces(options, scene.transferFunction);
    scene.planes = contourPlanes(options);
    scene.clip = clipRegion(options);
    const Field& field = model.fields.front();
    noteWhatIsNotSeen(scene, field, progress);
    prepared.name = model.name;
    prepared.field = field.name;
    prepared.unit = field.unit;
    prepared.colorField = model.fields.back().name;
    prepared.colorUnit = model.fields.back().unit;
    prepared.bounds = worldBounds(model);
    prepared.cells = model.cellCount;
    prepared.bytes = volume.bytes();
    prepared.loadMilliseconds = volume.loadMilliseconds;
    prepared.prepareMilliseconds = volume.prepareMilliseconds;
    progress.end();
    return prepared;
}

} // namespace brickwall
