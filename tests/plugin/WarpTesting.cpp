// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "WarpTesting.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace brickwall::test {
namespace {

float depthOf(const View& view, const vec3d& point)
{
    const vec4d clip = view.clipFromWorld * vec4d(point, 1.0);
    return float(0.5 * clip.z / clip.w + 0.5);
}

} // namespace

const std::vector<NamedMode> warpingModes = {
    {"Reproject", MultiChannelDrawer::Reproject},
    {"ReprojectAdaptive", MultiChannelDrawer::ReprojectAdaptive},
    {"ReprojectAdaptiveWithNeighbors", MultiChannelDrawer::ReprojectAdaptiveWithNeighbors},
    {"ReprojectMesh", MultiChannelDrawer::ReprojectMesh},
    {"ReprojectMeshWithHoles", MultiChannelDrawer::ReprojectMeshWithHoles},
};

osg::ref_ptr<osg::Geometry> redWall(double lowerY, double upperY)
{
    osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array(osg::Array::BIND_PER_VERTEX);
    corners->push_back(osg::Vec3(-20, lowerY, -20));
    corners->push_back(osg::Vec3(20, lowerY, -20));
    corners->push_back(osg::Vec3(-20, upperY, 20));
    corners->push_back(osg::Vec3(20, upperY, 20));
    osg::ref_ptr<osg::Vec4Array> color = new osg::Vec4Array(osg::Array::BIND_OVERALL);
    color->push_back(osg::Vec4(1, 0, 0, 1));
    osg::ref_ptr<osg::Geometry> wall = new osg::Geometry;
    wall->setVertexArray(corners);
    wall->setColorArray(color);
    wall->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
    wall->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    return wall;
}

float depthAt(double distance)
{
    const double near = 0.1, far = 10.0;
    return float(far / (far - near) * (1.0 - near / distance));
}

Card plainCard(double y, const vec4f& color)
{
    return {.y = y, .color = [color](double, double) { return color; }};
}

Card gradientCard(double y)
{
    const auto ramp = [y](double at) { return float(std::clamp(0.5 + 0.22 * at / y, 0.0, 1.0)); };
    return {.y = y, .color = [ramp](double x, double z) { return vec4f(ramp(x), ramp(z), 0.3f, 1.0f); }};
}

Frame frameOf(const View& view, const std::vector<Card>& cards)
{
    Frame frame = emptyFrame(view);
    for (int y = 0; y < frame.height; ++y) {
        for (int x = 0; x < frame.width; ++x) {
            const vec3d direction = rayDirection(view, view.window.x + x, view.window.y + y);
            vec4f color(0.0f);
            float depth = 1.0f;
            for (const Card& card : cards) {
                const double t = (card.y - view.eye.y) / direction.y;
                const vec3d point = view.eye + t * direction;
                if (!(t > 0.0) || !(point.x > card.lowerX && point.x < card.upperX) || depthOf(view, point) >= depth)
                    continue;
                color = card.color(point.x, point.z);
                depth = depthOf(view, point);
            }
            frame.color[frame.index(x, y)] = color;
            frame.depth[frame.index(x, y)] = depth;
        }
    }
    return frame;
}

WarpedRig::WarpedRig(const Rig& shown, bool flipped)
    : ShownRig(shown), rig(shown), drawer(new MultiChannelDrawer(&windows.channels(), flipped))
{
    windows.drawer().setNodeMask(0);
    drawer->setBackground(rig.background);
    windows.viewer().getSceneData()->asGroup()->addChild(drawer);
}

void WarpedRig::publish(int view, const Frame& frame)
{
    frames.at(view) = frame;
    drawer->resizeView(view, frame.width, frame.height);
    for (int y = 0; y < frame.height; ++y) {
        const int row = drawer->flipped() ? frame.height - 1 - y : y;
        std::copy_n(&frame.color[frame.index(0, y)], frame.width, drawer->rgba(view) + frame.index(0, row));
        std::copy_n(&frame.depth[frame.index(0, y)], frame.width, drawer->depth(view) + frame.index(0, row));
    }
    if (view < windows.channels().numChannels())
        drawer->updateMatrices(view, drawer->modelMatrix(view), drawer->viewMatrix(view),
                               drawer->projectionMatrix(view));
    drawer->swapFrame();
}

void WarpedRig::render(const std::vector<Card>& cards)
{
    for (std::size_t i = 0; i < views.views.size(); ++i)
        publish(int(i), test::frameOf(views.views[i].view, cards));
}

void WarpedRig::move(const vec3d& head, const vec3d& data)
{
    for (Viewer& viewer : rig.viewers)
        viewer.roomFromHead[3] = vec4d(head, 1.0);
    views = viewsOfRig(rig, glm::translate(mat4d(1.0), -data));
    windows.show(views, glm::translate(mat4d(1.0), data));
    drawer->update();
}

void WarpedRig::computeNearAndFar()
{
    for (int i = 0; i < windows.channels().numChannels(); ++i)
        windows.channels().camera(i).setComputeNearFarMode(osg::CullSettings::COMPUTE_NEAR_FAR_USING_BOUNDING_VOLUMES);
}

Difference differenceOf(const osg::Image& picture, const std::function<Rgb(int x, int y)>& expected, int border)
{
    Difference result;
    std::array<double, 3> sum{};
    double sumAbsolute = 0.0;
    int count = 0;
    for (int y = border; y < picture.t() - border; ++y) {
        for (int x = border; x < picture.s() - border; ++x, ++count) {
            const Rgb want = expected(x, y), found = pixel(picture, x, y);
            for (int i = 0; i < 3; ++i) {
                const int d = found[i] - want[i];
                sum[i] += d;
                sumAbsolute += std::abs(d);
                result.largest = std::max(result.largest, std::abs(d));
            }
        }
    }
    for (const double s : sum) {
        if (std::abs(s / count) > std::abs(result.meanSigned))
            result.meanSigned = s / count;
    }
    result.mean = sumAbsolute / (3.0 * count);
    return result;
}

double shareOf(const osg::Image& picture, const std::function<bool(const Rgb&)>& is, int border)
{
    int found = 0, count = 0;
    for (int y = border; y < picture.t() - border; ++y) {
        for (int x = border; x < picture.s() - border; ++x, ++count)
            found += is(pixel(picture, x, y));
    }
    return double(found) / count;
}

} // namespace brickwall::test
