// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/DepthReaders.h"

#include "brickwall/plugin/SameMatrices.h"

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

constexpr int readingBin = 7; // the last one before the drawer's

} // namespace

DepthReaders::DepthReaders(osg::ref_ptr<const TraversalViews> views) : views_(std::move(views))
{
    setCullingActive(false);
    getOrCreateStateSet()->setRenderBinDetails(readingBin, "RenderBin");
}

void DepthReaders::enable(bool enabled)
{
    removeChildren(0, getNumChildren());
    readers_.clear();
    enabled_ = enabled;
    for (int i = 0; enabled && i < views_->numChannels(); ++i) {
        readers_.push_back(new DepthReader(views_, i));
        addChild(readers_.back());
    }
}

void DepthReaders::follow(const std::vector<int>& changed)
{
    for (const int channel : enabled_ ? changed : std::vector<int>()) {
        osg::ref_ptr<DepthReader> reader = new DepthReader(views_, channel);
        if (channel < int(readers_.size())) {
            replaceChild(readers_[channel], reader);
            readers_[channel] = reader;
        } else {
            readers_.push_back(reader);
            addChild(reader);
        }
    }
}

std::optional<DepthReading> DepthReaders::latest(int channel) const
{
    return channel < int(readers_.size()) ? readers_[channel]->latest() : std::nullopt;
}

std::vector<int> DepthReaders::seeing() const
{
    std::vector<int> channels;
    for (const int channel : views_->living()) {
        if (channel < int(readers_.size()) && !readers_[channel]->isBlind())
            channels.push_back(channel);
    }
    return channels;
}

bool DepthReaders::areIncomplete() const
{
    const std::vector<int> channels = seeing();
    return std::any_of(channels.begin(), channels.end(), [&](int channel) { return !readers_[channel]->latest(); });
}

bool DepthReaders::areBehind() const
{
    const std::vector<int> channels = seeing();
    return std::any_of(channels.begin(), channels.end(), [&](int channel) {
        const std::optional<DepthReading> reading = readers_[channel]->latest();
        const OutputChannel noted = views_->channel(channel);
        return !reading || reading->viewport != noted.viewport || !same(reading->modelview, noted.view) ||
               !sameButForDepth(reading->projection, noted.projection);
    });
}

} // namespace brickwall
