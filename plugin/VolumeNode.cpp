// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/VolumeNode.h"

#include "brickwall/core/base/BoxCorners.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/OsgConversions.h"
#include "brickwall/plugin/RigViewer.h"

#include <utility>

namespace brickwall {
VolumeNode::VolumeNode()
    : views_(new TraversalViews),
      depths_(new DepthReaders(views_)),
      drawer_(new MultiChannelDrawer(views_)),
      place_(new osg::MatrixTransform)
{
    assemble();
}

void VolumeNode::assemble()
{
    place_->setCullingActive(false);
    place_->addChild(depths_);
    place_->addChild(drawer_);
    setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
}

VolumeNode::VolumeNode(const VolumeNode& other, const osg::CopyOp& copy)
    : osg::Node(other, copy),
      options_(other.options_),
      transferFunction_(other.transferFunction_),
      data_(other.data_),
      modelBounds_(other.modelBounds_),
      makeFrames_(other.makeFrames_),
      fps_(other.fps_),
      dataStamp_(other.dataStamp_),
      lookStamp_(other.lookStamp_),
      views_(new TraversalViews),
      depths_(new DepthReaders(views_)),
      drawer_(new MultiChannelDrawer(views_)),
      place_(new osg::MatrixTransform(other.transform())),
      sceneDepth_(other.sceneDepth_)
{
    assemble();
    depths_->enable(sceneDepth_);
    if (data_)
        showData(data_); // by a renderer of its own
}

VolumeNode::~VolumeNode() = default;

void VolumeNode::load(const SceneOptions& options, Progress& progress)
{
    std::shared_ptr<const VolumeData> data = readVolume(withColorField(options, transferFunction_), progress);
    options_ = options;
    ++dataStamp_;
    showData(std::move(data));
}

void VolumeNode::show(const Scene& scene)
{
    auto data = std::make_shared<VolumeData>();
    data->prepared.scene = scene;
    data->prepared.bounds = worldBounds(scene);
    options_.data.clear();
    ++dataStamp_;
    showData(std::move(data));
}

void VolumeNode::showData(std::shared_ptr<const VolumeData> data)
{
    data_ = std::move(data);
    makeFrames_ = nullptr;
    modelBounds_ = data_->prepared.bounds;
    renderer_ = std::make_shared<VolumeRenderer>(data_);
    pace_.reset();
    ++lookStamp_;
    dirtyBound();
}

void VolumeNode::show(FrameMaker makeFrames, const Box3d& bounds)
{
    data_.reset();
    renderer_.reset();
    pace_.reset();
    options_.data.clear();
    makeFrames_ = std::move(makeFrames);
    modelBounds_ = bounds;
    ++dataStamp_;
    ++lookStamp_;
    dirtyBound();
}

void VolumeNode::setSceneDepth(bool read)
{
    if (read == sceneDepth_)
        return;
    sceneDepth_ = read;
    depths_->enable(read);
    ++lookStamp_;
}

osg::BoundingBox VolumeNode::boundingBox() const
{
    osg::BoundingBox box;
    if (modelBounds_.empty())
        return box;
    const Box3d bounds = boundsOfTransformed(toGlm(transform()), modelBounds_);
    box.expandBy(osg::Vec3(bounds.lower.x, bounds.lower.y, bounds.lower.z));
    box.expandBy(osg::Vec3(bounds.upper.x, bounds.upper.y, bounds.upper.z));
    return box;
}

osg::BoundingSphere VolumeNode::computeBound() const
{
    const osg::BoundingBox box = boundingBox();
    return box.valid() ? osg::BoundingSphere(box) : osg::BoundingSphere();
}

} // namespace brickwall
