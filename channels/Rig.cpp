// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/Rig.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brickwall {

vec3d eyePoint(const Viewer& viewer, Eye eye, double lateralOffset)
{
    const vec3d middle = 0.5 * (viewer.leftEye + viewer.rightEye);
    const vec3d inHead = eye == Eye::left ? viewer.leftEye : eye == Eye::right ? viewer.rightEye : middle;
    return transformPoint(viewer.roomFromHead, inHead + vec3d(lateralOffset, 0.0, 0.0));
}

bool needsTwoEyes(StereoMode mode)
{
    return mode != StereoMode::mono && mode != StereoMode::left && mode != StereoMode::right;
}

std::string toString(StereoMode mode)
{
    switch (mode) {
    case StereoMode::mono:
        return "mono";
    case StereoMode::left:
        return "left";
    case StereoMode::right:
        return "right";
    case StereoMode::horizontalSplit:
        return "horizontal_split";
    case StereoMode::verticalSplit:
        return "vertical_split";
    case StereoMode::anaglyphic:
        return "anaglyphic";
    case StereoMode::quadBuffer:
        return "quad_buffer";
    case StereoMode::horizontalInterlace:
        return "horizontal_interlace";
    case StereoMode::verticalInterlace:
        return "vertical_interlace";
    case StereoMode::checkerboard:
        return "checkerboard";
    }
    return "unknown";
}

std::string toString(Eye eye)
{
    switch (eye) {
    case Eye::middle:
        return "middle";
    case Eye::left:
        return "left";
    case Eye::right:
        return "right";
    }
    return "unknown";
}

mat4d worldFromRoom(const Rig& rig, const vec3d& boundsLower, const vec3d& boundsUpper)
{
    const vec3d extent = boundsUpper - boundsLower;
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (!(longest > 0.0) || !std::isfinite(extent.x + extent.y + extent.z))
        throw Error(rig.name, fmt::format("expected data with an extent, found one of {:g} x {:g} x {:g}", extent.x,
                                          extent.y, extent.z));
    if (!(rig.sceneSize > 0.0) || !std::isfinite(rig.sceneSize))
        throw Error(rig.name, fmt::format("expected a scene size above 0 metres, found {:g}", rig.sceneSize));
    const double scale = longest / rig.sceneSize;
    // The room's x is the data's x, forward is -z, up is y.
    mat4d m(0.0);
    m[0] = {scale, 0.0, 0.0, 0.0};
    m[1] = {0.0, 0.0, -scale, 0.0};
    m[2] = {0.0, scale, 0.0, 0.0};
    m[3] = vec4d(0.5 * (boundsLower + boundsUpper) - transformVector(m, rig.sceneCenter), 1.0);
    return m;
}

} // namespace brickwall
