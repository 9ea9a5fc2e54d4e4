// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Ten views in one call: what a wall of five screens and two eyes asks for.
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace brickwall {
namespace {

using namespace test;

std::vector<View> tenViews()
{
    std::vector<View> views;
    const vec3d centre(16.0, 15.0, 18.0);
    for (const vec3d& side :
         {vec3d(-1, 0.4, 0.2), vec3d(0.3, 1, 0.2), vec3d(0.5, 0.2, -1), vec3d(1, 0.1, 0.4), vec3d(0.1, -1, 0.3)})
        for (const double eye : {-0.7, 0.7}) {
            views.push_back(lookAt(centre + 40.0 * side + vec3d(eye), centre, 37, 21, 50.0));
            views.back().name = std::to_string(views.size());
        }
    return views;
}

/// What was done, and not how long it took: the same on any machine.
TEST(RenderManyViews, CostTogetherWhatTheyCostAlone)
{
    const std::vector<Brick> bricks = threeLevels(5);
    const Scene scene = sceneOf(bricks, fieldOf(bricks, waves), colorful({-1.0f, 1.0f}));
    const Executor two(2);
    const Renderer renderer(scene, two);
    const std::vector<View> views = tenViews();
    Progress silent;
    for (const Method method : {Method::bounded, Method::midpoint}) {
        RenderSettings settings = settingsOf(0.5f, Shading::headlight);
        settings.method = method;
        std::vector<ViewStatistics> together, alone;
        const std::vector<Frame> frames = renderer.render(views, settings, silent, &together);
        ASSERT_EQ(together.size(), views.size());
        for (std::size_t i = 0; i < views.size(); ++i) {
            const Frame frame = renderer.render({&views[i], 1}, settings, silent, &alone).front();
            EXPECT_EQ(frame.color, frames[i].color) << i;
            EXPECT_EQ(frame.depth, frames[i].depth) << i;
            EXPECT_GT(alone[0].counts.samples, 0u);
            EXPECT_EQ(together[i].rays, alone[0].rays) << i;
            EXPECT_EQ(together[i].counts.samples, alone[0].counts.samples) << i;
            EXPECT_EQ(together[i].counts.fetches, alone[0].counts.fetches) << i;
            EXPECT_EQ(together[i].counts.regionsVisited, alone[0].counts.regionsVisited) << i;
        }
    }
}

} // namespace
} // namespace brickwall
