// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Our plugin in stock programs: osgviewer and osgconv of Debian's package openscenegraph.
#include "HostScene.h"
#include "NodeViewer.h"
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <osgDB/WriteFile>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace brickwall::test {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const std::string& path)
{
    std::ifstream in(path);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Runs osgconv to its end; its output.
std::string convert(const std::string& arguments)
{
    OsgHost host("osgconv " + arguments);
    host.wait();
    return host.output();
}

TEST(OsgPlugin, OsgviewerShowsWhatTheRendererMakes)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const HostScene scene("shading=off tolerance=0.01");
    OsgHost host(scene.viewer("-O \"shading=off tolerance=0.01\" " + scene.file));
    scene.expectMono(host, scene.frame(0));
}

TEST(OsgPlugin, ComposesWithPseudoLoaders)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const HostScene scene("");
    const osg::Vec3d c = scene.center;
    // OpenSceneGraph wants parentheses about numbers with a point.
    OsgHost host(
        scene.viewer(fmt::format("'{}.(0.5).scale.({},{},{}).trans'", scene.file, c.x() / 2, c.y() / 2, c.z() / 2)));
    const osg::Matrixd placed = osg::Matrixd::scale(0.5, 0.5, 0.5) * osg::Matrixd::translate(c * 0.5);
    scene.expectMono(host, scene.frame(0, scene.width, scene.height, placed));
}

TEST(OsgPlugin, ComposesWithOtherModels)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const HostScene scene("");
    const std::string model = scratchFile("square.osgt");
    const osg::Vec3 inFront = scene.center + osg::Vec3d(0, 0, 0.8 * scene.size);
    ASSERT_TRUE(osgDB::writeNodeFile(*square(inFront, {1, 0, 0, 1}, 0.1f * scene.size), model));
    OsgHost host(scene.viewer(model + " " + scene.file));
    const Frame frame = scene.frame(0);
    const auto isRed = [&](const osg::Image& picture, int x, int y) { return pixel(picture, x, y) == Rgb{255, 0, 0}; };
    const int x = scene.width / 2, y = scene.height / 2, aside = scene.height / 4;
    const auto picture = waitForPicture(scene.width, scene.height, host, [&](const osg::Image& p) {
        return isRed(p, x, y) && scene.isClose(p, frame, x - aside, y) && scene.isClose(p, frame, x + aside, y);
    });
    EXPECT_TRUE(isRed(*picture, x, y)) << host.output();
    EXPECT_TRUE(scene.isClose(*picture, frame, x - aside, y));
    EXPECT_TRUE(scene.isClose(*picture, frame, x + aside, y));
}

TEST(OsgPlugin, OsgtHasTheNameAndThePropertiesAndNotTheCells)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const HostScene scene("color-field=pressure iso=0.5 volume=off light=1,2,3 plane=0,0,1,0");
    const std::string text = scratchFile("a.osgt"), binary = scratchFile("b.osgb"), again = scratchFile("c.osgt");
    convert("-O \"color-field=pressure iso=0.5 volume=off light=1,2,3 plane=0,0,1,0 fps=12.5\" " + scene.file + " " +
            text);
    ASSERT_TRUE(fs::exists(text));
    EXPECT_LT(fs::file_size(text), 4096u);
    EXPECT_NE(contentOf(text).find("brickwall::VolumeNode"), std::string::npos);
    EXPECT_NE(contentOf(text).find("sample:wake:60k"), std::string::npos);
    EXPECT_NE(contentOf(text).find("color-field=pressure volume=off iso=0.5 light=1,2,3 plane=0,0,1,0"),
              std::string::npos)
        << contentOf(text);
    EXPECT_NE(contentOf(text).find("Fps 12.5"), std::string::npos) << contentOf(text);
    convert(text + " " + binary);
    convert(binary + " " + again);
    EXPECT_EQ(contentOf(again), contentOf(text));

    OsgHost host(scene.viewer(again));
    scene.expectMono(host, scene.frame(0));
}

TEST(OsgPlugin, ReadsFoldersByThePseudoLoader)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const fs::path data = fs::path(BRICKWALL_SOURCE_DIR) / "../shared/data/amrex/blast_small_plt00050";
    if (!fs::exists(data))
        GTEST_SKIP() << data << " is not here";
    const std::string text = scratchFile("plotfile.osgt");
    const std::string output = convert("-O field=density " + data.string() + ".brickwall " + text);
    ASSERT_TRUE(fs::exists(text)) << output;
    EXPECT_NE(contentOf(text).find("field=density"), std::string::npos);
}

TEST(OsgPlugin, SaysInOneLineWhatIsWrongAndTheHostGoesOn)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const std::string broken = scratchFile("broken.exa"), foreign = scratchFile("foreign.vdb"),
                      good = scratchFile("good.osgt");
    std::ofstream(broken) << "bricks nosuch.bricks\n";
    std::ofstream(foreign) << "of another program\n";
    EXPECT_NE(convert(broken + " " + good).find("broken.exa"), std::string::npos);
    EXPECT_FALSE(fs::exists(good));
    convert(foreign + " " + good);
    EXPECT_FALSE(fs::exists(good));
    const std::string absent = convert("sample:nosuch.brickwall " + good);
    EXPECT_NE(absent.find("nosuch"), std::string::npos) << absent;
    EXPECT_FALSE(fs::exists(good));
    const std::string option = convert("-O tolerance=7 sample:wake:60k.brickwall " + good);
    EXPECT_NE(option.find("--tolerance: expected a number above 0"), std::string::npos) << option;
    const std::string rate = convert("-O fps=61 sample:wake:60k.brickwall " + good);
    EXPECT_NE(rate.find("fps: expected 5 to 60 frames per second, or off, found 61"), std::string::npos) << rate;
    EXPECT_FALSE(fs::exists(good));
    // A file that names data which are gone still loads, with a notice.
    std::ofstream(good) << "#Ascii Scene\n#Version 162\n#Generator OpenSceneGraph 3.6.5\n\n"
                           "brickwall::VolumeNode {\n  UniqueID 1\n  Data \"/no/such.exa\"\n  SceneDepth FALSE\n}\n";
    const std::string kept = scratchFile("kept.osgt");
    const std::string notice = convert(good + " " + kept);
    EXPECT_NE(notice.find("/no/such.exa: there is no such file or folder"), std::string::npos) << notice;
    EXPECT_NE(contentOf(kept).find("Data \"/no/such.exa\""), std::string::npos) << contentOf(kept);
    EXPECT_NE(contentOf(kept).find("SceneDepth FALSE"), std::string::npos) << contentOf(kept);
}

} // namespace
} // namespace brickwall::test
