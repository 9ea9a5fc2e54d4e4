// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/scene/SceneText.h"
#include "brickwall/tests/common/ErrorOf.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

SceneOptions optionsOf(const std::string& text)
{
    SceneOptions options;
    EXPECT_TRUE(readSceneText(text, options).empty());
    return options;
}

TEST(SceneText, HasTheNamesAndValuesOfTheCommandLine)
{
    const SceneOptions options =
        optionsOf("field=dens tolerance=1/500 tf=my.xf iso=-0.5,0.9 iso_opacity=0.3,1 shading=off range=-1,2");
    EXPECT_EQ(options.field, "dens");
    EXPECT_DOUBLE_EQ(options.tolerance.value(), 1.0 / 500.0);
    EXPECT_EQ(options.transferFunction, "my.xf");
    EXPECT_EQ(options.iso, (std::vector<double>{-0.5, 0.9}));
    EXPECT_EQ(options.isoOpacity, (std::vector<double>{0.3, 1.0}));
    EXPECT_EQ(options.shading, "off");
    EXPECT_EQ(options.range, (std::vector<double>{-1.0, 2.0}));
}

TEST(SceneText, QuotesKeepBlanksTogether)
{
    EXPECT_EQ(optionsOf("  colormap=\"Cool Warm\"   field=a ").colorMap, "Cool Warm");
    EXPECT_EQ(optionsOf("'colormap=Cool Warm'").colorMap, "Cool Warm");
    EXPECT_EQ(optionsOf("derive='b = 2 * a' derive=c=a").derive, (std::vector<std::string>{"b = 2 * a", "c=a"}));
}

TEST(SceneText, GivesBackTheWordsOfOtherReaders)
{
    SceneOptions options;
    EXPECT_EQ(readSceneText("noRotation field=a tolerence=0.1 help=1 h", options),
              (std::vector<std::string>{"noRotation", "tolerence=0.1", "help=1", "h"}));
    EXPECT_EQ(options.field, "a");
}

TEST(SceneText, RefusesWhatTheCommandLineRefusesAndChangesNothing)
{
    SceneOptions options = optionsOf("field=kept");
    const SceneOptions before = options;
    const std::vector<std::string> refused = {"tolerance=2",
                                              "tolerance=abc",
                                              "range=1",
                                              "shading=on",
                                              "field=b dt=0.5",
                                              "iso=1,1",
                                              "opacity-scale=x",
                                              "colormap=nosuch",
                                              "field='b",
                                              "lod=-1",
                                              "lod=1 method=reference",
                                              "light=0,0,0",
                                              "light=1,2",
                                              "light=1,0,0 ambient=2",
                                              "ambient=0.5",
                                              "light=1,0,0 light-tolerance=0",
                                              "light-tolerance=0.5",
                                              "specular=1.5",
                                              "specular=0.5 shading=off",
                                              "shininess=8",
                                              "specular=0.5 shininess=0",
                                              "ambient-occlusion=-1",
                                              "ambient-occlusion=nan",
                                              "ambient-occlusion-rays=8",
                                              "ambient-occlusion=1 ambient-occlusion-rays=0",
                                              "plane-opacity=0.5",
                                              "plane=1,0,0",
                                              "plane=0,0,0,1",
                                              "plane-opacity=0",
                                              "color-range=0,1",
                                              "color-field=a color-range=1,0",
                                              "clip-plane=0,0,0,1",
                                              "streamlines=5y5",
                                              "streamline-radius=1",
                                              "streamlines=5 streamline-length=-1",
                                              "clip-box=0,0,0,1,1",
                                              "clip-box=0,0,0,1,0,1",
                                              "clip-sphere=0,0,0,0",
                                              "mesh-scale=2",
                                              "mesh=a.obj mesh-scale=0",
                                              "mesh=a.obj mesh-offset=1,2"};
    for (const std::string& bad : refused)
        EXPECT_NE(errorOf([&] { readSceneText(bad, options); }), "") << bad;
    EXPECT_EQ(options, before);
}

TEST(SceneText, WritesWhatItReads)
{
    EXPECT_EQ(sceneText(SceneOptions{}), "");
    for (const char* text :
         {"field=dens tf=my.xf range=-1,2.5 shading=off iso=0.5,0.9 iso-color=1,0,0.25 iso-opacity=0.3,1 "
          "tolerance=0.002",
          "field=a color-field=\"b c\" color-range=-1,0.5",
          "derive=\"b = 2 * a\" non-finite=empty colormap=\"Cool Warm\" opacity-scale=0.1 volume=off background=0,0,1 "
          "method=midpoint dt=0.25 lod=1.5 threads=3",
          "mesh=a.obj mesh=\"b c.ply\" mesh-scale=0.5 mesh-offset=1,2,3 mesh-color=1,0,0 light=0.5,1,-2 ambient=0.1 "
          "light-tolerance=0.25 specular=0.5 shininess=8 ambient-occlusion=2 ambient-occlusion-rays=4 "
          "plane=1,0,0,0.5,0,1,0,-2 plane-opacity=0.5 "
          "streamlines=5x5x1:0,0,0,1,1,1 streamlines=7 streamline-vector=velocity streamline-length=2 "
          "streamline-radius=0.1 "
          "clip-plane=0,0,1,3 clip-box=-1,-1,-1,1,2,3 clip-sphere=1,2,3,4"}) {
        const SceneOptions options = optionsOf(text);
        EXPECT_EQ(sceneText(options), text);
        EXPECT_EQ(optionsOf(sceneText(options)), options);
    }
}

} // namespace
} // namespace brickwall::test
