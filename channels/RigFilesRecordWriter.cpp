// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigFilesOrientation.h"
#include "brickwall/channels/RigFilesRecord.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

using Json = nlohmann::ordered_json;

Json listOf(const vec3d& v)
{
    return Json::array({v.x, v.y, v.z});
}

Json listOf(const PixelRect& r)
{
    return Json::array({r.x, r.y, r.width, r.height});
}

/// The name where it is the only one of its kind, otherwise the number.
template <typename Thing>
Json referenceTo(const std::vector<Thing>& things, int index)
{
    if (index < 0)
        return index;
    const std::string& name = things[index].name;
    const auto count = std::count_if(things.begin(), things.end(), [&](const Thing& t) { return t.name == name; });
    return count == 1 && !name.empty() ? Json(name) : Json(index);
}

Json recordOf(const Screen& screen)
{
    Json table;
    table["name"] = screen.name;
    table["lower_left"] = listOf(screen.lowerLeft);
    table["lower_right"] = listOf(screen.lowerRight);
    table["upper_right"] = listOf(screen.upperRight);
    if (screen.pixelWidth || screen.pixelHeight)
        table["pixels"] = {screen.pixelWidth, screen.pixelHeight};
    return table;
}

Json rowsOf(const mat4d& m)
{
    Json rows = Json::array();
    for (int r = 0; r < 4; ++r)
        rows.push_back(Json::array({m[0][r], m[1][r], m[2][r], m[3][r]}));
    return rows;
}

/// Angles and a separation where they say exactly the same, otherwise the matrix and the points.
Json recordOf(const Viewer& viewer)
{
    Json table;
    table["name"] = viewer.name;
    const vec3d position(viewer.roomFromHead[3]);
    const vec3d angles = headingPitchRollOf(glm::dmat3(viewer.roomFromHead));
    mat4d said = mat4d(rotationOf(angles));
    said[3] = vec4d(position, 1.0);
    if (said == viewer.roomFromHead) {
        table["position"] = listOf(position);
        table["orientation"] = listOf(angles);
    } else {
        table["room_from_head"] = rowsOf(viewer.roomFromHead);
    }
    const double separation = 2.0 * viewer.rightEye.x;
    if (viewer.leftEye == vec3d(-separation / 2.0, 0.0, 0.0) && viewer.rightEye == vec3d(separation / 2.0, 0.0, 0.0)) {
        table["eye_separation"] = separation;
    } else {
        table["left_eye"] = listOf(viewer.leftEye);
        table["right_eye"] = listOf(viewer.rightEye);
    }
    return table;
}

Json recordOf(const Window& window)
{
    Json table;
    table["name"] = window.name;
    if (!window.display.empty())
        table["display"] = window.display;
    table["position"] = {window.x, window.y};
    table["size"] = {window.width, window.height};
    table["decoration"] = window.decoration;
    if (window.quadBuffer)
        table["quad_buffer"] = true;
    return table;
}

Json recordOf(const Rig& rig, const Channel& channel)
{
    Json table;
    table["name"] = channel.name;
    table["screen"] = referenceTo(rig.screens, channel.screen);
    table["viewer"] = referenceTo(rig.viewers, channel.viewer);
    table["window"] = referenceTo(rig.windows, channel.window);
    table["viewport"] = listOf(channel.viewport);
    if (channel.part != PixelRect())
        table["part"] = listOf(channel.part);
    table["stereo"] = toString(channel.stereo);
    if (channel.fixedViewer)
        table["fixed_viewer"] = true;
    if (channel.lateralOffset != 0.0)
        table["lateral_offset"] = channel.lateralOffset;
    return table;
}

} // namespace

nlohmann::ordered_json recordOfRig(const Rig& rig)
{
    Json root;
    Json& general = root["rig"];
    general["name"] = rig.name;
    general["near"] = rig.near;
    general["far"] = std::isinf(rig.far) ? Json("inf") : Json(rig.far);
    general["background"] = listOf(vec3d(rig.background));
    if (!rig.notes.empty())
        general["notes"] = rig.notes;
    root["scene"]["center"] = listOf(rig.sceneCenter);
    root["scene"]["size"] = rig.sceneSize;
    for (const char* list : {"screen", "viewer", "window", "channel"})
        root[list] = Json::array();
    for (const Screen& screen : rig.screens)
        root["screen"].push_back(recordOf(screen));
    for (const Viewer& viewer : rig.viewers)
        root["viewer"].push_back(recordOf(viewer));
    for (const Window& window : rig.windows)
        root["window"].push_back(recordOf(window));
    for (const Channel& channel : rig.channels)
        root["channel"].push_back(recordOf(rig, channel));
    return root;
}

} // namespace brickwall
