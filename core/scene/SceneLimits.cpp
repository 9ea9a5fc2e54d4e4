// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The limits of scene options.
#include "brickwall/core/scene/SceneOptions.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/DerivedFields.h"
#include "brickwall/core/scene/StreamlineTubes.h"
#include "brickwall/core/shade/ColorMaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace brickwall {
namespace {

/// Checks of single options; a message is "PLACE: expected ..., found ...".
class Limits
{
public:
    explicit Limits(const PlaceOfOption& placeOf) : placeOf_(placeOf) {}

    template <class Found>
    void require(bool fine, std::string_view key, std::string_view expected, const Found& found) const
    {
        if (!fine)
            throw Error(placeOf_(key), fmt::format("expected {}, found {}", expected, found));
    }
    void oneOf(std::string_view key, const std::string& found, const std::vector<std::string>& names) const
    {
        require(std::find(names.begin(), names.end(), found) != names.end(), key,
                fmt::format("{}", fmt::join(names, ", ")), found);
    }
    /// An option that has no effect without another one.
    void needs(bool isThere, std::string_view key, std::string_view other) const
    {
        require(isThere, key, fmt::format("{} with it", placeOf_(other)), "none");
    }
    /// As many numbers as there are surfaces, or one for all, `each` numbers long.
    void perSurface(std::string_view key, std::size_t found, std::size_t surfaces, std::size_t each) const
    {
        if (found == 0)
            return;
        needs(surfaces > 0, key, "iso");
        require(found == each || found == each * surfaces, key,
                fmt::format("{} number{}, or {} for each of {} values", each, each == 1 ? "" : "s", each, surfaces),
                found);
    }

private:
    const PlaceOfOption& placeOf_;
};

bool isFinite(double value)
{
    return std::isfinite(static_cast<float>(value));
}

bool isFraction(double value) // a NaN is none
{
    return value >= 0.0 && value <= 1.0;
}

bool isPositiveFraction(double value)
{
    return isFraction(value) && static_cast<float>(value) > 0.0f;
}

bool areFractions(const std::vector<double>& values)
{
    return std::all_of(values.begin(), values.end(), isFraction);
}

std::string listOf(const std::vector<double>& values)
{
    return fmt::format("{}", fmt::join(values, ","));
}

void checkRange(const std::vector<double>& range, std::string_view key, const Limits& limits)
{
    limits.require(range.empty() || (range.size() == 2 && static_cast<float>(range[0]) < static_cast<float>(range[1]) &&
                                     isFinite(range[0]) && isFinite(range[1])),
                   key, "LO < HI, both finite and apart as 32-bit floats", listOf(range));
}

void checkSurfaces(const SceneOptions& options, const Limits& limits)
{
    limits.require(std::all_of(options.iso.begin(), options.iso.end(), isFinite), "iso", "finite values",
                   listOf(options.iso));
    const std::set<float> values(options.iso.begin(), options.iso.end());
    limits.require(values.size() == options.iso.size(), "iso", "values that differ as 32-bit floats",
                   listOf(options.iso));
    limits.perSurface("iso_color", options.isoColors.size(), options.iso.size(), 3);
    limits.require(areFractions(options.isoColors), "iso_color", "numbers from 0 to 1", listOf(options.isoColors));
    limits.perSurface("iso_opacity", options.isoOpacity.size(), options.iso.size(), 1);
    limits.require(std::all_of(options.isoOpacity.begin(), options.isoOpacity.end(), isPositiveFraction), "iso_opacity",
                   "numbers above 0 and at most 1", listOf(options.isoOpacity));
}

void checkMeshes(const SceneOptions& options, const Limits& limits)
{
    const std::vector<double>& offset = options.meshOffset;
    const bool isThere = !options.meshes.empty();
    limits.needs(isThere || options.meshScale == SceneOptions().meshScale, "mesh_scale", "mesh");
    limits.needs(isThere || offset.empty(), "mesh_offset", "mesh");
    limits.needs(isThere || options.meshColor.empty(), "mesh_color", "mesh");
    limits.require(options.meshScale > 0.0 && isFinite(options.meshScale), "mesh_scale", "a finite number above 0",
                   options.meshScale);
    limits.require(offset.empty() || (offset.size() == 3 && std::all_of(offset.begin(), offset.end(), isFinite)),
                   "mesh_offset", "X,Y,Z, all finite", listOf(offset));
    limits.require(options.meshColor.empty() || (options.meshColor.size() == 3 && areFractions(options.meshColor)),
                   "mesh_color", "R,G,B, each from 0 to 1", listOf(options.meshColor));
}

void checkLight(const SceneOptions& options, const Limits& limits)
{
    const std::vector<double>& l = options.light;
    limits.require(l.empty() || (l.size() == 3 && std::all_of(l.begin(), l.end(), isFinite) &&
                                 (l[0] != 0.0 || l[1] != 0.0 || l[2] != 0.0)),
                   "light", "X,Y,Z, finite and not all 0", listOf(l));
    const SceneOptions start;
    limits.needs(!l.empty() || options.ambient == start.ambient, "ambient", "light");
    limits.needs(!l.empty() || options.lightTolerance == start.lightTolerance, "light_tolerance", "light");
    limits.require(isFraction(options.ambient), "ambient", "a number from 0 to 1", options.ambient);
    limits.require(isPositiveFraction(options.lightTolerance), "light_tolerance", "a number above 0 and at most 1",
                   options.lightTolerance);
}

void checkSurfaceLook(const SceneOptions& options, const Limits& limits)
{
    const SceneOptions start;
    limits.require(isFraction(options.specular), "specular", "a number from 0 to 1", options.specular);
    limits.require(options.specular == 0.0 || options.shading != "off" || !options.light.empty(), "specular",
                   "--light or --shading headlight with it", "none");
    limits.needs(options.specular > 0.0 || options.shininess == start.shininess, "shininess", "specular");
    limits.require(options.shininess >= 1.0 && options.shininess <= 1000.0, "shininess", "a number from 1 to 1000",
                   options.shininess);
    limits.require(options.ambientOcclusion >= 0.0, "ambient_occlusion", "a distance of 0 or more",
                   options.ambientOcclusion);
    limits.needs(options.ambientOcclusion > 0.0 || options.ambientOcclusionRays == start.ambientOcclusionRays,
                 "ambient_occlusion_rays", "ambient_occlusion");
    limits.require(options.ambientOcclusionRays >= 1 && options.ambientOcclusionRays <= 1024, "ambient_occlusion_rays",
                   "1 to 1024", options.ambientOcclusionRays);
}

void checkPlanes(const std::vector<double>& planes, std::string_view key, const Limits& limits)
{
    bool fine = planes.size() % 4 == 0 && std::all_of(planes.begin(), planes.end(), isFinite);
    for (std::size_t i = 0; fine && i < planes.size(); i += 4)
        fine = planes[i] != 0.0 || planes[i + 1] != 0.0 || planes[i + 2] != 0.0;
    limits.require(fine, key, "X,Y,Z,OFFSET, finite, with a normal X,Y,Z that is not 0", listOf(planes));
}

void checkPlaces(const SceneOptions& options, const Limits& limits)
{
    checkPlanes(options.planes, "plane", limits);
    limits.needs(!options.planes.empty() || options.planeOpacity == SceneOptions().planeOpacity, "plane_opacity",
                 "plane");
    limits.require(isPositiveFraction(options.planeOpacity), "plane_opacity", "a number above 0 and at most 1",
                   options.planeOpacity);
    checkPlanes(options.clipPlanes, "clip_plane", limits);
    const std::vector<double>&b = options.clipBox, &s = options.clipSphere;
    limits.require(b.empty() || (b.size() == 6 && std::all_of(b.begin(), b.end(), isFinite) && b[0] < b[3] &&
                                 b[1] < b[4] && b[2] < b[5]),
                   "clip_box", "X0,Y0,Z0,X1,Y1,Z1, finite, the first corner below the second", listOf(b));
    limits.require(s.empty() || (s.size() == 4 && std::all_of(s.begin(), s.end(), isFinite) && s[3] > 0.0),
                   "clip_sphere", "X,Y,Z,RADIUS, finite, with a radius above 0", listOf(s));
}

void checkMethod(const SceneOptions& options, const PlaceOfOption& placeOf, const Limits& limits)
{
    const Method method = methodOf(options.method, placeOf("method"));
    if (options.tolerance) {
        limits.require(isPositiveFraction(*options.tolerance), "tolerance", "a number above 0 and at most 1",
                       *options.tolerance);
        if (method != Method::bounded)
            throw Error(placeOf("tolerance"),
                        fmt::format("has no effect on the method {}; it belongs to bounded", options.method));
    }
    limits.require(options.lod >= 0.0 && isFinite(options.lod), "lod", "a finite number of pixels, 0 or more",
                   options.lod);
    if (options.lod > 0.0 && method == Method::reference)
        throw Error(placeOf("lod"), "has no effect on the method reference, which looks at the data themselves");
    if (options.dt) {
        limits.require(static_cast<float>(*options.dt) > 0.0f && isFinite(*options.dt), "dt", "a finite number above 0",
                       *options.dt);
        if (!takesSteps(method))
            throw Error(placeOf("dt"), fmt::format("has no effect on the method {}; it is the step of fixed, midpoint, "
                                                   "bracket and preintegrated (say which with {})",
                                                   options.method, placeOf("method")));
    }
}

} // namespace

void checkSceneOptions(const SceneOptions& options, const PlaceOfOption& placeOf)
{
    const Limits limits(placeOf);
    parseDerivedFields(options.derive, placeOf("derive"));
    checkRange(options.range, "range", limits);
    checkRange(options.colorRange, "color_range", limits);
    limits.needs(options.colorRange.empty() || !options.colorField.empty() || !options.transferFunction.empty(),
                 "color_range", "color_field");
    limits.require(options.opacityScale >= 0.0 && isFinite(options.opacityScale), "opacity_scale",
                   "a finite number of 0 or more", options.opacityScale);
    limits.oneOf("non_finite", options.nonFinite, {"error", "empty"});
    limits.oneOf("shading", options.shading, {"headlight", "off"});
    limits.oneOf("volume", options.volume, {"on", "off"});
    checkSurfaces(options, limits);
    checkMeshes(options, limits);
    checkLight(options, limits);
    checkSurfaceLook(options, limits);
    checkPlaces(options, limits);
    checkStreamlines(options, placeOf);
    limits.require(options.background.empty() || (options.background.size() == 3 && areFractions(options.background)),
                   "background", "R,G,B, each from 0 to 1", listOf(options.background));
    checkMethod(options, placeOf, limits);
    try {
        if (!options.colorMap.empty())
            colorMap(options.colorMap);
    } catch (const Error& error) {
        throw Error(placeOf("colormap"), error.what());
    }
}

} // namespace brickwall
