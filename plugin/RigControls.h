// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/FramePace.h"
#include "brickwall/plugin/RigNavigation.h"
#include "brickwall/plugin/RigWindows.h"

#include <osgGA/GUIEventHandler>

#include <string>

namespace brickwall {

/// Mouse and keyboard of the rig viewer: turns them into movements of a RigNavigation, in the axes of the screen that
/// the window under the pointer shows.
class RigControls : public osgGA::GUIEventHandler
{
public:
    /// All have to outlive the viewer's event traversals. `rig` is read anew at every event. Without a pace there is no
    /// frame rate to be set.
    RigControls(const Rig& rig, RigWindows& windows, RigNavigation& navigation, FramePace* pace = nullptr)
        : rig_(rig), windows_(windows), navigation_(navigation), pace_(pace)
    {
    }

    /// What the windows say about the frame rate, unless the user has hidden that.
    void showStatus(const std::string& status);

    using osgGA::GUIEventHandler::handle;
    bool handle(const osgGA::GUIEventAdapter& event, osgGA::GUIActionAdapter& action) override;

private:
    void showText();
    bool setFps(int key);
    bool key(const osgGA::GUIEventAdapter& event);
    bool drag(const osgGA::GUIEventAdapter& event);
    void remember(const osgGA::GUIEventAdapter& event);
    void rememberWindow(const osgGA::GUIEventAdapter& event);

    const Rig& rig_;
    RigWindows& windows_;
    RigNavigation& navigation_;
    FramePace* pace_;
    std::string status_;
    std::string shownText_;
    bool statusShown_ = true;
    double lastX_ = 0.0;
    double lastY_ = 0.0; ///< upwards
    int window_ = 0;     ///< that the pointer was last seen in; OSG does not tell it with every event
    bool helpShown_ = false;
};

/// Arrows and page keys move the heads by 5 cm, arrows with shift turn them by 5 degrees. Says whether it was such a
/// key.
bool moveHeadsByKey(RigNavigation& navigation, int key, bool shift);

} // namespace brickwall
