// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigFilesOrientation.h"
#include "brickwall/channels/RigFilesRecordTable.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace brickwall {
namespace {

Screen screenOf(RecordTable table)
{
    Screen screen;
    screen.name = table.text("name", "");
    const bool corners = table.has("lower_left") || table.has("lower_right") || table.has("upper_right");
    const bool centred = table.has("center") || table.has("size") || table.has("orientation");
    if (corners == centred)
        table.fail("", "expected either lower_left, lower_right and upper_right, or center, size and orientation");
    if (corners) {
        screen.lowerLeft = table.vector("lower_left");
        screen.lowerRight = table.vector("lower_right");
        screen.upperRight = table.vector("upper_right");
    } else {
        const std::vector<double> size = table.numbers("size", 2);
        placeScreen(screen, table.vector("center"), size[0], size[1],
                    rotationOf(table.vector("orientation", vec3d(0.0))));
    }
    if (table.has("pixels")) {
        const std::vector<int> pixels = table.integers("pixels", 2);
        screen.pixelWidth = pixels[0];
        screen.pixelHeight = pixels[1];
    }
    table.finish();
    return screen;
}

Viewer viewerOf(RecordTable table)
{
    Viewer viewer;
    viewer.name = table.text("name", "viewer");
    const bool position = table.has("position"), orientation = table.has("orientation");
    if (table.has("room_from_head")) {
        if (position || orientation)
            table.fail("room_from_head", "it stands for position and orientation; expected only one of the two");
        viewer.roomFromHead = table.matrix("room_from_head");
    } else {
        viewer.roomFromHead = mat4d(rotationOf(table.vector("orientation", vec3d(0.0))));
        viewer.roomFromHead[3] = vec4d(table.vector("position", vec3d(0.0)), 1.0);
    }
    const bool leftEye = table.has("left_eye"), rightEye = table.has("right_eye");
    if (table.has("eye_separation")) {
        if (leftEye || rightEye)
            table.fail("eye_separation", "it stands for left_eye and right_eye; expected only one of the two");
        const double half = table.number("eye_separation", 0.0) / 2.0;
        viewer.leftEye = {-half, 0.0, 0.0};
        viewer.rightEye = {half, 0.0, 0.0};
    } else {
        viewer.leftEye = table.vector("left_eye", viewer.leftEye);
        viewer.rightEye = table.vector("right_eye", viewer.rightEye);
    }
    table.finish();
    return viewer;
}

Window windowOf(RecordTable table)
{
    Window window;
    window.name = table.text("name", "");
    window.display = table.text("display", "");
    if (table.has("position")) {
        const std::vector<int> position = table.integers("position", 2);
        window.x = position[0];
        window.y = position[1];
    }
    const std::vector<int> size = table.integers("size", 2);
    window.width = size[0];
    window.height = size[1];
    window.decoration = table.flag("decoration", window.decoration);
    window.quadBuffer = table.flag("quad_buffer", window.quadBuffer);
    table.finish();
    return window;
}

PixelRect rectOf(RecordTable& table, const std::string& key)
{
    const std::vector<int> v = table.integers(key, 4);
    return {v[0], v[1], v[2], v[3]};
}

Channel channelOf(RecordTable table, const Rig& rig)
{
    Channel channel;
    channel.screen = table.reference("screen", rig.screens, 0);
    channel.viewer = table.reference("viewer", rig.viewers, 0);
    channel.window = table.reference("window", rig.windows, -1);
    if (rig.screens.empty())
        table.fail("", "there is no [[screen]] that the channel could show");
    channel.name = table.text("name", rig.screens[channel.screen].name);
    if (table.has("viewport"))
        channel.viewport = rectOf(table, "viewport");
    else if (channel.window >= 0)
        channel.viewport = {0, 0, rig.windows[channel.window].width, rig.windows[channel.window].height};
    else
        table.fail("", "a channel without a window needs a viewport");
    if (table.has("part"))
        channel.part = rectOf(table, "part");
    const std::string stereo = table.text("stereo", "mono");
    const std::optional<StereoMode> mode = stereoModeOf(stereo);
    if (!mode)
        table.fail("stereo",
                   fmt::format("expected mono, left, right, horizontal_split, vertical_split, anaglyphic, "
                               "quad_buffer, horizontal_interlace, vertical_interlace or checkerboard, found \"{}\"",
                               stereo));
    channel.stereo = *mode;
    channel.fixedViewer = table.flag("fixed_viewer", channel.fixedViewer);
    channel.lateralOffset = table.number("lateral_offset", channel.lateralOffset);
    table.finish();
    return channel;
}

} // namespace

std::string RigRecord::placeOf(std::string pointer) const
{
    while (!lines.contains(pointer) && !pointer.empty())
        pointer.resize(pointer.rfind('/') == pointer.npos ? 0 : pointer.rfind('/'));
    const auto line = lines.find(pointer);
    return fmt::format("{}:{}", file, line == lines.end() ? 1 : line->second);
}

Rig rigOfRecord(const RigRecord& record)
{
    RecordTable root(record, record.root, "");
    Rig rig;
    RecordTable general = root.table("rig"), scene = root.table("scene");
    rig.name = general.text("name", "");
    rig.near = general.number("near", rig.near);
    rig.far = general.distance("far", rig.far);
    rig.background = vec3f(general.vector("background", vec3d(0.0)));
    rig.notes = general.texts("notes");
    rig.sceneCenter = scene.vector("center", rig.sceneCenter);
    rig.sceneSize = scene.number("size", rig.sceneSize);
    if (root.has("rig"))
        general.finish();
    if (root.has("scene"))
        scene.finish();
    for (const RecordTable& table : root.tables("screen"))
        rig.screens.push_back(screenOf(table));
    for (const RecordTable& table : root.tables("viewer"))
        rig.viewers.push_back(viewerOf(table));
    if (rig.viewers.empty())
        rig.viewers.push_back({"viewer"});
    for (const RecordTable& table : root.tables("window"))
        rig.windows.push_back(windowOf(table));
    for (const RecordTable& table : root.tables("channel"))
        rig.channels.push_back(channelOf(table, rig));
    root.finish();
    if (rig.channels.empty())
        throw Error(record.placeOf(""), "expected at least one [[channel]], found none");
    return rig;
}

} // namespace brickwall
