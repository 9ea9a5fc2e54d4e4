// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/DepthReaders.h"
#include "brickwall/plugin/PacedVolume.h"
#include "brickwall/plugin/ViewRendering.h"
#include "brickwall/plugin/VolumeRenderer.h"

#include <osg/BoundingBox>
#include <osg/MatrixTransform>
#include <osg/Node>

#include <memory>
#include <optional>
#include <string>

namespace brickwall {

/// A volume in the scene of any OpenSceneGraph program: with bounds, for every camera and eye that comes by, in as many
/// places of the graph as it is put.
///
/// Every cull traversal notes a view (camera, eye, viewport, matrices). A thread renders all views of one moment in one
/// call, and the update traversal swaps whole sets in; neither traversal waits for it. While nothing changes, nothing
/// is rendered. What a camera sees until its first image is ready is the scene without the volume. A camera without
/// perspective shows no volume, which is noted once (osg::notify).
///
/// The images show the model's world space in the node's own coordinates, by way of `transform`. Behind opaque geometry
/// the volume is hidden, in front of it blended with it; MultiChannelDrawer says how. Inside of the volume the scene is
/// seen at its depth: see setSceneDepth.
///
/// Everything here belongs to the update phase of the host. Copies share the data and have a rendering of their own.
class VolumeNode : public osg::Node
{
public:
    VolumeNode();
    VolumeNode(const VolumeNode& other, const osg::CopyOp& copy = osg::CopyOp::SHALLOW_COPY);
    META_Node(brickwall, VolumeNode);

    // What is shown, one of three:
    /// Reads `options.data`, with all that the options say. Throws Error and Cancelled, and has changed nothing
    /// then.
    void load(const SceneOptions& options, Progress& progress);
    /// A scene that the program made; its own surfaces are shown, and of the options what says how it is integrated.
    void show(const Scene& scene);
    /// Images from elsewhere, of something inside these bounds.
    void show(FrameMaker makeFrames, const Box3d& bounds);

    /// Changes what is shown, also field and transfer function. What is not at hand (another field, another file of a
    /// transfer function) is read beside the drawing; the old images stay until then. Throws Error for options out of
    /// their limits.
    void setOptions(const SceneOptions& options);
    const SceneOptions& options() const { return options_; }

    void setField(const std::string& name);
    /// The field whose values say in which colour volume, surfaces and planes are, and over which range of them (empty:
    /// one that fits the data). An empty name: the field itself.
    void setColorField(const std::string& name, const Range& range = {});
    void setIsoValues(const std::vector<double>& values);
    void setTolerance(double tolerance); ///< of the method bounded
    void setShading(Shading shading);
    /// Pictures per second that are held while camera, data or properties change, by rendering those with a larger
    /// tolerance and fewer pixels, 5 to 60 or else the nearest of them (FramePace); what rests is refined until it is
    /// as the options say. Without a value, as at the start, every picture is as the options say, however long that
    /// takes. Nodes of one program, which share its cores, hold theirs each for itself. Images from elsewhere are not
    /// held.
    void setFps(std::optional<double> fps);
    std::optional<double> fps() const { return fps_; }
    /// For people, two lines: the target, what pictures take, and the error that is paid for it. Empty if nothing is
    /// held.
    std::string frameTime() const;

    /// Instead of that of the options, at once, with nothing to read unless its colours are of a field that is not
    /// there yet; without a value: that of the options again. transferFunctionOf, readTransferFunction and toJson
    /// (TransferFunctionFile.h) are its file.
    void setTransferFunction(std::optional<TransferFunction> tf);
    const std::optional<TransferFunction>& transferFunction() const { return transferFunction_; }

    /// Whether rays end at the opaque geometry that the scene draws, exactly; true at the start. Its depth is read in
    /// every draw, so that geometry that moves is followed: a picture that knows of it is asked for two frames later.
    /// Until then, and without this, the images are tested with the one depth that each of their pixels has, and what
    /// stands inside of the volume is either before all of it or behind. Opaque is what is drawn in a render bin before
    /// 8 (OSG's opaque bin is 0, its transparent one 10). Of a window with several samples per pixel one is known; a
    /// framebuffer object with several, and one without depth, is as without this.
    void setSceneDepth(bool read);
    bool sceneDepth() const { return sceneDepth_; }

    /// In the model's world space; needs no reading.
    void setPlanes(const std::vector<Plane>& planes, double opacity = 1.0);
    void setClip(const ClipRegion& region);
    void setLight(const std::optional<Light>& light);
    void setSpecular(const Specular& specular);
    void setAmbientOcclusion(const std::optional<AmbientOcclusion>& occlusion);

    /// Opaque geometry that the renderer is to know, whatever draws it: rays end at it in every picture, at once, also
    /// in cameras whose depth is not read, and it casts shadows if there is a light. `scene` is in the node's own
    /// coordinates, as its sibling is; its triangles are copied in this call, so call again when it has moved. It need
    /// not be in the graph, and is not drawn by this. Null for none, as at the start. Not kept in files, nor by copies.
    /// Triangles with vertices that are no numbers are left out; throws Error for infinite ones.
    void setOccluders(osg::Node* scene);

    /// From the model's world space to the node's coordinates; identity at the start.
    void setTransform(const osg::Matrixd& nodeFromModel);
    const osg::Matrixd& transform() const { return place_->getMatrix(); }

    /// In the node's coordinates; not valid while nothing is shown.
    osg::BoundingBox boundingBox() const;
    osg::BoundingSphere computeBound() const override;

    /// Count the changes of what needs reading, and of all that can be seen but the transform.
    unsigned dataStamp() const { return dataStamp_; }
    unsigned lookStamp() const { return lookStamp_; }

    /// Whether the images that are shown are those of the newest views and properties, as of the last update traversal.
    bool settled() const { return settled_; }

    void traverse(osg::NodeVisitor& visitor) override;
    void resizeGLObjectBuffers(unsigned size) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

private:
    ~VolumeNode() override;
    void showData(std::shared_ptr<const VolumeData> data);
    void cull(osgUtil::CullVisitor& visitor);
    void update(unsigned frame);
    void assemble();
    void publish();
    void followViews();
    std::vector<RequestedView> viewsNow();
    bool waitsForDepth();
    VolumeLook look() const;
    FrameMaker makerOfLook();
    void refine();
    void placeOccluders();

    SceneOptions options_;
    std::optional<TransferFunction> transferFunction_;
    std::shared_ptr<const VolumeData> data_;
    std::vector<TriangleMesh> occluderMeshes_;       ///< in the node's coordinates
    std::shared_ptr<const TriangleScene> occluders_; ///< in the model's world space
    std::shared_ptr<VolumeRenderer> renderer_;       ///< called by the rendering thread alone
    Box3d modelBounds_;                              ///< of the model's world space; empty: nothing is shown
    FrameMaker makeFrames_;                          ///< of a program
    std::optional<double> fps_;
    std::shared_ptr<PacedVolume> pace_; ///< of this renderer and the levers of the latest look; null: nothing is held
    unsigned dataStamp_ = 0;
    unsigned lookStamp_ = 0;

    osg::ref_ptr<TraversalViews> views_;
    osg::ref_ptr<DepthReaders> depths_;
    osg::ref_ptr<MultiChannelDrawer> drawer_;
    osg::ref_ptr<osg::MatrixTransform> place_; ///< of both; no node that other visitors see
    bool sceneDepth_ = true;
    int waited_ = 0; ///< frames for a first reading
    std::optional<unsigned> updatedFrame_;
    std::vector<RequestedView> requested_; ///< latest
    std::optional<unsigned> requestedLook_;
    unsigned request_ = 0; ///< number of the latest
    std::optional<unsigned> published_;
    bool settled_ = false;
    bool notedFlat_ = false;
    std::unique_ptr<ViewRendering> rendering_; ///< last: it ends before what it writes to does
};

} // namespace brickwall
