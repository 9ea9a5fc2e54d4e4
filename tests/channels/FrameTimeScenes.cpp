// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "app/EarlierPluginRule.h"
#include "brickwall/tests/channels/FramePlants.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <type_traits>

namespace brickwall::test {
namespace {

constexpr double target = 0.05;
constexpr double wanted = 1.0 / 255.0;

static_assert(std::is_trivially_copyable_v<FrameLevers> && std::is_trivially_copyable_v<FrameDecision>,
              "sent to other nodes as they are");

Plant alternating(int frames)
{
    Plant plant;
    plant.name = "another scene every " + std::to_string(frames) + " frames";
    plant.finestSeconds = 0.2;
    plant.load = [frames](int frame) { return frame / frames % 2 == 0 ? 1.0 : 4.0; };
    return plant;
}

bool withinClamps(const FrameTime& controller)
{
    const FrameLevers& levers = controller.decision().levers;
    return levers == controller.cost().clamped(levers);
}

TEST(FrameTime, TwoScenesInQuickAlternationEndOnOneSettingAndInSlowOneAreFollowed)
{
    for (const int frames : {1, 2, 3, 5}) {
        const Plant plant = alternating(frames);
        FrameTime controller(leversForTolerance(wanted));
        const auto flown = fly(plant, controller, 2000);
        const auto moves = std::count_if(flown.begin() + 200, flown.end(), [](const auto& f) { return f.moved; });
        EXPECT_LE(moves, 1800 / 12) << plant.name;
    }
    for (const int frames : {100, 200}) {
        const Plant plant = alternating(frames);
        FrameTime controller(leversForTolerance(wanted));
        const auto flown = fly(plant, controller, 2000);
        const auto good = std::count_if(flown.begin(), flown.end(),
                                        [](const auto& f) { return std::abs(f.expected / target - 1.0) <= 0.2; });
        EXPECT_GE(double(good) / 2000, 0.9) << plant.name;
    }
}

TEST(FrameTime, ALoadThatDriftsIsFollowed)
{
    for (const double rate : {0.003, 0.01, 0.02}) {
        Plant plant;
        plant.finestSeconds = 0.2;
        plant.noise = 0.03;
        plant.load = [rate](int frame) { return std::exp(std::sin(frame * rate)); };
        FrameTime controller(leversForTolerance(wanted));
        const auto flown = fly(plant, controller, 2000);
        const auto good = std::count_if(flown.begin() + 20, flown.end(),
                                        [](const auto& f) { return std::abs(f.expected / target - 1.0) <= 0.2; });
        EXPECT_GE(double(good) / 1980, 0.95) << "up to " << 100 * rate << " % from frame to frame";
    }
}

/// Frames within 20 % of the target, as a part.
double partWithin(const std::vector<FlownFrame>& flown, std::size_t from)
{
    const auto good = std::count_if(flown.begin() + std::ptrdiff_t(from), flown.end(),
                                    [](const auto& f) { return std::abs(f.expected / target - 1.0) <= 0.2; });
    return double(good) / double(flown.size() - from);
}

TEST(FrameTime, ALoadThatFallsSteadilyIsFollowedAsWellAsOneThatRises)
{
    for (const double rate : {-0.03, -0.02, -0.01, 0.01, 0.02, 0.03}) {
        Plant plant;
        plant.finestSeconds = rate < 0.0 ? 1.0 : 0.1;
        plant.noise = 0.03;
        plant.load = [rate](int frame) { return std::exp(rate * std::max(0, frame - 40)); };
        FrameTime controller(leversForTolerance(wanted));
        const int frames = 40 + int(2.0 / std::abs(rate));
        EXPECT_GE(partWithin(fly(plant, controller, frames), 20), 0.95) << rate;
    }
}

TEST(FrameTime, WorkThatIsKnownBeforehandMakesAJumpNoSurprise)
{
    Plant plant;
    plant.finestSeconds = 0.1;
    plant.noise = 0.02;
    plant.load = [](int frame) { return 1.0 + 2.0 * (frame / 50 % 2); };
    FrameTime controller(leversForTolerance(wanted));
    PlantClock clock(plant);
    int far = 0;
    for (int i = 0; i < 500; ++i) {
        const double work = 1000.0 * plant.loadAt(i);
        const FlownFrame frame = clock.next(controller.decide(work).levers);
        controller.report(frame.levers, frame.measured, work);
        far += i >= 20 && std::abs(frame.expected / target - 1.0) > 0.2;
    }
    EXPECT_EQ(far, 0) << "frames of 480, the first one after each jump included";
}

/// Frames in a row that are more than 20 % from the target, at the most.
int longestMiss(const std::vector<FlownFrame>& flown, std::size_t from)
{
    int longest = 0, now = 0;
    for (std::size_t i = from; i < flown.size(); ++i) {
        now = std::abs(flown[i].expected / target - 1.0) > 0.2 ? now + 1 : 0;
        longest = std::max(longest, now);
    }
    return longest;
}

/// Data of 100 million cells that a flight left behind: more accuracy had been in vain while they came near, and was
/// not tried for a second in which frames became twice as fast, because what they took for their work had not changed.
TEST(FrameTime, WhatWasInVainIsTriedAgainWhenThereIsLessToDo)
{
    for (unsigned seed = 1; seed <= 20; ++seed) {
        Plant plant;
        plant.finestSeconds = 0.5;
        plant.exponent = 0.5;
        plant.noise = 0.03;
        plant.seed = seed;
        plant.load = [](int frame) { return std::exp(0.7 * std::sin(0.06 * frame)); };
        FrameTime controller(leversForTolerance(wanted));
        PlantClock clock(plant);
        std::vector<FlownFrame> flown;
        for (int i = 0; i < 600; ++i) {
            flown.push_back(clock.next(controller.decide(plant.loadAt(i)).levers));
            controller.report(flown.back().levers, flown.back().measured, plant.loadAt(i));
        }
        EXPECT_LE(longestMiss(flown, 20), 3) << "seed " << seed;
        EXPECT_GE(partWithin(flown, 20), 0.95) << "seed " << seed;
    }
}

TEST(FrameTime, TimesThatAreNoNumbersChangeNothingAndAreCounted)
{
    const double garbage[] = {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                              std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    Plant plant;
    plant.finestSeconds = 0.2;
    FrameTime controller(leversForTolerance(wanted));
    fly(plant, controller, 50);
    const FrameLevers before = controller.decision().levers;
    for (int i = 0; i < 50; ++i)
        for (const double seconds : garbage) {
            controller.report(before, seconds);
            controller.report(before, target, seconds);
            EXPECT_EQ(controller.decide(seconds).levers, before);
        }
    EXPECT_EQ(controller.ignored(), 500u);
    const auto flown = fly(plant, controller, 50);
    for (const FlownFrame& frame : flown)
        EXPECT_NEAR(frame.expected / target, 1.0, 0.2);
}

TEST(FrameTime, LeversStayWithinTheirClampsWhateverItIsTold)
{
    const double odd[] = {0.0,
                          -0.0,
                          -1e300,
                          1e300,
                          1e-300,
                          5e-324,
                          1.0,
                          1e-9,
                          0.05,
                          1e9,
                          std::numeric_limits<double>::quiet_NaN(),
                          std::numeric_limits<double>::infinity()};
    std::mt19937 random(7);
    const auto any = [&] { return odd[random() % std::size(odd)]; };
    for (int run = 0; run < 50; ++run) {
        FrameTime controller(run % 2 ? leversForTolerance(wanted) : leversForDt(0.5));
        for (int i = 0; i < 400; ++i) {
            FrameLevers levers = controller.decision().levers;
            if (random() % 4 == 0)
                levers = {any(), any(), int(random())};
            const double seconds = random() % 3 == 0 ? any() : std::exp(std::normal_distribution(-3.0, 5.0)(random));
            controller.report(levers, seconds, random() % 8 == 0 ? any() : 1.0);
            controller.decide(random() % 8 == 0 ? any() : 1.0);
            ASSERT_TRUE(withinClamps(controller)) << controller.decision().levers.tolerance;
            ASSERT_TRUE(std::isfinite(controller.decision().expectedSeconds));
        }
    }
}

TEST(FrameTime, ForAGivenTimeTheLastLeverIsMovedLeast)
{
    FrameCost cost({{Lever::tolerance, wanted, 0.1}, {Lever::dt, 0.5, 2.0}, {Lever::imageScale, 8.0, 2.0}});
    const double least = cost.logFactor(cost.coarsest());
    double lastTolerance = wanted;
    for (double factor = 0.0; factor > least; factor -= 0.01) {
        const FrameLevers levers = cost.solve(factor);
        EXPECT_LE(cost.logFactor(levers), factor + 1e-9);
        if (levers.imageEighths < 8) { // the next eighth would be too much, whatever the others do
            FrameLevers finer = cost.coarsest();
            finer.imageEighths = levers.imageEighths + 1;
            EXPECT_GT(cost.logFactor(finer), factor);
        } else if (levers.dt > 0.5) {
            EXPECT_NEAR(levers.tolerance, 0.1, 1e-9);
        } else {
            EXPECT_GE(levers.tolerance, lastTolerance);
            EXPECT_NEAR(cost.logFactor(levers), factor, 1e-9);
            lastTolerance = levers.tolerance;
        }
    }
    EXPECT_EQ(cost.solve(least - 1.0), cost.coarsest());
    EXPECT_EQ(cost.solve(1.0), cost.finest());
}

TEST(FrameTime, WhatALeverDoesIsLearntFromMovingIt)
{
    for (const double share : {0.0, 0.3, 0.6}) {
        Plant plant;
        plant.share = share;
        FrameCost cost(leversForTolerance(wanted));
        for (const double tolerance : {0.1, 0.01, 0.05, 0.005, 0.1, 0.01}) {
            FrameLevers from, to;
            to.tolerance = tolerance;
            cost.learn(from, to, std::log(plant.secondsAt(to, 0) / plant.secondsAt(from, 0)), 0.05 * 0.05);
        }
        EXPECT_NEAR(cost.share(0), share, 0.03);
    }
}

TEST(FrameTime, AWindowThatIsResizedIsNoSurprise)
{
    FrameTime controller(leversForTolerance(wanted));
    const auto secondsOf = [](const FrameLevers& levers, double pixels) {
        return Plant{}.secondsAt(levers, 0) * pixels;
    };
    for (int i = 0; i < 30; ++i)
        controller.report(controller.decide(1.0).levers, secondsOf(controller.decision().levers, 1.0), 1.0);
    EXPECT_NEAR(secondsOf(controller.decide(3.0).levers, 3.0) / target, 1.0, 0.2) << "the first frame already";
}

TEST(FrameTime, AnotherTargetIsHeldFromTheNextFrames)
{
    Plant plant;
    plant.finestSeconds = 0.2;
    FrameTime controller(leversForTolerance(wanted));
    fly(plant, controller, 30);
    for (const double fps : {40.0, 10.0, 25.0}) {
        controller.setTarget(1.0 / fps);
        const auto flown = fly(plant, controller, 20);
        EXPECT_NEAR(flown.back().expected * fps, 1.0, 0.15);
    }
}

TEST(FrameTime, RangesAndTargetsThatAreNoneAreRefused)
{
    EXPECT_THROW(FrameTime({{Lever::tolerance, 0.0, 0.1}}), std::invalid_argument);
    EXPECT_THROW(FrameTime({{Lever::tolerance, 0.1, 0.01}}), std::invalid_argument);
    EXPECT_THROW(FrameTime({{Lever::imageScale, 8.0, 0.0}}), std::invalid_argument);
    EXPECT_THROW(FrameTime({{Lever::dt, 0.5, std::numeric_limits<double>::infinity()}}), std::invalid_argument);
    FrameTime controller(leversForDt(0.5));
    EXPECT_THROW(controller.setTarget(0.0), std::invalid_argument);
    EXPECT_THROW(controller.setTarget(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
}

TEST(FrameTime, RendersWithNoLeversAtAll)
{
    FrameTime controller({});
    for (int i = 0; i < 20; ++i)
        controller.report(controller.decide().levers, 0.5);
    EXPECT_EQ(controller.decision().number, 0u);
    EXPECT_TRUE(controller.decision().unreachable);
}

// What the earlier plugin did, on the same plants: the reasons that this controller exists.
struct EarlierFlight
{
    double leastDt = 0.5;
    int framesToBand = 0; ///< after the step at frame 60, or all of them
};

EarlierFlight flyEarlierRule(double finestSeconds, double factor)
{
    EarlierPluginRule rule(20.0);
    EarlierFlight flight;
    for (int i = 0; i < 1000; ++i) {
        const double seconds = 0.005 + (i < 60 ? 1.0 : factor) * finestSeconds * 0.5 / rule.dt();
        const double slept = rule.frame(seconds);
        flight.leastDt = std::min(flight.leastDt, rule.dt());
        if (rule.dt() <= 0.0)
            break;
        if (i >= 60 && (seconds + slept) / target > 1.2)
            flight.framesToBand = i - 60 + 1;
    }
    return flight;
}

TEST(FrameTime, TheEarlierRuleNeedsHundredsOfFramesAndPassesThroughZero)
{
    EXPECT_GT(flyEarlierRule(0.04, 4.0).framesToBand, 100) << "frames after the load has grown fourfold";
    EXPECT_LE(flyEarlierRule(0.0001, 1.0).leastDt, 0.0) << "where every step size is fast enough";
}

} // namespace
} // namespace brickwall::test
