// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestRigs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brickwall::test {
namespace {

std::vector<Frame> framesOf(const RigViews& views)
{
    std::vector<Frame> frames;
    for (int i = 0; i < int(views.views.size()); ++i)
        frames.push_back(patternFrame(views.views[i].view, i));
    return frames;
}

} // namespace

Rig deskRig(int width, int height, StereoMode stereo)
{
    Rig rig;
    rig.name = "desk";
    rig.screens = {{"front", {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, 0, 0}};
    rig.viewers = {Viewer{}};
    rig.windows = {{"main", "", 0, 0, width, height, false, false}};
    Channel channel;
    channel.name = "front";
    channel.viewport = {0, 0, width, height};
    channel.stereo = stereo;
    rig.channels = {channel};
    rig.near = 0.1;
    rig.far = 10.0;
    rig.sceneCenter = {0.0, 1.0, 0.0};
    rig.background = {0.05f, 0.1f, 0.3f};
    return rig;
}

Rig cornerRig(int width, int height)
{
    Rig rig = deskRig(width, height);
    rig.screens.push_back({"left", {-1, -1, -1}, {-1, 1, -1}, {-1, 1, 1}, 0, 0});
    rig.windows.push_back({"side", "", width, 0, width, height, false, false});
    rig.channels.push_back(rig.channels[0]);
    rig.channels[1].name = "left";
    rig.channels[1].screen = 1;
    rig.channels[1].window = 1;
    return rig;
}

std::vector<Frame> patternFrames(std::span<const View> views, Progress&)
{
    std::vector<Frame> frames;
    for (const View& view : views)
        frames.push_back(patternFrame(view, int(frames.size())));
    return frames;
}

Frame patternFrame(const View& view, int seed, float depth)
{
    Frame frame = emptyFrame(view);
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const float u = (x + 0.5f) / frame.width, v = (y + 0.5f) / frame.height;
            const float alpha = std::clamp(1.5f - 1.8f * u, 0.0f, 1.0f);
            const bool mark = u > 0.1f && u < 0.2f && v > 0.1f && v < 0.3f;
            const vec3f color = mark ? vec3f(1.0f) : vec3f(u, v * v, seed % 2 ? 0.9f : 0.1f);
            frame.color[frame.index(x, y)] = vec4f(color * alpha, alpha);
            frame.depth[frame.index(x, y)] = alpha > 0.0f ? depth : 1.0f;
        }
    }
    return frame;
}

ShownRig::ShownRig(const Rig& rig, bool drawThreads)
    : views(viewsOfRig(rig, mat4d(1.0))), frames(framesOf(views)), windows(rig, windowSizes(rig, 1.0), 1.0, drawThreads)
{
    windows.show(views, mat4d(1.0));
    for (std::size_t i = 0; i < views.views.size(); ++i)
        write(views.views[i], frames[i]);
    windows.drawer().swapFrame();
}

const Frame& ShownRig::frameOf(int channel, Eye eye) const
{
    for (std::size_t i = 0; i < views.views.size(); ++i) {
        if (views.views[i].channel == channel && views.views[i].eye == eye)
            return frames[i];
    }
    throw std::out_of_range("no such view");
}

void ShownRig::write(const ChannelView& view, const Frame& frame)
{
    const int index = windows.channels().indexOf(view.channel, view.eye);
    MultiChannelDrawer& drawer = windows.drawer();
    drawer.resizeView(index, frame.width, frame.height);
    std::copy(frame.color.begin(), frame.color.end(), drawer.rgba(index));
    std::copy(frame.depth.begin(), frame.depth.end(), drawer.depth(index));
}

std::vector<WindowCapture::Picture> ShownRig::draw()
{
    windows.requestPictures();
    windows.viewer().frame();
    return windows.takePictures();
}

Rgb composed(const Frame& frame, int x, int y, const vec3f& background)
{
    const vec4f color = frame.color[frame.index(x, y)];
    Rgb result;
    for (int i = 0; i < 3; ++i) {
        const double c = std::clamp(double(color[i]) + (1.0 - color.a) * background[i], 0.0, 1.0);
        const double s = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
        result[i] = int(std::lround(255.0 * s));
    }
    return result;
}

Rgb pixel(const osg::Image& image, int x, int y)
{
    const unsigned char* p = image.data(x, y);
    return {p[0], p[1], p[2]};
}

void expectPicture(const osg::Image& picture, const PixelRect& rect, const std::function<Rgb(int x, int y)>& expected,
                   int tolerance)
{
    ASSERT_LE(rect.x + rect.width, picture.s());
    ASSERT_LE(rect.y + rect.height, picture.t());
    int wrong = 0;
    for (int y = 0; y < rect.height; ++y) {
        for (int x = 0; x < rect.width; ++x) {
            const Rgb want = expected(x, y), found = pixel(picture, rect.x + x, rect.y + y);
            for (int i = 0; i < 3; ++i) {
                if (std::abs(want[i] - found[i]) > tolerance && ++wrong <= 5)
                    ADD_FAILURE() << "pixel " << x << ", " << y << " component " << i << ": " << found[i]
                                  << " instead of " << want[i];
            }
        }
    }
    EXPECT_EQ(wrong, 0) << "components differ";
}

} // namespace brickwall::test
