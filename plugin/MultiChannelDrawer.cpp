// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/MultiChannelDrawer.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/ChannelPass.h"
#include "brickwall/plugin/DrawerShaders.h"
#include "brickwall/plugin/DrawerView.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

constexpr const char* place = "MultiChannelDrawer";
constexpr double marginOfMesh = 1.0 / 8.0;

osg::ref_ptr<osg::Group> makePassGroup(DrawerPass pass, MultiChannelDrawer::Mode mode)
{
    osg::ref_ptr<osg::Group> group = new osg::Group;
    group->setCullingActive(false);
    group->setStateSet(makePassState(pass, mode));
    return group;
}

} // namespace

MultiChannelDrawer::MultiChannelDrawer(osg::ref_ptr<const ChannelSource> channels, bool flipped)
    : channels_(std::move(channels)),
      flipped_(flipped),
      background_(new osg::Uniform(drawerState::backgroundName, osg::Vec3f()))
{
    setName(place);
    setCullingActive(false);
    background_->setDataVariance(osg::Object::DYNAMIC);
    setStateSet(makeDrawerState(background_));
    setNumViews(-1);
}

MultiChannelDrawer::~MultiChannelDrawer() = default;

DrawerView& MultiChannelDrawer::at(int view) const
{
    if (view < 0 || view >= numViews())
        throw Error(place, fmt::format("there is no view {}; it has {}", view, numViews()));
    return *views_[view];
}

int MultiChannelDrawer::numViews() const
{
    return int(views_.size());
}

void MultiChannelDrawer::setNumViews(int count)
{
    if (count < -1)
        throw Error(place, fmt::format("expected a number of views, or -1 for one per channel, not {}", count));
    takeChannels(); // there may be others by now
    const int channels = int(current_.size());
    views_.resize(count < 0 ? channels : count);
    for (int i = 0; i < numViews(); ++i) {
        if (views_[i])
            continue;
        views_[i] = new DrawerView;
        views_[i]->eye = i < channels ? current_[i].eye : Eye::middle;
    }
    arrange();
}

Eye MultiChannelDrawer::viewEye(int view) const
{
    return at(view).eye;
}

void MultiChannelDrawer::setViewEye(int view, Eye eye)
{
    if (at(view).eye == eye)
        return;
    at(view).eye = eye;
    arrange();
}

void MultiChannelDrawer::setMode(Mode mode)
{
    if (mode == mode_)
        return;
    mode_ = mode;
    arrange();
}

void MultiChannelDrawer::setViewsToRender(ViewSelection selection)
{
    if (selection == selection_)
        return;
    selection_ = selection;
    arrange();
}

bool MultiChannelDrawer::shows(int view, int channel) const
{
    if (selection_ == MatchingEye)
        return views_[view]->eye == current_[channel].eye;
    return selection_ == All || view == channel;
}

void MultiChannelDrawer::arrange()
{
    removeChildren(0, getNumChildren());
    passes_.clear();
    const int channels = int(current_.size());
    const auto pass = [&](int view, int channel, DrawerPass kind) {
        // Beyond the edge of another channel's image there is something else to see than its continuation.
        const double margin = view == channel && mode_ == ReprojectMesh ? marginOfMesh : 0.0;
        passes_.push_back(new ChannelPass(views_[view], channels_, channel, kind,
                                          {.flipped = flipped_, .margin = margin, .alone = selection_ == Same}));
        passes_.back()->setModel(current_[channel].model);
        return passes_.back().get();
    };
    for (const DrawerPass kind :
         {DrawerPass::asIs, DrawerPass::asIsWithoutDepth, DrawerPass::depth, DrawerPass::color}) {
        if (mode_ == AsIs && isWarped(kind))
            continue;
        const osg::ref_ptr<osg::Group> group = makePassGroup(kind, mode_);
        for (int view = 0; view < numViews(); ++view) {
            for (int channel = 0; channel < channels; ++channel) {
                if (isWarped(kind) ? shows(view, channel) : view == channel)
                    group->addChild(pass(view, channel, kind));
            }
        }
        addChild(group);
    }
    shareGrids();
}

void MultiChannelDrawer::shareGrids()
{
    if (mode_ == AsIs) {
        for (const auto& view : views_)
            view->grid = nullptr;
        return;
    }
    const bool mesh = isMesh(mode_);
    std::vector<osg::ref_ptr<PixelGrid>> grids;
    for (const auto& view : views_)
        grids.push_back(view->grid);
    for (const auto& view : views_) {
        const int width = view->front().width, height = view->front().height;
        if (!view->canReproject() || (view->grid && view->grid->serves(width, height, mesh)))
            continue;
        const auto found = std::find_if(grids.begin(), grids.end(), [&](const osg::ref_ptr<PixelGrid>& grid) {
            return grid && grid->serves(width, height, mesh);
        });
        if (found != grids.end()) {
            view->grid = *found;
        } else {
            view->grid = new PixelGrid(width, height, mesh);
            grids.push_back(view->grid);
        }
    }
    for (const auto& pass : passes_)
        pass->refresh();
}

void MultiChannelDrawer::takeChannels()
{
    current_.resize(channels_->numChannels());
    for (int i = 0; i < int(current_.size()); ++i)
        current_[i] = channels_->channel(i);
}

void MultiChannelDrawer::update()
{
    const std::size_t before = current_.size();
    takeChannels();
    if (current_.size() != before)
        return arrange();
    for (const auto& pass : passes_)
        pass->setModel(current_[pass->channel()].model);
}

const osg::Matrixd& MultiChannelDrawer::modelMatrix(int i) const
{
    return current_.at(i).model;
}

const osg::Matrixd& MultiChannelDrawer::viewMatrix(int i) const
{
    return current_.at(i).view;
}

const osg::Matrixd& MultiChannelDrawer::projectionMatrix(int i) const
{
    return current_.at(i).projection;
}

void MultiChannelDrawer::setBackground(const vec3f& linear)
{
    background_->set(osg::Vec3f(linear.r, linear.g, linear.b));
}

void MultiChannelDrawer::updateMatrices(int view, const osg::Matrixd& model, const osg::Matrixd& viewing,
                                        const osg::Matrixd& projection)
{
    at(view).next = {true, model * viewing * projection, projection};
}

osg::Matrixd MultiChannelDrawer::imageMatrix(int view) const
{
    return at(view).shown().modelviewProjection;
}

void MultiChannelDrawer::resizeView(int view, int width, int height, GLenum depthFormat, GLenum colorFormat)
{
    if (width < 0 || height < 0 || (width == 0) != (height == 0))
        throw Error(place, fmt::format("view {} cannot be {} x {} pixels", view, width, height));
    if ((depthFormat != GL_FLOAT && depthFormat != 0) || colorFormat != GL_FLOAT)
        throw Error(place, fmt::format("view {} cannot have depth format {:#x} with colour format {:#x}; expected "
                                       "GL_FLOAT, or 0 for no depth, and GL_FLOAT",
                                       view, depthFormat, colorFormat));
    DrawerView& data = at(view);
    const bool hasDepth = depthFormat != 0;
    const DrawerView::Images& back = data.back;
    data.written = data.written || width != back.width || height != back.height || hasDepth != back.hasDepth;
    data.back.resize(width, height, hasDepth);
}

int MultiChannelDrawer::width(int view) const
{
    return at(view).back.width;
}

int MultiChannelDrawer::height(int view) const
{
    return at(view).back.height;
}

vec4f* MultiChannelDrawer::rgba(int view)
{
    DrawerView& data = at(view);
    data.written = true;
    return data.back.color ? reinterpret_cast<vec4f*>(data.back.color->data()) : nullptr;
}

float* MultiChannelDrawer::depth(int view)
{
    DrawerView& data = at(view);
    data.written = true;
    return data.back.depth ? reinterpret_cast<float*>(data.back.depth->data()) : nullptr;
}

void MultiChannelDrawer::clearColor(int view)
{
    std::fill_n(rgba(view), std::size_t(width(view)) * height(view), vec4f(0.0f));
}

void MultiChannelDrawer::clearDepth(int view)
{
    if (float* pixels = depth(view))
        std::fill_n(pixels, std::size_t(width(view)) * height(view), 1.0f);
}

void MultiChannelDrawer::swapFrame()
{
    for (const auto& view : views_) {
        if (view->written)
            view->swap();
    }
    shareGrids();
}

} // namespace brickwall
