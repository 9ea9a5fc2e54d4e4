// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestRigs.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/ViewRendering.h"
#include "brickwall/tests/common/ErrorOf.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace brickwall::test {
namespace {

using namespace std::chrono_literals;

struct TwoChannels : ChannelSource
{
    int numChannels() const override { return 2; }
    OutputChannel channel(int) const override { return {}; }
    bool isDrawnBy(int, osgUtil::CullVisitor&) const override { return false; }
};

/// Both views, for a pose of this number.
std::vector<RequestedView> poseOf(double number)
{
    std::vector<RequestedView> views(2);
    for (int i = 0; i < 2; ++i) {
        views[i].drawerView = i;
        views[i].view.window = {0, 0, 4, 3};
        views[i].model = osg::Matrixd::translate(number, i, 0);
    }
    return views;
}

struct Loop
{
    osg::ref_ptr<MultiChannelDrawer> drawer = new MultiChannelDrawer(new TwoChannels);
    ViewRendering rendering{*drawer};

    /// The number of the next set that is published; 0 if it becomes idle before.
    unsigned next()
    {
        while (!rendering.idle()) {
            rendering.waitFor(20ms);
            if (const auto number = rendering.publish())
                return *number;
        }
        return 0;
    }
};

/// Renders when it is let, and says what it was asked to.
struct Gate
{
    std::atomic<int> started = 0;
    std::atomic<int> open = 0;      ///< so many may pass
    std::atomic<int> cancelled = 0; ///< before they were let

    FrameMaker maker()
    {
        return [this](std::span<const View> views, Progress& progress) {
            const int mine = ++started;
            while (open < mine) {
                if (progress.cancelled())
                    ++cancelled;
                progress.check();
                std::this_thread::sleep_for(1ms);
            }
            return patternFrames(views, progress);
        };
    }
    void waitForStart(int count) const
    {
        while (started < count)
            std::this_thread::sleep_for(1ms);
    }
};

TEST(ViewRendering, PublishesAllViewsOfOnePoseTogetherWithTheirMatrices)
{
    Loop loop;
    EXPECT_TRUE(loop.rendering.idle());
    EXPECT_FALSE(loop.rendering.publish());
    const unsigned number = loop.rendering.request(poseOf(7), patternFrames);
    EXPECT_EQ(loop.next(), number);
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(loop.drawer->imageMatrix(i), osg::Matrixd::translate(7, i, 0));
    EXPECT_TRUE(loop.rendering.idle());
}

TEST(ViewRendering, TheNewestPoseReplacesThoseThatHaveNotBegun)
{
    Loop loop;
    Gate gate;
    const unsigned first = loop.rendering.request(poseOf(1), gate.maker());
    gate.waitForStart(1);
    loop.rendering.request(poseOf(2), gate.maker());
    const unsigned third = loop.rendering.request(poseOf(3), gate.maker());
    EXPECT_FALSE(loop.rendering.publish()) << "nobody waits";
    gate.open = 10;
    EXPECT_EQ(loop.next(), first) << "a pose that is being rendered is completed";
    EXPECT_EQ(loop.next(), third);
    EXPECT_EQ(loop.next(), 0u);
    EXPECT_EQ(gate.started, 2);
}

TEST(ViewRendering, AnOutdatedSetIsCancelledButNeverTwiceInARow)
{
    Loop loop;
    Gate gate;
    loop.rendering.request(poseOf(1), gate.maker());
    gate.waitForStart(1);
    const unsigned second = loop.rendering.request(poseOf(2), gate.maker(), true);
    gate.waitForStart(2);
    EXPECT_EQ(gate.cancelled, 1);
    const unsigned third = loop.rendering.request(poseOf(3), gate.maker(), true);
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(gate.cancelled, 1) << "whoever turns a knob for long would never see anything";
    gate.open = 10;
    EXPECT_EQ(loop.next(), second);
    EXPECT_EQ(loop.next(), third);
}

TEST(ViewRendering, TheNextSetIsRenderedWhileTheHostHasNotPublishedTheLast)
{
    Loop loop;
    Gate gate;
    gate.open = 10;
    const unsigned first = loop.rendering.request(poseOf(1), gate.maker());
    loop.rendering.waitFor(10s);
    const unsigned second = loop.rendering.request(poseOf(2), gate.maker());
    gate.waitForStart(2);
    EXPECT_EQ(loop.next(), first);
    EXPECT_EQ(loop.drawer->imageMatrix(0), osg::Matrixd::translate(1, 0, 0));
    EXPECT_EQ(loop.next(), second);
}

TEST(ViewRendering, ForgetsWhatItRendersWhenTheViewsAreRestructured)
{
    Loop loop;
    Gate gate;
    loop.rendering.request(poseOf(1), gate.maker());
    gate.waitForStart(1);
    loop.rendering.restructure([&] { loop.drawer->setNumViews(1); });
    EXPECT_EQ(loop.next(), 0u);
    EXPECT_EQ(gate.cancelled, 1);
    std::vector<RequestedView> one = poseOf(2);
    one.pop_back();
    const unsigned number = loop.rendering.request(one, patternFrames);
    EXPECT_EQ(loop.next(), number);
}

TEST(ViewRendering, HandsOnWhatRenderingThrowsOnceAndGoesOn)
{
    Loop loop;
    loop.rendering.request(poseOf(1), [](auto, Progress&) -> std::vector<Frame> { throw Error("here", "broken"); });
    EXPECT_EQ(errorOf([&] { loop.next(); }), "here: broken");
    loop.rendering.request(poseOf(1), [](auto, Progress&) { return std::vector<Frame>(1); });
    EXPECT_EQ(errorOf([&] { loop.next(); }), "viewer: expected a frame for each of 2 views, got 1");
    const unsigned number = loop.rendering.request(poseOf(3), patternFrames);
    EXPECT_EQ(loop.next(), number);
}

TEST(ViewRendering, EndsWhileItRenders)
{
    Gate gate;
    {
        Loop loop;
        loop.rendering.request(poseOf(1), gate.maker());
        gate.waitForStart(1);
    }
    EXPECT_EQ(gate.cancelled, 1);
}

} // namespace
} // namespace brickwall::test
