// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/channels/FramePlants.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

constexpr double target = 0.05;
constexpr double wanted = 1.0 / 255.0;

/// Every plant of which a step in load is asked to be answered; 70 ms at first.
std::vector<Plant> plants()
{
    Plant base;
    base.finestSeconds = 0.07;
    std::vector<Plant> all;
    const auto add = [&](const std::string& name, auto&& change) {
        Plant plant = base;
        plant.name = name;
        change(plant);
        all.push_back(plant);
    };
    add("proportional to work", [](Plant& p) { p.share = 0.0; });
    add("a tenth out of reach", [](Plant&) {});
    add("a third out of the tolerance's reach", [](Plant& p) { p.share = 0.33; });
    add("a half out of the tolerance's reach", [](Plant& p) { p.share = 0.5; });
    add("a plateau of 10 ms", [](Plant& p) { p.constantSeconds = 0.01; });
    add("a plateau of 20 ms", [](Plant& p) { p.constantSeconds = 0.02; });
    add("less work than is thought", [](Plant& p) { p.exponent = 0.7; });
    add("more work than is thought", [](Plant& p) { p.exponent = 1.3; });
    add("a display of 60 Hz", [](Plant& p) { p.refreshSeconds = 1.0 / 60.0; });
    add("one frame underway", [](Plant& p) { p.delay = 1; });
    add("two frames underway", [](Plant& p) { p.delay = 2; });
    add("single spikes", [](Plant& p) { p.spikeEvery = 17; });
    return all;
}

std::string rowOf(const Plant& plant, const std::vector<FlownFrame>& flown, int frame)
{
    const FlownFrame& f = flown[std::size_t(frame)];
    return plant.name + ", frame " + std::to_string(frame) + ": " + std::to_string(1e3 * f.expected) +
           " ms at tolerance " + std::to_string(f.levers.tolerance) + " and " + std::to_string(f.levers.imageEighths) +
           "/8";
}

/// What the display shows, without noise and spikes.
double shownSeconds(const Plant& plant, const FlownFrame& frame)
{
    if (plant.refreshSeconds == 0.0)
        return frame.expected;
    return std::ceil(frame.expected / plant.refreshSeconds - 1e-9) * plant.refreshSeconds;
}

/// From that frame on, as parts of the target.
void expectBetween(double low, double high, const Plant& plant, const std::vector<FlownFrame>& flown, int from)
{
    for (int i = from; i < int(flown.size()); ++i) {
        const double part = shownSeconds(plant, flown[std::size_t(i)]) / target;
        EXPECT_LE(part, high) << rowOf(plant, flown, i);
        EXPECT_GE(part, low) << rowOf(plant, flown, i);
    }
}

void expectNoMoves(const Plant& plant, const std::vector<FlownFrame>& flown, int from)
{
    for (int i = from; i < int(flown.size()); ++i)
        EXPECT_FALSE(flown[std::size_t(i)].moved) << rowOf(plant, flown, i);
}

TEST(FrameTime, AStepInLoadIsAnsweredWithinFiveFramesWithAQuarterOfOvershoot)
{
    for (Plant plant : plants())
        for (const double factor : {4.0, 10.0}) {
            plant.load = [factor](int frame) { return frame < 60 ? 1.0 : factor; };
            FrameTime controller(leversForTolerance(wanted));
            SCOPED_TRACE("x " + std::to_string(factor));
            expectBetween(0.75, 1.2, plant, fly(plant, controller, 160), 65);
        }
}

TEST(FrameTime, TheFirstFramesOfASlowSceneAreAnsweredLikeAStep)
{
    for (Plant plant : plants())
        for (const double seconds : {0.2, 0.5}) {
            plant.finestSeconds = seconds;
            FrameTime controller(leversForTolerance(wanted));
            expectBetween(0.75, 1.25, plant, fly(plant, controller, 60), 12); // nothing is known about the plant yet
        }
}

TEST(FrameTime, WhatIsSlowNoMoreGetsItsAccuracyBackWithinASecondAndWithoutOvershoot)
{
    for (Plant plant : plants())
        for (const double factor : {0.25, 0.5}) {
            if (plant.constantSeconds > 0.0)
                continue; // its load does not fall by that
            plant.finestSeconds = 0.4;
            plant.load = [factor](int frame) { return frame < 60 ? 1.0 : factor; };
            FrameTime controller(leversForTolerance(wanted));
            const auto flown = fly(plant, controller, 200);
            double since = 0.0;
            for (int i = 60; i < 200; ++i) {
                const FlownFrame& frame = flown[std::size_t(i)];
                since += frame.measured;
                EXPECT_LE(frame.expected, 1.25 * target) << rowOf(plant, flown, i);
                if (since > 1.0) {
                    EXPECT_GE(shownSeconds(plant, frame), 0.75 * target) << rowOf(plant, flown, i);
                }
            }
        }
}

// Steps of 30 %, one a second, once took five seconds to a quarter of the load.
TEST(FrameTime, BehindNoiseWhatIsSlowNoMoreGetsItsAccuracyBackWithinTwoSeconds)
{
    constexpr int runs = 40, falls = 100, end = 400;
    for (const double noise : {0.1, 0.2})
        for (const double factor : {0.25, 0.5}) {
            SCOPED_TRACE(std::to_string(noise) + " noise, load x " + std::to_string(factor));
            double framesToReturn = 0.0;
            for (unsigned seed = 1; seed <= runs; ++seed) {
                Plant plant;
                plant.finestSeconds = 0.3;
                plant.noise = noise;
                plant.seed = seed;
                plant.load = [factor](int frame) { return frame < falls ? 1.0 : factor; };
                FrameTime controller(leversForTolerance(wanted));
                const auto flown = fly(plant, controller, end);
                const auto back = std::find_if(flown.begin() + falls, flown.end(),
                                               [](const FlownFrame& f) { return f.expected >= 0.8 * target; });
                framesToReturn += double(back - (flown.begin() + falls)) / runs;
                for (auto frame = back; frame != flown.end(); ++frame)
                    EXPECT_LE(frame->expected, 1.4 * target) << "seed " << seed;
            }
            EXPECT_LE(framesToReturn, 40.0);
        }
}

TEST(FrameTime, AConstantLoadLeadsToConstantLevers)
{
    for (Plant plant : plants())
        for (const double seconds : {0.01, 0.15, 5.0})
            for (const double fps : {5.0, 11.0, 20.0, 37.0, 60.0}) {
                plant.finestSeconds = seconds;
                FrameTimeConfig config;
                config.targetSeconds = 1.0 / fps;
                FrameTime controller(leversForTolerance(wanted), config);
                SCOPED_TRACE(std::to_string(fps) + " fps");
                expectNoMoves(plant, fly(plant, controller, 600), 300);
            }
}

TEST(FrameTime, ADisplayThatCountsInRefreshesLeadsToNoCycle)
{
    for (double fps = 5.0; fps <= 60.0; fps += 2.5)
        for (const double seconds : {0.02, 0.07, 0.2}) {
            Plant plant;
            plant.finestSeconds = seconds;
            plant.refreshSeconds = 1.0 / 60.0;
            FrameTimeConfig config;
            config.targetSeconds = 1.0 / fps;
            FrameTime controller(leversForTolerance(wanted), config);
            SCOPED_TRACE(std::to_string(fps) + " fps");
            expectNoMoves(plant, fly(plant, controller, 1300), 900);
        }
}

TEST(FrameTime, OnNoiseOfTwentyPercentNoLeverIsMovedTwiceInASecond)
{
    for (const bool uniform : {true, false})
        for (const double seconds : {0.07, 0.12, 0.2, 0.3, 0.5}) {
            Plant plant;
            plant.seed = unsigned(1000 * seconds);
            plant.name = uniform ? "uniform noise" : "normal noise";
            plant.finestSeconds = seconds;
            plant.noise = 0.2;
            plant.uniformNoise = uniform;
            FrameTime controller(leversForTolerance(wanted));
            const auto flown = fly(plant, controller, 6000);
            double now = 0.0, last = -1e9, sum = 0.0;
            int moves = 0;
            for (int i = 0; i < 6000; ++i) {
                const FlownFrame& frame = flown[std::size_t(i)];
                now += frame.measured;
                if (now < 2.0)
                    continue;
                sum += frame.expected;
                if (!frame.moved)
                    continue;
                EXPECT_GE(now - last, 1.0) << rowOf(plant, flown, i);
                last = now;
                ++moves;
            }
            EXPECT_LE(moves, now / 5.0) << plant.name << ", " << seconds;
            EXPECT_NEAR(sum / 6000 / target, 1.0, 0.15) << plant.name << ", " << seconds;
        }
}

TEST(FrameTime, SingleSpikesMoveNothing)
{
    for (const int every : {5, 7, 17, 60})
        for (const double seconds : {0.03, 0.1, 0.2}) {
            Plant plant;
            plant.name = "spikes every " + std::to_string(every);
            plant.finestSeconds = seconds;
            plant.spikeEvery = every;
            FrameTime controller(leversForTolerance(wanted));
            expectNoMoves(plant, fly(plant, controller, 500), 60);
        }
}

TEST(FrameTime, AnUnreachableTargetEndsAtTheCheapestSettingAndSaysSo)
{
    for (Plant plant : plants()) {
        plant.finestSeconds = 20.0;
        FrameTime controller(leversForTolerance(wanted));
        fly(plant, controller, 50);
        EXPECT_EQ(controller.decision().levers, controller.cost().coarsest()) << plant.name;
        EXPECT_TRUE(controller.decision().unreachable) << plant.name;

        plant.finestSeconds = 0.08;
        plant.load = {};
        fly(plant, controller, 100);
        EXPECT_FALSE(controller.decision().unreachable) << plant.name;
        EXPECT_GE(controller.decision().levers.imageEighths, 7)
            << plant.name; // a display shows 50 ms before 8 are reached
    }
}

TEST(FrameTime, AFastSceneIsRenderedAsTheUserWants)
{
    Plant plant;
    plant.finestSeconds = 0.02;
    FrameTime controller(leversForTolerance(wanted));
    fly(plant, controller, 100);
    EXPECT_EQ(controller.decision().levers, controller.cost().finest());
    EXPECT_EQ(controller.decision().number, 0u);
    EXPECT_FALSE(controller.decision().unreachable);
}

} // namespace
} // namespace brickwall::test
