// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/scene/SceneOptions.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/DerivedFields.h"
#include "brickwall/core/io/MeshFile.h"
#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/Srgb.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace brickwall {
namespace {

std::vector<Plane> planesOf(const std::vector<double>& numbers)
{
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < numbers.size(); i += 4)
        planes.push_back({vec3d(numbers[i], numbers[i + 1], numbers[i + 2]), numbers[i + 3]});
    return planes;
}

vec3f linearColor(const double* srgb)
{
    vec3f color;
    for (int i = 0; i < 3; ++i)
        color[i] = linearFromSrgb(static_cast<float>(srgb[i]));
    return color;
}

} // namespace

std::string commandLinePlace(std::string_view key)
{
    std::string option = "--" + std::string(key);
    std::replace(option.begin(), option.end(), '_', '-');
    return option;
}

double parseNumber(const std::string& text, const std::string& place)
{
    const auto parse = [&](std::string_view part) {
        double value = 0.0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
        if (error != std::errc() || end != part.data() + part.size())
            throw Error(place, fmt::format("expected a number or a fraction such as 1/255, found \"{}\"", text));
        return value;
    };
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos)
        return parse(text);
    return parse(std::string_view(text).substr(0, slash)) / parse(std::string_view(text).substr(slash + 1));
}

bool takesSteps(Method method)
{
    return method != Method::bounded && method != Method::reference;
}

const char* nameOf(Method method)
{
    return methodNames.at(static_cast<std::size_t>(method));
}

Method methodOf(const std::string& name, const std::string& place)
{
    const auto found = std::find(methodNames.begin(), methodNames.end(), name);
    if (found == methodNames.end())
        throw Error(place, fmt::format("expected {}, found {}", fmt::join(methodNames, ", "), name));
    return static_cast<Method>(found - methodNames.begin());
}

std::string describe(const RenderSettings& settings)
{
    if (takesSteps(settings.method))
        return fmt::format("{}, dt {:g}", nameOf(settings.method), settings.step.dt);
    if (settings.method == Method::bounded)
        return fmt::format("{}, tolerance {:.4g}", nameOf(settings.method), settings.bounded.tolerance);
    return nameOf(settings.method);
}

RenderSettings renderSettings(const SceneOptions& options)
{
    RenderSettings settings;
    settings.method = methodOf(options.method, "method");
    if (options.tolerance)
        settings.bounded.tolerance = static_cast<float>(*options.tolerance);
    if (options.dt)
        settings.step.dt = static_cast<float>(*options.dt);
    settings.lod.cellPixels = static_cast<float>(options.lod);
    settings.shading = options.shading == "off" ? Shading::off : Shading::headlight;
    if (!options.light.empty())
        settings.light = Light{vec3d(options.light[0], options.light[1], options.light[2]),
                               static_cast<float>(options.ambient), static_cast<float>(options.lightTolerance)};
    settings.specular = {static_cast<float>(options.specular), static_cast<float>(options.shininess)};
    if (options.ambientOcclusion > 0.0)
        settings.ambientOcclusion = AmbientOcclusion{options.ambientOcclusion, options.ambientOcclusionRays};
    return settings;
}

NonFinite nonFiniteOf(const SceneOptions& options)
{
    return options.nonFinite == "empty" ? NonFinite::empty : NonFinite::error;
}

std::unique_ptr<DataSet> openData(const SceneOptions& options)
{
    return deriveFields(openDataSet(options.data), parseDerivedFields(options.derive, "--derive"), options.data);
}

vec3f backgroundColor(const SceneOptions& options, const vec3f& otherwise)
{
    return options.background.empty() ? otherwise : linearColor(options.background.data());
}

std::vector<TriangleMesh> readMeshes(const SceneOptions& options, Progress& progress)
{
    std::vector<TriangleMesh> meshes;
    const std::vector<double>& o = options.meshOffset;
    const vec3d offset = o.empty() ? vec3d(0.0) : vec3d(o[0], o[1], o[2]);
    for (const std::string& file : options.meshes)
        for (TriangleMesh& mesh : readMesh(file, progress)) {
            for (vec3f& vertex : mesh.vertices)
                vertex = vec3f(options.meshScale * vec3d(vertex) + offset);
            if (!options.meshColor.empty())
                mesh.color = linearColor(options.meshColor.data());
            meshes.push_back(std::move(mesh));
        }
    return meshes;
}

std::vector<ContourPlane> contourPlanes(const SceneOptions& options)
{
    std::vector<ContourPlane> contours;
    for (const Plane& plane : planesOf(options.planes))
        contours.push_back({plane, static_cast<float>(options.planeOpacity)});
    return contours;
}

ClipRegion clipRegion(const SceneOptions& options)
{
    ClipRegion region;
    region.planes = planesOf(options.clipPlanes);
    if (const std::vector<double>& b = options.clipBox; !b.empty())
        region.box = Box3d{vec3d(b[0], b[1], b[2]), vec3d(b[3], b[4], b[5])};
    if (const std::vector<double>& s = options.clipSphere; !s.empty())
        region.sphere = Sphere{vec3d(s[0], s[1], s[2]), s[3]};
    return region;
}

std::vector<IsoSurface> isoSurfaces(const SceneOptions& options, const TransferFunction& transferFunction)
{
    std::vector<IsoSurface> surfaces;
    for (std::size_t i = 0; i < options.iso.size(); ++i) {
        IsoSurface surface;
        surface.value = static_cast<float>(options.iso[i]);
        const std::size_t color = options.isoColors.size() > 3 ? 3 * i : 0;
        if (!options.isoColors.empty())
            surface.color = linearColor(options.isoColors.data() + color);
        else if (!transferFunction.colorField)
            surface.color = vec3f(colorAt(transferFunction, options.iso[i]));
        surface.coloredByField = options.isoColors.empty() && transferFunction.colorField.has_value();
        if (!options.isoOpacity.empty())
            surface.opacity = static_cast<float>(options.isoOpacity[options.isoOpacity.size() > 1 ? i : 0]);
        surfaces.push_back(surface);
    }
    return surfaces;
}

} // namespace brickwall
