// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace brickwall {

/// The ring of vertices is moved outwards by a margin, to continue the image's edge: a moved eye may look beyond it.
///
/// A pixel of the background beside others continues the nearest of them, so that the surface covers the outer half of
/// its pixels. The fragment shader leaves out what is nearest to a pixel of the background.
inline constexpr const char* meshVertex = R"(
uniform float brickwallMargin;
varying vec2 place;

float surfaceDepth()
{
    if (colorOf(pixel) != vec4(0.0))
        return depthOf(pixel);
    float nearest = 1.0;
    for (float y = -1.0; y < 1.5; y += 1.0) {
        for (float x = -1.0; x < 1.5; x += 1.0) {
            vec2 p = pixel + vec2(x, y);
            if (colorOf(p) != vec4(0.0))
                nearest = min(nearest, depthOf(p));
        }
    }
    return nearest;
}

void main()
{
    vec2 outwards = vec2(equal(pixel, brickwallSize)) - vec2(equal(pixel, vec2(0.0)));
    place = pixel + brickwallMargin * brickwallSize * outwards;
    gl_Position = betweenPlanes(clipOf(place, surfaceDepth()));
}
)";

/// What continues the edge is a guess; its depth is the farthest, so that it never hides what another view knows.
///
/// The sides of a pixel in the window are the columns of the inverse of the derivatives of `place`; their ratio needs
/// no determinant.
inline constexpr const char* meshFragment = R"(
uniform float brickwallLargestStretch;
varying vec2 place;

vec4 colorBetweenPixels()
{
    vec2 corner = floor(place - 0.5) + 0.5, part = place - corner;
    vec4 lower = mix(texture2D(brickwallColor, corner / brickwallSize),
                     texture2D(brickwallColor, (corner + vec2(1.0, 0.0)) / brickwallSize), part.x);
    vec4 upper = mix(texture2D(brickwallColor, (corner + vec2(0.0, 1.0)) / brickwallSize),
                     texture2D(brickwallColor, (corner + vec2(1.0, 1.0)) / brickwallSize), part.x);
    return mix(lower, upper, part.y);
}

void main()
{
    vec2 alongX = dFdx(place), alongY = dFdy(place);
    float width = length(vec2(alongX.y, alongY.y)), height = length(vec2(alongX.x, alongY.x));
    bool stretched = max(width, height) > brickwallLargestStretch * min(width, height);
    if (stretched || texture2D(brickwallColor, place / brickwallSize) == vec4(0.0))
        discard;
    bool beyondEdge = any(lessThan(place, vec2(0.0))) || any(greaterThan(place, brickwallSize));
    leave(colorBetweenPixels(), beyondEdge ? 1.0 : gl_FragCoord.z);
}
)";

} // namespace brickwall
