// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// --streamlines of `render`.
#include "RunCommand.h"

using namespace brickwall;
using namespace brickwall::testing;

namespace {

Outcome renderWith(const std::string& options, const std::string& data = "sample:wake:60k")
{
    return run("render " + data + " --volume off --size 48x48 --out " + (scratchFolder() / "out").string() + " " +
               options);
}

void expectRefused(const std::string& options, const std::string& said, const std::string& data = "sample:wake:60k")
{
    const Outcome outcome = renderWith(options, data);
    EXPECT_EQ(outcome.exitCode, 2) << options;
    EXPECT_NE(messageOf(outcome).find(said), std::string::npos) << outcome.err;
}

} // namespace

TEST(StreamlinesOption, DrawsTubes)
{
    const Outcome outcome =
        renderWith("--streamlines 1x3x3:-1.9,-0.8,-0.8,-1.9,0.8,0.8 --streamlines 4 --streamline-radius 0.1");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("13 lines of velocity for 13 seeds"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("nothing can be seen"), std::string::npos) << outcome.err;
    const std::string with = contentOf(scratchFolder() / "out" / "view.png");
    ASSERT_EQ(renderWith("").exitCode, 0);
    EXPECT_NE(contentOf(scratchFolder() / "out" / "view.png"), with);
}

TEST(StreamlinesOption, IsRefusedWhereItMeansNothing)
{
    expectRefused("--streamlines 5y5", "--streamlines: expected COUNT or NXxNYxNZ");
    expectRefused("--streamlines 5x5", "--streamlines: expected COUNT or NXxNYxNZ");
    expectRefused("--streamlines 0", "--streamlines: expected 1 to 1000000 seeds");
    expectRefused("--streamlines 1000x1000x1000", "--streamlines: expected 1 to 1000000 seeds");
    expectRefused("--streamlines 5:1,2,3", "--streamlines: expected six numbers");
    expectRefused("--streamlines 5:0,0,0,1,-1,1", "--streamlines: expected a box with its lower corner first");
    expectRefused("--streamlines 5:90,0,0,91,1,1", "--streamlines: none of 5 seeds is in a cell");
    expectRefused("--streamlines 5 --streamline-vector nosuch", "no vector 'nosuch' (those there are: velocity)");
    expectRefused("--streamlines 5 --streamline-length -1", "--streamline-length: expected a finite number above 0");
    expectRefused("--streamline-radius 1", "--streamline-radius: has no effect without --streamlines");
    expectRefused("--streamlines 5", "has no vector", "sample:cloud:60k");
}
