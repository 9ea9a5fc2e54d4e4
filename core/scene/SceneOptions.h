// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/render/Renderer.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// What the user says about the scene and how it is integrated, the same words in every command and in view files.
struct SceneOptions
{
    std::string data;
    std::vector<std::string> derive; ///< fields that the user defines, "NAME = EXPRESSION"
    std::string field;               ///< empty: the data set's default
    std::string nonFinite = "error"; ///< values that are not: error, or empty cells
    std::string transferFunction;    ///< .xf or JSON file; empty: chosen from the data
    std::string colorMap;            ///< empty: that of the transfer function, or cool-warm
    std::vector<double> range;       ///< empty, or lo and hi
    std::string colorField;          ///< what colours are of; empty: that of the transfer function, or the field itself
    std::vector<double> colorRange;  ///< of that field; empty, or lo and hi
    double opacityScale = 1.0;
    std::string shading = "headlight";
    std::string volume = "on";
    std::vector<double> iso;
    std::vector<double> isoColors;   ///< r, g, b in sRGB: none, one for all, or one per value
    std::vector<double> isoOpacity;  ///< none, one for all, or one per value
    std::vector<std::string> meshes; ///< files of opaque triangles (MeshFile.h), beside those of the data
    double meshScale = 1.0;          ///< of their coordinates, before the offset
    std::vector<double> meshOffset;  ///< none, or x, y, z in world space
    std::vector<double> meshColor;   ///< none (that of the file), or r, g, b in sRGB
    std::vector<double> light;       ///< none, or x, y, z: the direction that it comes from, in world space
    double ambient = 0.2;            ///< of the light, what comes from everywhere
    double lightTolerance = 1.0 / 64.0;
    double specular = 0.0;
    double shininess = 32.0;
    double ambientOcclusion = 0.0; ///< world space; 0: none
    int ambientOcclusionRays = 16;
    std::vector<double> planes; ///< contour planes, x, y, z, offset for each
    double planeOpacity = 1.0;
    std::vector<std::string> streamlines; ///< seeds: COUNT or NXxNYxNZ, and behind a colon a box: "5x5x5:0,0,0,1,1,1"
    std::string streamlineVector;         ///< its name; empty: the first that the data have
    double streamlineLength = 0.0;        ///< in world space, to either side of a seed; 0: chosen from the data
    double streamlineRadius = 0.0;        ///< of the tubes; 0: chosen from the data
    std::vector<double> clipPlanes;       ///< x, y, z, offset for each; kept is where x px + y py + z pz >= offset
    std::vector<double> clipBox;          ///< none, or the lower corner and the upper one
    std::vector<double> clipSphere;       ///< none, or x, y, z of its centre, and the radius
    std::vector<double> background;       ///< empty (black, or the rig's), or r, g, b in sRGB
    std::string method = "bounded";
    std::optional<double> tolerance; ///< of bounded
    std::optional<double> dt;        ///< of the methods that take steps
    double lod = 0.0;                ///< LodConfig::cellPixels
    int threads = 0;

    bool operator==(const SceneOptions&) const = default;
};

/// How messages name an option, from its key in view files ("iso_color").
using PlaceOfOption = std::function<std::string(std::string_view key)>;
std::string commandLinePlace(std::string_view key);

/// The one list of limits, for the command line and for view files. Throws Error.
void checkSceneOptions(const SceneOptions& options, const PlaceOfOption& placeOf);

/// A number, or a fraction of two ("1/255"). Throws Error naming `place`.
double parseNumber(const std::string& text, const std::string& place);

/// Whether a method has a step, or else none (bounded has a tolerance, reference has neither).
bool takesSteps(Method method);
/// Its name in `methodNames`, and back; throws Error naming `place`.
const char* nameOf(Method method);
Method methodOf(const std::string& name, const std::string& place);
/// A method with its parameter, for people: "midpoint, dt 0.5".
std::string describe(const RenderSettings& settings);

// Of options that are within the limits:
RenderSettings renderSettings(const SceneOptions& options);
NonFinite nonFiniteOf(const SceneOptions& options);
/// The data set with the fields that the user defines. Throws Error as openDataSet and deriveFields do.
std::unique_ptr<DataSet> openData(const SceneOptions& options);
/// The background as linear RGB; `otherwise` if the user did not say.
vec3f backgroundColor(const SceneOptions& options, const vec3f& otherwise = vec3f(0.0f));
/// Reads the meshes that the options name, and moves and paints them as they say.
std::vector<TriangleMesh> readMeshes(const SceneOptions& options, Progress& progress);
/// Contour planes and what is cut away, of options that are within their limits.
std::vector<ContourPlane> contourPlanes(const SceneOptions& options);
ClipRegion clipRegion(const SceneOptions& options);
/// Colours that the user did not give are those of the transfer function: at the surface's value, or of its colour
/// field.
std::vector<IsoSurface> isoSurfaces(const SceneOptions& options, const TransferFunction& transferFunction);

} // namespace brickwall
