// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "NodeViewer.h"

#include "brickwall/core/shade/Srgb.h"
#include "brickwall/plugin/OsgConversions.h"

#include <gtest/gtest.h>

#include <osg/DisplaySettings>
#include <osg/Geometry>

#include <chrono>
#include <thread>

namespace brickwall::test {
namespace {

const osg::Vec4 clearColor(0.2f, 0.2f, 0.4f, 1.0f);
const osg::Vec3d eye(0, 0, 10);
constexpr double fov = 40.0;
constexpr double eyeSeparation = 0.0625, screenDistance = 0.5; // exact as floats

osg::Matrixd cameraView()
{
    return osg::Matrixd::lookAt(eye, osg::Vec3d(0, 0, 0), osg::Vec3d(0, 1, 0));
}

osg::Matrixd cameraProjection()
{
    return osg::Matrixd::perspective(fov, double(NodeViewer::width) / NodeViewer::height, 1.0, 1000.0);
}

osg::ref_ptr<osg::GraphicsContext> openTestWindow()
{
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    traits->readDISPLAY();
    traits->setUndefinedScreenDetailsToDefaultScreen();
    traits->width = NodeViewer::width;
    traits->height = NodeViewer::height;
    traits->depth = 24;
    traits->stencil = 8;
    traits->doubleBuffer = true;
    traits->windowDecoration = false;
    return osg::GraphicsContext::createGraphicsContext(traits);
}

} // namespace

NodeViewer::NodeViewer(osg::Node* scene, int stereo, osgViewer::ViewerBase::ThreadingModel threads)
    : capture_(new WindowCapture(false))
{
    osg::ref_ptr<osg::DisplaySettings> settings = new osg::DisplaySettings;
    settings->setNumMultiSamples(0);
    settings->setStereo(stereo >= 0);
    if (stereo >= 0)
        settings->setStereoMode(osg::DisplaySettings::StereoMode(stereo));
    settings->setEyeSeparation(eyeSeparation);
    settings->setScreenDistance(screenDistance);
    viewer.setDisplaySettings(settings);
    viewer.setThreadingModel(threads);
    viewer.setKeyEventSetsDone(0);

    osg::Camera& camera = *viewer.getCamera();
    camera.setGraphicsContext(openTestWindow());
    camera.setViewport(0, 0, width, height);
    camera.setClearColor(clearColor);
    camera.setViewMatrix(cameraView());
    camera.setProjectionMatrix(cameraProjection());
    camera.setFinalDrawCallback(capture_);
    viewer.setSceneData(scene);
    viewer.realize();
}

NodeViewer::~NodeViewer()
{
    viewer.stopThreading();
}

void NodeViewer::settle(const VolumeNode& node)
{
    const auto start = std::chrono::steady_clock::now();
    do {
        ASSERT_LT(std::chrono::steady_clock::now() - start, std::chrono::minutes(3)) << "no picture";
        viewer.frame();
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    } while (!node.settled());
}

osg::ref_ptr<osg::Image> NodeViewer::picture()
{
    capture_->request();
    viewer.frame();
    return capture_->take().left;
}

View NodeViewer::view(const osg::Matrixd& model, int viewWidth, int viewHeight) const
{
    return viewOfMatrices("test", toGlm(model * cameraView()), toGlm(cameraProjection()), viewWidth, viewHeight);
}

View NodeViewer::eyeView(int side, int viewWidth, int viewHeight) const
{
    const osg::Matrixd modelview = cameraView() * osg::Matrixd::translate(-side * 0.5 * eyeSeparation, 0, 0);
    osg::Matrixd shear;
    shear(2, 0) = -side * eyeSeparation / (2.0 * screenDistance);
    return viewOfMatrices("test", toGlm(modelview), toGlm(shear * cameraProjection()), viewWidth, viewHeight);
}

vec3f NodeViewer::background() const
{
    return {linearFromSrgb(clearColor.r()), linearFromSrgb(clearColor.g()), linearFromSrgb(clearColor.b())};
}

osg::ref_ptr<osg::Node> square(const osg::Vec3& center, const osg::Vec4& color, float halfWidth)
{
    osg::ref_ptr<osg::Geometry> geometry = osg::createTexturedQuadGeometry(
        center - osg::Vec3(halfWidth, halfWidth, 0), osg::Vec3(2 * halfWidth, 0, 0), osg::Vec3(0, 2 * halfWidth, 0));
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(osg::Array::BIND_OVERALL);
    colors->push_back(color);
    geometry->setColorArray(colors);
    geometry->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    return geometry;
}

} // namespace brickwall::test
