// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RunCommand.h"

#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <cmath>

using namespace brickwall;
using namespace brickwall::testing;

namespace {

/// A brick of 8^3 cells, one of them a NaN.
std::string fileWithNaN()
{
    const Model model = oracles::modelOf(oracles::oneLevelBricks(vec3i(0), vec3i(8), vec3i(8), 0),
                                         [](const vec3d& p) { return vec3i(p) == vec3i(2, 3, 4) ? NAN : p.x; });
    return oracles::writeExa(scratchFolder().string(), "t", model);
}

} // namespace

TEST(NonFinite, CellsAreAnErrorOrEmptyOnRequest)
{
    const std::string file = fileWithNaN(),
                      render = "render " + file + " --size 16x16 --out " + scratchFolder().string();
    const Outcome refused = run(render);
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_NE(messageOf(refused).find("t.f.scalars: expected a finite value, found nan in field 'f'"),
              std::string::npos)
        << refused.err;
    const Outcome rendered = run(render + " --non-finite empty");
    EXPECT_EQ(rendered.exitCode, 0) << rendered.err;
    EXPECT_NE(rendered.err.find("1 cells without a finite value left out"), std::string::npos) << rendered.err;
    EXPECT_NE(messageOf(run(render + " --non-finite maybe")).find("--non-finite: expected error, empty, found maybe"),
              std::string::npos);
}

TEST(NonFinite, PointsInEmptyCellsAreThoseOfTheirNeighbours)
{
    const std::string file = fileWithNaN();
    const auto points = scratchFolder() / "points.csv";
    write(points, "2.5,3.5,4.5\n2.5,3.5,4.75\n");
    EXPECT_EQ(run("sample " + file + " --points " + points.string()).exitCode, 2);
    const Outcome sampled = run("sample " + file + " --non-finite empty --points " + points.string());
    EXPECT_EQ(sampled.exitCode, 0) << sampled.err;
    // At the cell's centre no other tent reaches; towards the next cell that one's does.
    EXPECT_NE(sampled.out.find("2.5,3.5,4.5,0,0,0,0,0\n"), std::string::npos) << sampled.out;
    EXPECT_NE(sampled.out.find("2.5,3.5,4.75,2.5,"), std::string::npos) << sampled.out;
}
