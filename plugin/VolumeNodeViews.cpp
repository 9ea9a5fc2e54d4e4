// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What VolumeNode does in the traversals of its host.
#include "brickwall/channels/LeveredViews.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/shade/Srgb.h"
#include "brickwall/plugin/OsgConversions.h"
#include "brickwall/plugin/SameMatrices.h"
#include "brickwall/plugin/VolumeNode.h"

#include <osg/Notify>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

/// Frames that a first picture waits for the scene's depth. It takes three, if the host draws what it culls.
constexpr int patience = 10;

bool sameViews(const std::vector<RequestedView>& a, const std::vector<RequestedView>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const RequestedView& x, const RequestedView& y) {
        return x.drawerView == y.drawerView && x.view.window == y.view.window &&
               x.view.sceneDepth == y.view.sceneDepth && same(x.projection, y.projection) &&
               same(x.model * x.viewing, y.model * y.viewing);
    });
}

vec3f linear(const osg::Vec4& displayed)
{
    vec3f color;
    for (int i = 0; i < 3; ++i)
        color[i] = linearFromSrgb(std::clamp(float(displayed[i]), 0.0f, 1.0f));
    return color;
}

} // namespace

void VolumeNode::traverse(osg::NodeVisitor& visitor)
{
    if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR)
        update(visitor.getTraversalNumber());
    else if (osgUtil::CullVisitor* culling = visitor.asCullVisitor())
        cull(*culling);
}

void VolumeNode::cull(osgUtil::CullVisitor& visitor)
{
    const osg::BoundingBox box = boundingBox();
    if (!box.valid())
        return;
    // The images have no bounds of their own, and near and far have to leave room for what they show.
    if (visitor.getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR)
        visitor.updateCalculatedNearFar(*visitor.getModelViewMatrix(), box);
    views_->note(visitor, transform());
    place_->accept(visitor);
}

void VolumeNode::update(unsigned frame)
{
    if (updatedFrame_ == frame || modelBounds_.empty()) // several parents; nothing to show
        return;
    updatedFrame_ = frame;
    if (!rendering_)
        rendering_ = std::make_unique<ViewRendering>(*drawer_);
    publish();
    followViews();
    drawer_->update();

    std::vector<RequestedView> views = viewsNow();
    const bool newLook = requestedLook_ != lookStamp_;
    const bool newViews = !sameViews(views, requested_);
    if (newLook || newViews) {
        if (!views.empty() && !waitsForDepth()) {
            request_ = rendering_->request(views, makerOfLook(), newLook);
            requestedLook_ = lookStamp_;
            requested_ = std::move(views);
        }
    } else {
        refine();
    }
    settled_ = !requested_.empty() && !newLook && !newViews && !depths_->areBehind() && rendering_->idle();
}

/// Once what was asked for last is shown, and for as long as it rests.
void VolumeNode::refine()
{
    if (pace_ && !requested_.empty() && published_ == request_ && !pace_->refined())
        request_ = rendering_->refine(requested_, pace_->resting(look()));
}

/// A first picture without the scene's depth would delay the right one by the time that it takes.
bool VolumeNode::waitsForDepth()
{
    waited_ = depths_->areIncomplete() ? waited_ + 1 : 0;
    return waited_ > 0 && waited_ <= patience;
}

void VolumeNode::publish()
{
    try {
        if (const std::optional<unsigned> number = rendering_->publish())
            published_ = number;
    } catch (const std::exception& error) {
        OSG_WARN << "brickwall: " << error.what() << std::endl;
    }
}

void VolumeNode::followViews()
{
    const std::vector<int> changed = views_->settle();
    if (changed.empty())
        return;
    rendering_->restructure([&] {
        if (drawer_->numViews() != views_->numChannels())
            drawer_->setNumViews(-1);
        for (const int view : changed)
            drawer_->resizeView(view, 0, 0);
        drawer_->swapFrame();
    });
    depths_->follow(changed);
    requested_.clear();
}

/// With what each was drawn with when the scene's depth was read, which is one draw ago: an image that fits its depth,
/// and is warped to the newest place of the eye, is better than one without it.
std::vector<RequestedView> VolumeNode::viewsNow()
{
    std::vector<RequestedView> views;
    for (const int index : views_->living()) {
        const OutputChannel channel = views_->channel(index);
        const DepthReading reading = depths_->latest(index).value_or(
            DepthReading{channel.viewport, channel.model * channel.view, channel.projection, nullptr});
        try {
            View view = viewOfMatrices(channel.name, toGlm(reading.modelview), toGlm(reading.projection),
                                       reading.viewport.width, reading.viewport.height);
            view.sceneDepth = reading.depth;
            views.push_back({index, std::move(view), osg::Matrixd(), reading.modelview, reading.projection});
            if (views.size() == 1)
                drawer_->setBackground(linear(views_->clearColor(index)));
        } catch (const Error& error) {
            if (!std::exchange(notedFlat_, true))
                OSG_WARN << "brickwall: no volume in a view: " << error.what() << std::endl;
        }
    }
    return views;
}

VolumeLook VolumeNode::look() const
{
    return {options_, transferFunction_, occluders_, lookStamp_};
}

FrameMaker VolumeNode::makerOfLook()
{
    if (makeFrames_)
        return makeFrames_;
    if (!fps_)
        return [renderer = renderer_, look = look()](std::span<const View> views, Progress& progress) {
            return renderer->render(look, views, progress);
        };
    const LeverTable levers = leversOf(renderSettings(options_));
    if (!pace_ || pace_->levers() != levers)
        pace_ = PacedVolume::make(renderer_, levers, *fps_);
    return pace_->moving(look());
}

void VolumeNode::resizeGLObjectBuffers(unsigned size)
{
    osg::Node::resizeGLObjectBuffers(size);
    place_->resizeGLObjectBuffers(size);
}

void VolumeNode::releaseGLObjects(osg::State* state) const
{
    osg::Node::releaseGLObjects(state);
    place_->releaseGLObjects(state);
}

} // namespace brickwall
