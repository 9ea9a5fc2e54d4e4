// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/plugin/RigControls.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace brickwall::test {
namespace {

using Event = osgGA::GUIEventAdapter;

struct NoAction : osgGA::GUIActionAdapter
{
    void requestRedraw() override {}
    void requestContinuousUpdate(bool) override {}
    void requestWarpPointer(float, float) override {}
};

/// A corner rig, 100 x 100 pixels a window, with data from -1 to 1 on all axes, that get mouse and keyboard events.
struct Controlled
{
    Rig rig = cornerRig(100, 100);
    ShownRig shown{rig};
    RigNavigation navigation{rig, Box3d{vec3d(-1.0), vec3d(1.0)}};
    osg::ref_ptr<RigControls> controls = new RigControls(rig, shown.windows, navigation);
    NoAction action;

    bool send(Event::EventType type, int window, const std::function<void(Event&)>& fill)
    {
        osg::ref_ptr<Event> event = new Event;
        event->setEventType(type);
        event->setGraphicsContext(shown.windows.channels().camera(window).getGraphicsContext());
        fill(*event);
        return controls->handle(*event, action);
    }
    bool press(int key, bool shift = false)
    {
        return send(Event::KEYDOWN, 0, [&](Event& event) {
            event.setKey(key);
            event.setModKeyMask(shift ? Event::MODKEY_SHIFT : 0);
        });
    }
    /// In pixels, dy upwards.
    void drag(int button, int window, double dx, double dy)
    {
        const auto place = [&](double x, double y) {
            return [=](Event& event) {
                event.setButtonMask(button);
                event.setX(float(x));
                event.setY(float(y)); // downwards, as windows send it
            };
        };
        send(Event::PUSH, window, place(50, 50));
        send(Event::DRAG, window, place(50 + dx, 50 - dy));
    }
    /// Where a point of the data, relative to their centre, is in the room, relative to the centre of the room's data.
    vec3d place(const vec3d& world) const
    {
        return transformPoint(navigation.roomFromWorld(), world) - rig.sceneCenter;
    }
};

void expectNear(const vec3d& found, const vec3d& expected)
{
    EXPECT_NEAR(glm::distance(found, expected), 0.0, 1e-9)
        << found.x << " " << found.y << " " << found.z << " instead of " << expected.x << " " << expected.y << " "
        << expected.z;
}

TEST(RigControls, LeftDragTurnsTheDataWithThePointer)
{
    BRICKWALL_NEEDS_DISPLAY();
    Controlled desk;
    const vec3d nearest(0, 0, 1); // towards the viewer, who is at -y of the data in the room
    expectNear(desk.place(nearest), {0, -1, 0});
    desk.drag(Event::LEFT_MOUSE_BUTTON, 0, 50, 0);
    expectNear(desk.place(nearest), {1, 0, 0});
    desk.press('r');
    desk.drag(Event::LEFT_MOUSE_BUTTON, 0, 0, 50);
    expectNear(desk.place(nearest), {0, 0, 1});
}

TEST(RigControls, MiddleDragMovesTheDataAlongTheScreenUnderThePointer)
{
    BRICKWALL_NEEDS_DISPLAY();
    Controlled desk;
    desk.drag(Event::MIDDLE_MOUSE_BUTTON, 0, 10, 5);
    expectNear(desk.place(vec3d(0.0)), {0.2, 0, 0.1});
    desk.press('r');
    desk.drag(Event::MIDDLE_MOUSE_BUTTON, 1, 10, 5);
    expectNear(desk.place(vec3d(0.0)), {0, 0.2, 0.1});
}

// OSG 3.6.5 leaves the graphics context out of key and some pointer events: without memory, drags and keys went
// nowhere.
TEST(RigControls, EventsThatDoNotNameTheirWindowBelongToThatOfThePointer)
{
    BRICKWALL_NEEDS_DISPLAY();
    Controlled desk;
    desk.drag(Event::MIDDLE_MOUSE_BUTTON, 1, 0, 0);
    desk.send(Event::DRAG, 1, [](Event& event) {
        event.setGraphicsContext(nullptr);
        event.setButtonMask(Event::MIDDLE_MOUSE_BUTTON);
        event.setX(60);
        event.setY(50);
    });
    expectNear(desk.place(vec3d(0.0)), {0, 0.2, 0});
}

TEST(RigControls, RightDragAndWheelScaleTheDataAboutTheirCentre)
{
    BRICKWALL_NEEDS_DISPLAY();
    Controlled desk;
    desk.drag(Event::RIGHT_MOUSE_BUTTON, 0, 0, 50);
    expectNear(desk.place({1, 0, 0}), {2, 0, 0});
    desk.press('r');
    desk.send(Event::SCROLL, 0, [](Event& event) { event.setScrollingMotion(Event::SCROLL_UP); });
    expectNear(desk.place({1, 0, 0}), {1.1, 0, 0});
}

TEST(RigControls, KeysMoveAndTurnTheHead)
{
    BRICKWALL_NEEDS_DISPLAY();
    Controlled desk;
    const auto eye = [&] {
        Viewer viewer;
        viewer.roomFromHead = desk.navigation.roomFromHeads()[0];
        return eyePoint(viewer, Eye::right);
    };
    desk.press(Event::KEY_Right);
    desk.press(Event::KEY_Up);
    desk.press(Event::KEY_Page_Up);
    expectNear(eye(), {0.082, 0.05, 0.05});
    desk.press('r');
    for (int i = 0; i < 18; ++i)
        desk.press(Event::KEY_Left, true);
    expectNear(eye(), {0, 0.032, 0});
    EXPECT_FALSE(desk.press('x'));
}

TEST(RigControls, HelpShowsAndHidesAText)
{
    BRICKWALL_NEEDS_DISPLAY();
    Controlled desk;
    const auto before = desk.shown.draw();
    desk.press('h');
    const auto during = desk.shown.draw();
    desk.press('h');
    const auto after = desk.shown.draw();
    const auto same = [](const osg::Image& a, const osg::Image& b) {
        return std::equal(a.data(), a.data() + a.getTotalSizeInBytes(), b.data());
    };
    for (int i = 0; i < 2; ++i) {
        EXPECT_FALSE(same(*before[i].left, *during[i].left));
        EXPECT_TRUE(same(*before[i].left, *after[i].left));
    }
}

} // namespace
} // namespace brickwall::test
