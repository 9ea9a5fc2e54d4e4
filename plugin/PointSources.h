// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace brickwall {

/// Sizes are rounded up, since GL rounds to the nearest, which would leave cracks.
inline constexpr const char* pointVertex = R"(
uniform int brickwallReach;
varying vec4 color;

float sizeTo(vec2 window, vec2 p, float depth)
{
    if (brickwallReach == 2) {
        if (colorOf(p) == vec4(0.0))
            return 0.0;
        depth = depthOf(p);
    }
    vec4 clip = clipOf(p, depth);
    return distance(window, 0.5 * brickwallViewport * clip.xy / clip.w);
}

float sizeAt(vec4 clip, float depth)
{
    vec2 pixelInWindow = brickwallViewport / brickwallSize;
    float least = max(1.0, max(pixelInWindow.x, pixelInWindow.y));
    if (brickwallReach == 0)
        return least;
    vec2 window = 0.5 * brickwallViewport * clip.xy / clip.w;
    float size = max(max(sizeTo(window, pixel + vec2(1.0, 0.0), depth), sizeTo(window, pixel - vec2(1.0, 0.0), depth)),
                     max(sizeTo(window, pixel + vec2(0.0, 1.0), depth), sizeTo(window, pixel - vec2(0.0, 1.0), depth)));
    return clamp(size, least, 3.0 * least);
}

void main()
{
    color = colorOf(pixel);
    bool onEdge = any(equal(fract(pixel), vec2(0.0)));
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    gl_PointSize = 1.0;
    if (onEdge || color == vec4(0.0))
        return;
    float depth = depthOf(pixel);
    vec4 clip = clipOf(pixel, depth);
    gl_Position = betweenPlanes(clip);
    gl_PointSize = ceil(sizeAt(clip, depth) - 0.002);
}
)";

inline constexpr const char* pointFragment = R"(
varying vec4 color;

void main()
{
    leave(color, gl_FragCoord.z);
}
)";

} // namespace brickwall
