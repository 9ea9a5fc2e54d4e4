// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The properties of VolumeNode.
#include "brickwall/channels/FrameRate.h"
#include "brickwall/plugin/NodeTriangles.h"
#include "brickwall/plugin/OsgConversions.h"
#include "brickwall/plugin/VolumeNode.h"

#include <glm/matrix.hpp>

#include <utility>

namespace brickwall {
namespace {

std::vector<double> numbersOf(const std::vector<Plane>& planes)
{
    std::vector<double> numbers;
    for (const Plane& plane : planes)
        numbers.insert(numbers.end(), {plane.normal.x, plane.normal.y, plane.normal.z, plane.offset});
    return numbers;
}

} // namespace

void VolumeNode::setOptions(const SceneOptions& options)
{
    checkSceneOptions(options, commandLinePlace);
    if (options == options_)
        return;
    if (needsReading(options_, options))
        ++dataStamp_;
    ++lookStamp_;
    options_ = options;
}

void VolumeNode::setField(const std::string& name)
{
    SceneOptions options = options_;
    options.field = name;
    setOptions(options);
}

void VolumeNode::setColorField(const std::string& name, const Range& range)
{
    SceneOptions options = options_;
    options.colorField = name;
    options.colorRange.clear();
    if (!name.empty() && !range.empty())
        options.colorRange = {range.lo, range.hi};
    setOptions(options);
}

void VolumeNode::setIsoValues(const std::vector<double>& values)
{
    SceneOptions options = options_;
    options.iso = values;
    setOptions(options);
}

void VolumeNode::setTolerance(double tolerance)
{
    SceneOptions options = options_;
    options.tolerance = tolerance;
    setOptions(options);
}

void VolumeNode::setShading(Shading shading)
{
    SceneOptions options = options_;
    options.shading = shading == Shading::off ? "off" : "headlight";
    setOptions(options);
}

void VolumeNode::setFps(std::optional<double> fps)
{
    fps_ = fps ? std::optional(withinFps(*fps)) : std::nullopt;
    if (!pace_)
        return;
    if (fps_)
        return pace_->setFps(*fps_);
    if (published_ != request_ || !pace_->refined())
        requestedLook_.reset(); // what is shown, or will be, is less than the options say
    pace_.reset();
}

std::string VolumeNode::frameTime() const
{
    return pace_ ? pace_->status() : std::string();
}

void VolumeNode::setTransferFunction(std::optional<TransferFunction> tf)
{
    if (tf)
        checkTransferFunction(*tf, "transfer function");
    if (needsReading(withColorField(options_, transferFunction_), withColorField(options_, tf)))
        ++dataStamp_;
    transferFunction_ = std::move(tf);
    ++lookStamp_;
}

void VolumeNode::setPlanes(const std::vector<Plane>& planes, double opacity)
{
    SceneOptions options = options_;
    options.planes = numbersOf(planes);
    options.planeOpacity = planes.empty() ? SceneOptions().planeOpacity : opacity;
    setOptions(options);
}

void VolumeNode::setClip(const ClipRegion& region)
{
    SceneOptions options = options_;
    options.clipPlanes = numbersOf(region.planes);
    options.clipBox.clear();
    if (const auto& box = region.box)
        options.clipBox = {box->lower.x, box->lower.y, box->lower.z, box->upper.x, box->upper.y, box->upper.z};
    options.clipSphere.clear();
    if (const auto& sphere = region.sphere)
        options.clipSphere = {sphere->center.x, sphere->center.y, sphere->center.z, sphere->radius};
    setOptions(options);
}

void VolumeNode::setLight(const std::optional<Light>& light)
{
    SceneOptions options = options_;
    const SceneOptions start;
    options.light = start.light;
    options.ambient = start.ambient;
    options.lightTolerance = start.lightTolerance;
    if (light) {
        options.light = {light->towards.x, light->towards.y, light->towards.z};
        options.ambient = light->ambient;
        options.lightTolerance = light->tolerance;
    }
    setOptions(options);
}

void VolumeNode::setSpecular(const Specular& specular)
{
    SceneOptions options = options_;
    options.specular = specular.strength;
    options.shininess = specular.strength > 0.0f ? specular.shininess : SceneOptions().shininess;
    setOptions(options);
}

void VolumeNode::setAmbientOcclusion(const std::optional<AmbientOcclusion>& occlusion)
{
    SceneOptions options = options_;
    options.ambientOcclusion = occlusion ? occlusion->distance : SceneOptions().ambientOcclusion;
    options.ambientOcclusionRays = occlusion ? occlusion->rays : SceneOptions().ambientOcclusionRays;
    setOptions(options);
}

void VolumeNode::setOccluders(osg::Node* scene)
{
    std::vector<TriangleMesh> meshes = scene ? trianglesOf(*scene) : std::vector<TriangleMesh>();
    std::swap(occluderMeshes_, meshes);
    try {
        placeOccluders();
    } catch (...) {
        std::swap(occluderMeshes_, meshes);
        throw;
    }
}

void VolumeNode::placeOccluders()
{
    const mat4d modelFromNode = glm::inverse(toGlm(transform()));
    std::vector<TriangleMesh> meshes;
    for (const TriangleMesh& mesh : occluderMeshes_)
        meshes.push_back(transformed(mesh, modelFromNode));
    occluders_ = std::make_shared<TriangleScene>(meshes);
    ++lookStamp_;
}

void VolumeNode::setTransform(const osg::Matrixd& nodeFromModel)
{
    place_->setMatrix(nodeFromModel);
    if (!occluderMeshes_.empty())
        placeOccluders();
    dirtyBound();
}

} // namespace brickwall
