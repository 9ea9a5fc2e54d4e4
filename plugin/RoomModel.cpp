// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RoomModel.h"

#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/plugin/FreshArray.h"
#include "brickwall/plugin/OsgConversions.h"

#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/Shape>
#include <osg/ShapeDrawable>
#include <osg/Texture2D>

#include <array>
#include <cstring>
#include <utility>

namespace brickwall {
namespace {

osg::Vec3 toVec3(const vec3d& v)
{
    return {float(v.x), float(v.y), float(v.z)};
}

/// Lower left, lower right, upper right, upper left of the channel's part of its screen.
std::array<vec3d, 4> cornersOf(const Screen& screen, const Channel& channel)
{
    const vec3d right = screen.lowerRight - screen.lowerLeft, up = screen.upperRight - screen.lowerRight;
    double u[2] = {0.0, 1.0}, v[2] = {0.0, 1.0};
    if (channel.part.width > 0 && screen.pixelWidth > 0) {
        u[0] = double(channel.part.x) / screen.pixelWidth;
        u[1] = double(channel.part.x + channel.part.width) / screen.pixelWidth;
        v[0] = double(channel.part.y) / screen.pixelHeight;
        v[1] = double(channel.part.y + channel.part.height) / screen.pixelHeight;
    }
    const auto at = [&](int i, int j) { return screen.lowerLeft + u[i] * right + v[j] * up; };
    return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
}

osg::ref_ptr<osg::Geometry> linesOf(const osg::ref_ptr<osg::Vec3Array>& points, GLenum kind, const osg::Vec4& color)
{
    osg::ref_ptr<osg::Geometry> lines = new osg::Geometry;
    lines->setVertexArray(points);
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(1, &color);
    lines->setColorArray(colors, osg::Array::BIND_OVERALL);
    lines->addPrimitiveSet(new osg::DrawArrays(kind, 0, GLsizei(points->size())));
    lines->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    return lines;
}

/// Both sides show the picture: whoever stands behind a screen sees through it.
osg::ref_ptr<osg::Geometry> wallOf(const osg::ref_ptr<osg::Vec3Array>& corners)
{
    osg::ref_ptr<osg::Vec2Array> place = new osg::Vec2Array;
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
        place->push_back(osg::Vec2(float(x), float(y)));
    osg::ref_ptr<osg::Geometry> wall = linesOf(corners, GL_QUADS, osg::Vec4(1, 1, 1, 1));
    wall->setTexCoordArray(0, place);
    return wall;
}

osg::ref_ptr<osg::Texture2D> textureOf(const osg::ref_ptr<osg::Image>& image)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    return texture;
}

osg::ref_ptr<osg::Image> toOsgImage(const Image& picture)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(picture.width, picture.height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    std::memcpy(image->data(), picture.rgba.data(), picture.rgba.size());
    image->flipVertical();
    return image;
}

const Image blackPicture{1, 1, {0, 0, 0, 255}};

/// A ball of the size of a head with a nose, which points forward.
osg::ref_ptr<osg::Node> headOf(const mat4d& roomFromHead)
{
    constexpr float radius = 0.1f;
    osg::ref_ptr<osg::MatrixTransform> head = new osg::MatrixTransform(toOsg(roomFromHead));
    osg::ref_ptr<osg::ShapeDrawable> ball = new osg::ShapeDrawable(new osg::Sphere(osg::Vec3(), radius));
    osg::ref_ptr<osg::Cone> cone = new osg::Cone(osg::Vec3(0, 1.1f * radius, 0), 0.3f * radius, 0.6f * radius);
    cone->setRotation(osg::Quat(-osg::PI_2, osg::X_AXIS));
    osg::ref_ptr<osg::ShapeDrawable> nose = new osg::ShapeDrawable(cone);
    ball->setColor(osg::Vec4(0.9f, 0.75f, 0.3f, 1));
    nose->setColor(osg::Vec4(0.9f, 0.5f, 0.2f, 1));
    head->addChild(ball);
    head->addChild(nose);
    return head;
}

osg::Vec4 colorOf(Eye eye)
{
    switch (eye) {
    case Eye::left:
        return {0.3f, 0.5f, 1, 1};
    case Eye::right:
        return {1, 0.35f, 0.3f, 1};
    case Eye::middle:
        break;
    }
    return {1, 1, 1, 1};
}

} // namespace

RoomModel::RoomModel(const Rig& rig) : rig_(rig), root_(new osg::Group), pose_(new osg::Group)
{
    root_->addChild(pose_);
    for (const Channel& channel : rig.channels) {
        osg::ref_ptr<osg::Vec3Array> corners = new osg::Vec3Array;
        for (const vec3d& corner : cornersOf(rig.screens[channel.screen], channel))
            corners->push_back(toVec3(corner));
        osg::ref_ptr<osg::Geometry> wall = wallOf(corners);
        root_->addChild(wall);
        root_->addChild(linesOf(corners, GL_LINE_LOOP, osg::Vec4(0.6f, 0.6f, 0.6f, 1)));
        walls_.push_back(wall->getOrCreateStateSet());
    }
    setPictures({}, {});
}

void RoomModel::setPose(const RigViews& views, const mat4d& roomFromWorld, const std::vector<mat4d>& roomFromHeads)
{
    pose_->removeChildren(0, pose_->getNumChildren());
    for (const mat4d& roomFromHead : roomFromHeads)
        pose_->addChild(headOf(roomFromHead));
    for (const ChannelView& view : views.views) {
        const Channel& channel = rig_.channels[view.channel];
        const osg::Vec3 eye = toVec3(transformPoint(roomFromWorld, view.view.eye));
        const osg::ref_ptr<osg::Vec3Array> points = makeFreshArray<osg::Vec3Array>(); // others in a moment
        for (const vec3d& corner : cornersOf(rig_.screens[channel.screen], channel)) {
            points->push_back(eye);
            points->push_back(toVec3(corner));
        }
        pose_->addChild(linesOf(points, GL_LINES, colorOf(view.eye)));
    }
}

void RoomModel::setPictures(const RigViews& views, const std::vector<Frame>& frames)
{
    std::vector<Image> pictures(walls_.size(), blackPicture);
    for (std::size_t i = frames.size(); i-- > 0;) // so that the left eye, which comes first, stays
        pictures[views.views[i].channel] = imageOver(frames[i], rig_.background);
    for (std::size_t i = 0; i < walls_.size(); ++i)
        walls_[i]->setTextureAttributeAndModes(0, textureOf(toOsgImage(pictures[i])));
}

} // namespace brickwall
