// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "HostScene.h"

#include "brickwall/core/scene/SceneText.h"
#include "brickwall/core/shade/Srgb.h"
#include "brickwall/plugin/OsgConversions.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace brickwall::test {
namespace {

constexpr int tolerance = 2; ///< of the blending of 8 bits
/// osgviewer's own, as displayed.
const vec3f clearColor{linearFromSrgb(0.2f), linearFromSrgb(0.2f), linearFromSrgb(0.4f)};

bool areClose(const Rgb& a, const Rgb& b)
{
    return std::abs(a[0] - b[0]) <= tolerance && std::abs(a[1] - b[1]) <= tolerance &&
           std::abs(a[2] - b[2]) <= tolerance;
}

} // namespace

HostScene::HostScene(const std::string& text)
{
    SceneOptions options;
    readSceneText(text, options);
    options.data = "sample:wake:60k";
    const Executor executor;
    Progress silent;
    prepared = prepareScene(options, executor, silent);
    settings = renderSettings(options);
    const Box3d& box = prepared.bounds;
    const vec3d middle = 0.5 * (box.lower + box.upper), extent = box.extent();
    size = std::max({extent.x, extent.y, extent.z});
    center = osg::Vec3d(middle.x, middle.y, middle.z);
    eye = center + osg::Vec3d(0, 0, 2.0 * size);
}

std::string HostScene::viewer(const std::string& arguments) const
{
    return fmt::format("osgviewer --window 0 0 {} {} {} {}", width, height, cameraPathAt(eye), arguments);
}

Frame HostScene::frame(int side, int viewWidth, int viewHeight, const osg::Matrixd& model) const
{
    const View view = viewOfMatrices("host", toGlm(model * hostModelview(eye, side)),
                                     toGlm(hostProjection(width, height, side)), viewWidth, viewHeight);
    const Executor executor;
    Progress silent;
    return std::move(Renderer(prepared.scene, executor).render({&view, 1}, settings, silent).front());
}

Rgb HostScene::expected(const Frame& frame, int x, int y) const
{
    return composed(frame, x, y, clearColor);
}

bool HostScene::isClose(const osg::Image& picture, const Frame& frame, int x, int y) const
{
    return areClose(pixel(picture, x, y), expected(frame, x, y));
}

void HostScene::expectWindow(OsgHost& host, const std::function<Rgb(int x, int y)>& wanted,
                             const std::string& display) const
{
    const auto isDone = [&](const osg::Image& picture) {
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                if (!areClose(pixel(picture, x, y), wanted(x, y)))
                    return false;
        return true;
    };
    const osg::ref_ptr<osg::Image> picture = waitForPicture(width, height, host, isDone, display);
    expectPicture(*picture, {0, 0, width, height}, wanted, tolerance);
    if (testing::Test::HasFailure())
        ADD_FAILURE() << host.output();
}

void HostScene::expectMono(OsgHost& host, const Frame& frame) const
{
    const bool seen = std::any_of(frame.color.begin(), frame.color.end(), [](const vec4f& c) { return c.a > 0.1f; });
    EXPECT_TRUE(seen) << "nothing to be seen";
    expectWindow(host, [&](int x, int y) { return expected(frame, x, y); });
}

const std::string& whyNoOsgviewer()
{
    static const std::string why = std::system("command -v osgviewer osgconv >/dev/null 2>&1") == 0
                                       ? ""
                                       : "osgviewer is not installed (Debian: apt-get install openscenegraph)";
    return why;
}

} // namespace brickwall::test
