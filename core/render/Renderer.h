// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Regions.h"
#include "brickwall/core/render/ClipRegion.h"
#include "brickwall/core/render/ContourPlane.h"
#include "brickwall/core/render/Frame.h"
#include "brickwall/core/shade/IsoSurface.h"
#include "brickwall/core/shade/Light.h"
#include "brickwall/core/shade/SurfaceLook.h"
#include "brickwall/core/shade/TransferFunction.h"
#include "brickwall/core/trace/TraceTile.h"
#include "brickwall/core/trace/TriangleScene.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

enum class Shading {
    off,
    headlight, ///< colour times |cos| of gradient and ray, two-sided, no ambient term (ExaBrick's)
};

/// How the volume is integrated. Isosurfaces are found exactly, whatever the method.
enum class Method {
    bounded,       ///< keeps a stated error in the image with as little work as it finds (docs/speed-accuracy.md)
    fixed,         ///< Riemann sum: uniform steps of dt finest cells of the data, sampled at their near end
    midpoint,      ///< ExaBrick: steps of dt x finest cell width of the region, sampled at the middle of every segment
    bracket,       ///< midpoint, with a binary search where two samples straddle what the transfer function shows
    preintegrated, ///< steps like midpoint, sampled at both ends, exact for a field that is linear in between
    reference,     ///< plain, in double, to 1e-10: what the others are measured against; slow
};

inline constexpr std::array methodNames = {"bounded", "fixed", "midpoint", "bracket", "preintegrated", "reference"};

struct BoundedConfig
{
    /// The largest error wanted in any linear premultiplied component of any pixel against `reference`; in (0, 1].
    float tolerance = 1.0f / 255.0f;
};

/// Of the methods that take steps: fixed, midpoint, bracket, preintegrated.
struct StepConfig
{
    float dt = 0.5f;                   ///< step, in finest cell widths of the region (fixed: of the data); > 0
    bool interleave = true;            ///< a different offset of the sample planes for every pixel
    float terminationOpacity = 0.998f; ///< a ray ends when it is this opaque
};

/// How coarse the data may be that are far away (Scene::pyramid).
struct LodConfig
{
    /// At each distance rays use data whose cells are about so many pixels wide there (between 0.6 and 1.7 times), with
    /// a gradual change over half an octave of distance, so that nothing pops; 0: the data themselves everywhere.
    /// Isosurfaces, and the method reference, always use the data themselves.
    float cellPixels = 0.0f;
};

struct RenderSettings
{
    Method method = Method::bounded;
    BoundedConfig bounded;
    StepConfig step;
    LodConfig lod;
    Shading shading = Shading::headlight;
    /// Of all methods; without it nothing has a shadow. The methods' own errors are those of the picture without it.
    std::optional<Light> light;
    Specular specular;                                ///< needs a light or the headlight
    std::optional<AmbientOcclusion> ambientOcclusion; ///< none: nothing is
};

/// The data of a scene with all cells finer than `level` averaged into cells of that level (core/model/Pyramid.h).
struct SceneMember
{
    int level = 0;
    std::shared_ptr<const RegionTree> regions;
    std::shared_ptr<const PaddedField> field;
    std::shared_ptr<const PaddedField> colorField = nullptr; ///< if the scene has one
};

/// What is rendered. Immutable parts are shared, so that a scene with another transfer function costs nothing.
struct Scene
{
    std::shared_ptr<const RegionTree> regions;
    std::shared_ptr<const PaddedField> field;
    std::shared_ptr<const TriangleScene> triangles; ///< opaque; may be null
    TransferFunction transferFunction;
    mat4d worldFromVoxel{1.0};
    std::vector<IsoSurface> surfaces;      ///< in any order
    std::vector<SceneMember> pyramid = {}; ///< ascending by level; used as far as LodConfig says
    std::vector<ContourPlane> planes = {}; ///< in any order
    ClipRegion clip = {};
    /// Opaque triangles that are drawn elsewhere, and not here: rays end there like at a view's SceneDepth, and shadows
    /// are cast. May be null.
    std::shared_ptr<const TriangleScene> occluders = nullptr;
    /// What the colours of volume, planes and surfaces are of, if the transfer function says that they are of another
    /// field; of the same regions. Not needed otherwise.
    std::shared_ptr<const PaddedField> colorField = nullptr;
};

struct ViewStatistics
{
    std::string name;
    double milliseconds = 0.0; ///< the view's part of the call: the time spent on its tiles / threads
    std::uint64_t rays = 0;
    TraceCounts counts;
    std::uint64_t surfaceHits = 0; ///< of isosurfaces and contour planes
    /// Of the bounded method: the largest error that it admits to have made in a pixel, and the pixels where that is
    /// more than the tolerance, with the reason; 0 and empty otherwise.
    /// With LodConfig the error is that of integrating the data that were used, against the converged image of those:
    /// how far averaged data are from the data themselves is not in it.
    float largestBound = 0.0f;
    std::uint64_t pixelsBeyond = 0;
    std::string beyondBecause;
    /// Samples by the level of the pyramid's member that they were taken from, [0] those of the data themselves; ends
    /// with the coarsest member that was used.
    std::vector<std::uint64_t> memberSamples;
};

/// Renders views of one scene. Construction does what all views share (the table of the transfer function, the regions
/// that it makes visible); `render` may be called from one thread at a time and works on all threads of the executor.
class Renderer
{
public:
    Renderer(Scene scene, const Executor& executor);
    ~Renderer();

    const Scene& scene() const;

    /// Frames of all views, all tiles of all views in one pool, so that no core waits for another view. The same view
    /// gives the same bits whatever it is rendered with, by how many threads, and whatever its window. Throws
    /// Cancelled.
    std::vector<Frame> render(std::span<const View> views, const RenderSettings& settings, Progress& progress,
                              std::vector<ViewStatistics>* statistics = nullptr) const;

    /// Only the visible part changes: the regions and the fields stay. Throws Error if it is none, or needs a colour
    /// field that the scene does not have; then nothing has changed.
    void setTransferFunction(const TransferFunction& transferFunction);
    /// Throws Error if a value, a colour or an opacity is out of its bounds; then nothing has changed.
    void setSurfaces(std::vector<IsoSurface> surfaces);
    void setPlanes(std::vector<ContourPlane> planes);
    void setClip(ClipRegion clip);
    /// Null for none.
    void setOccluders(std::shared_ptr<const TriangleScene> occluders);

    /// Rays that one instruction handles, and the name of the instruction set, as chosen on this machine.
    static int lanes();
    static std::string target();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace brickwall
