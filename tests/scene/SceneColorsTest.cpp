// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/scene/SceneSetup.h"
#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/TransferFunctionFile.h"
#include "brickwall/tests/common/ErrorOf.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

PreparedScene preparedFor(const SceneOptions& options)
{
    Progress silent;
    return prepareScene(options, Executor(1), silent);
}

SceneOptions wake()
{
    SceneOptions options;
    options.data = "sample:wake:60k";
    options.iso = {0.5};
    return options;
}

TEST(SceneColors, OfAnotherFieldComeWithARangeOfIt)
{
    SceneOptions options = wake();
    options.colorField = "pressure";
    const PreparedScene prepared = preparedFor(options);
    const TransferFunction& tf = prepared.scene.transferFunction;
    ASSERT_TRUE(tf.colorField && prepared.scene.colorField);
    EXPECT_EQ(tf.colorField->name, "pressure");
    EXPECT_EQ(prepared.colorField, "pressure");
    EXPECT_EQ(prepared.field, "speed");
    EXPECT_LT(tf.colorField->range.lo, 0.0f) << "of pressure, not of speed";
    EXPECT_GE(tf.colorField->range.lo, prepared.scene.colorField->range.lo);
    EXPECT_TRUE(prepared.scene.surfaces[0].coloredByField);
    EXPECT_EQ(prepared.scene.colorField->values.size(), prepared.scene.field->values.size());

    options.colorRange = {-0.25, 0.5};
    options.colorMap = "viridis";
    options.isoColors = {1.0, 0.0, 0.0};
    const PreparedScene said = preparedFor(options);
    EXPECT_EQ(said.scene.transferFunction.colorField->range, (Range{-0.25f, 0.5f}));
    EXPECT_EQ(said.scene.transferFunction.colors.size(), colorMap("viridis").size());
    EXPECT_FALSE(said.scene.surfaces[0].coloredByField) << "the user said in which colour";
}

TEST(SceneColors, OfTheFieldItselfTakeNoMemory)
{
    SceneOptions options = wake();
    options.colorField = "speed";
    const PreparedScene prepared = preparedFor(options);
    EXPECT_EQ(prepared.scene.colorField, prepared.scene.field);
}

TEST(SceneColors, MayBeSaidByTheFileOfTheTransferFunction)
{
    SceneOptions options = wake();
    options.colorField = "pressure";
    options.volume = "off";
    const TransferFunction chosen = preparedFor(options).transferFunction;
    EXPECT_GT(chosen.opacityScale, 0.0f) << "that the volume is off is not the function's business";
    options = wake();
    options.transferFunction = scratchFile("chosen.json");
    writeTransferFunction(chosen, options.transferFunction);
    const PreparedScene read = preparedFor(options);
    EXPECT_EQ(read.scene.transferFunction.colorField, chosen.colorField);
    ASSERT_TRUE(read.scene.colorField);
    options.colorRange = {0.0, 0.25};
    EXPECT_EQ(preparedFor(options).scene.transferFunction.colorField->range, (Range{0.0f, 0.25f}));
    options.colorRange.clear();
    options.colorField = "u";
    const TransferFunction other = preparedFor(options).scene.transferFunction;
    EXPECT_EQ(other.colorField->name, "u") << "what the user says goes first";
    EXPECT_NE(other.colorField->range, chosen.colorField->range);
}

TEST(SceneColors, ThatMakeNoSenseAreRefused)
{
    SceneOptions options = wake();
    options.colorField = "nosuch";
    EXPECT_NE(errorOf([&] { preparedFor(options); }).find("nosuch"), std::string::npos);
    options = wake();
    options.transferFunction = scratchFile("plain.json");
    writeWholeFile(options.transferFunction, R"({"range": [0, 1], "colors": "jet", "opacity": [[0, 0], [1, 1]]})");
    options.colorRange = {0.0, 1.0};
    EXPECT_NE(errorOf([&] { preparedFor(options); }).find("--color-range"), std::string::npos);
}

TEST(SceneColors, OfCoarserDataAreThere)
{
    SceneOptions options = wake();
    options.colorField = "pressure";
    options.lod = 1.0;
    const PreparedScene prepared = preparedFor(options);
    ASSERT_FALSE(prepared.scene.pyramid.empty());
    for (const SceneMember& member : prepared.scene.pyramid)
        EXPECT_TRUE(member.colorField && member.colorField != member.field);
    const Executor serial(1);
    EXPECT_TRUE(Renderer(prepared.scene, serial).scene().colorField);
}

} // namespace
} // namespace brickwall::test
