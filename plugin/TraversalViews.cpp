// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/TraversalViews.h"

#include <fmt/format.h>

#include <osgUtil/CullVisitor>
#include <osgUtil/RenderStage>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

/// A camera may leave out a frame, and a node may be out of sight for a moment.
constexpr unsigned framesToForget = 10;

Eye eyeOf(osgUtil::RenderStage& stage)
{
    if (!stage.getCamera() || !stage.getInitialViewMatrix())
        return Eye::middle;
    const double shift = (*stage.getInitialViewMatrix())(3, 0) - stage.getCamera()->getViewMatrix()(3, 0);
    if (shift == 0.0)
        return Eye::middle;
    return shift > 0.0 ? Eye::left : Eye::right;
}

/// All that moves the node is in `view`, as it is in the modelview matrix that the drawer below the node is drawn with.
void takeMatrices(osgUtil::CullVisitor& visitor, const osg::Matrixd& nodeFromModel, OutputChannel& output)
{
    output.viewport = rectOf(*visitor.getViewport());
    output.model = osg::Matrixd();
    output.view = nodeFromModel * *visitor.getModelViewMatrix();
    output.projection = *visitor.getProjectionMatrix();
}

} // namespace

PixelRect rectOf(const osg::Viewport& viewport)
{
    return {int(std::lround(viewport.x())), int(std::lround(viewport.y())), int(std::lround(viewport.width())),
            int(std::lround(viewport.height()))};
}

TraversalViews::Key TraversalViews::keyOf(osgUtil::CullVisitor& visitor)
{
    return {visitor.getNodePath(), visitor.getIdentifier(), visitor.getCurrentCamera(),
            eyeOf(*visitor.getRenderStage())};
}

int TraversalViews::numChannels() const
{
    const std::lock_guard lock(mutex_);
    return int(entries_.size());
}

OutputChannel TraversalViews::channel(int index) const
{
    const std::lock_guard lock(mutex_);
    return entries_[index].output;
}

osg::Vec4 TraversalViews::clearColor(int index) const
{
    const std::lock_guard lock(mutex_);
    return entries_[index].clearColor;
}

bool TraversalViews::isDrawnBy(int index, osgUtil::CullVisitor& visitor) const
{
    const Key found = keyOf(visitor);
    const std::lock_guard lock(mutex_);
    const Entry& entry = entries_[index];
    const osg::NodePath& path = entry.key.path;
    return entry.alive && entry.key.camera == found.camera && entry.key.traversal == found.traversal &&
           entry.key.eye == found.eye && path.size() < found.path.size() &&
           std::equal(path.begin(), path.end(), found.path.begin());
}

void TraversalViews::note(osgUtil::CullVisitor& visitor, const osg::Matrixd& nodeFromModel)
{
    if (!visitor.getViewport() || !visitor.getCurrentCamera())
        return;
    Entry seen;
    seen.key = keyOf(visitor);
    seen.alive = true;
    seen.clearColor = visitor.getCurrentCamera()->getClearColor();
    seen.output.eye = seen.key.eye;
    seen.output.name = fmt::format("{} {}", visitor.getCurrentCamera()->getName(), toString(seen.key.eye));
    takeMatrices(visitor, nodeFromModel, seen.output);

    const std::lock_guard lock(mutex_);
    seen.lastSeen = updates_;
    const auto same = [&](const Entry& entry) { return entry.alive && entry.key == seen.key; };
    for (std::vector<Entry>* list : {&entries_, &noted_}) {
        if (const auto found = std::find_if(list->begin(), list->end(), same); found != list->end()) {
            *found = seen;
            return;
        }
    }
    noted_.push_back(std::move(seen));
}

std::vector<int> TraversalViews::settle()
{
    const std::lock_guard lock(mutex_);
    ++updates_;
    std::vector<int> changed;
    const auto place = [&](int index, Entry entry) {
        entries_[index] = std::move(entry);
        changed.push_back(index);
    };
    for (int i = 0; i < int(entries_.size()); ++i) {
        if (entries_[i].alive && updates_ - entries_[i].lastSeen > framesToForget)
            place(i, {});
    }
    for (Entry& entry : noted_) {
        const auto vacant = std::find_if(entries_.begin(), entries_.end(), [](const Entry& old) { return !old.alive; });
        const int index = int(vacant - entries_.begin());
        entries_.resize(std::max(entries_.size(), std::size_t(index) + 1));
        place(index, std::move(entry));
    }
    noted_.clear();
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
}

std::vector<int> TraversalViews::living() const
{
    const std::lock_guard lock(mutex_);
    std::vector<int> indices;
    for (int i = 0; i < int(entries_.size()); ++i) {
        if (entries_[i].alive)
            indices.push_back(i);
    }
    return indices;
}

} // namespace brickwall
