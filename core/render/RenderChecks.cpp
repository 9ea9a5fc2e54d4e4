// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/RenderChecks.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/trace/BrickLimits.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <utility>

namespace brickwall {
namespace {

void checkData(const RegionTree* regions, const PaddedField* field)
{
    if (!regions || !field)
        throw Error("scene", "expected regions and a field, found none");
    if (field->values.size() != regions->paddedCellCount || field->regionRanges.size() != regions->regions.size())
        throw Error("scene", "the field belongs to other regions: pad it for these");
    checkBrickSizes(*regions);
}

void checkColors(const RegionTree& regions, const PaddedField* colorField)
{
    if (colorField)
        checkData(&regions, colorField);
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

void checkSpecular(const Specular& specular)
{
    if (!(specular.strength >= 0.0f && specular.strength <= 1.0f))
        throw Error("specular", fmt::format("expected a strength from 0 to 1, found {:g}", specular.strength));
    if (!(specular.shininess >= 1.0f && specular.shininess <= 1000.0f))
        throw Error("specular", fmt::format("expected a shininess from 1 to 1000, found {:g}", specular.shininess));
}

void checkAmbientOcclusion(const AmbientOcclusion& occlusion)
{
    if (!(occlusion.distance > 0.0))
        throw Error("ambient occlusion",
                    fmt::format("expected a distance of more than 0, found {:g}", occlusion.distance));
    if (occlusion.rays < 1 || occlusion.rays > 1024)
        throw Error("ambient occlusion", fmt::format("expected 1 to 1024 rays, found {}", occlusion.rays));
}

} // namespace

void checkScene(const Scene& scene)
{
    checkData(scene.regions.get(), scene.field.get());
    checkColors(*scene.regions, scene.colorField.get());
    int last = 0;
    for (const SceneMember& member : scene.pyramid) {
        checkData(member.regions.get(), member.field.get());
        checkColors(*member.regions, member.colorField.get());
        if (member.level <= std::exchange(last, member.level) || member.level > maxLevel)
            throw Error("scene", "expected members of a pyramid with levels above 0 in ascending order");
    }
}

void checkColorField(const Scene& scene, const TransferFunction& tf)
{
    bool isThere = scene.colorField != nullptr;
    for (const SceneMember& member : scene.pyramid)
        isThere = isThere && member.colorField;
    if (tf.colorField && !isThere)
        throw Error("transfer function", fmt::format("its colours are those of the field '{}', which the scene does "
                                                     "not have: say so when the data are read (color-field)",
                                                     tf.colorField->name));
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

void checkSettings(const RenderSettings& settings, const Box3i& halfBounds)
{
    checkSteps(settings.step, halfBounds);
    checkTolerance(settings.bounded);
    checkLod(settings.lod);
    if (settings.light)
        checkLight(*settings.light);
    checkSpecular(settings.specular);
    if (settings.ambientOcclusion)
        checkAmbientOcclusion(*settings.ambientOcclusion);
}

} // namespace brickwall
