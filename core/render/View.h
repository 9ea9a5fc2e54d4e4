// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

#include <memory>
#include <string>
#include <vector>

namespace brickwall {

/// A rectangle of pixels, x to the right, y upwards, (0, 0) the lower-left pixel.
struct PixelRect
{
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;

    bool operator==(const PixelRect&) const = default;
};

/// What a scene that is drawn elsewhere has put on pixels of a view's screen, all of it opaque.
struct SceneDepth
{
    PixelRect window; ///< of the screen; at least the window of the view that it is for
    /// Window depth in [0, 1] by the view's clipFromWorld, for the pixels of `window`, row 0 at the bottom; 1: nothing
    /// there.
    std::vector<float> depth;
};

/// What is to be rendered: an eye, a screen in front of it, and the pixels wanted. World space, double.
///
/// The screen has `screenWidth` x `screenHeight` pixels in all; `window` says which of them this view renders, so that
/// tiles of one screen have exactly the rays of the whole (Kooima, "Generalized Perspective Projection", 2008, without
/// the matrix). The ray of pixel (x, y) of the screen starts at `eye` and goes through
///   lowerLeft + u (lowerRight - lowerLeft) + v (upperRight - lowerRight), u = (x + 1/2) / screenWidth, v likewise.
/// The view's frame has row 0 at the bottom.
struct View
{
    std::string name;
    vec3d eye{0.0};
    vec3d lowerLeft{0.0};
    vec3d lowerRight{0.0};
    vec3d upperRight{0.0};
    int screenWidth = 0;
    int screenHeight = 0;
    PixelRect window;
    /// For window depth alone, never for rays: clip = clipFromWorld * world. Of the whole screen.
    mat4d clipFromWorld{1.0};
    /// Rays end at this depth, as at a triangle, but nothing is drawn there: what the frame has of volume, surfaces and
    /// triangles is what lies in front, and its pixels belong over the scene's. The frame's depth is that of what is in
    /// it, never beyond the scene's. Null: the view is rendered for itself.
    std::shared_ptr<const SceneDepth> sceneDepth = nullptr;
};

/// Throws Error, naming the view, if its scene depth has not all pixels of its window; does nothing without one.
void checkSceneDepth(const View& view);

/// The distance of the eye from the screen's plane along its normal (right x up, towards the viewer); positive for an
/// eye in front, negative behind, and for the view of a host whose matrices mirror. World units.
double eyeDistance(const View& view);

/// The ray direction, not normalised: at parameter 1 it meets the screen's plane. (x, y) are pixels of the whole screen
/// (not of the window), whole numbers are pixel centres: the screen's corners are at -1/2 and at screenWidth - 1/2.
vec3d rayDirection(const View& view, double x, double y);

/// The view of a screen from an eye, its depth for near and far (far may be infinite). Throws Error, naming the view,
/// if the corners make no screen with an area, or the eye is on or behind it (nearer than 1e-9 of the screen's longer
/// side): such a view shows nothing, it is never mirrored. Two swapped corners are found by the same test. Also throws
/// for an image without pixels and unless 0 < near < far. Corners with no right angle are a parallelogram, and are
/// shown as one.
View viewOfScreen(std::string name, const vec3d& eye, const vec3d& lowerLeft, const vec3d& lowerRight,
                  const vec3d& upperRight, int width, int height, double near, double far);

/// The view that an OpenGL host draws with these matrices (clip = projection * modelview * world). Eye and corner
/// directions are recovered once, in double, from quantities that do not depend on near and far, an infinite far plane
/// and reversed z included. A point is in front of the eye if its w is positive. The corners lie in a plane w =
/// constant of no meaning of its own; matrices that mirror give a mirrored view, as the host draws it. Throws Error for
/// matrices that are no perspective projection (singular, orthographic, non-finite).
View viewOfMatrices(std::string name, const mat4d& modelview, const mat4d& projection, int width, int height);

/// The view of a pinhole camera that looks from `eye` at `at`, with the vertical opening angle in degrees.
View viewOfCamera(std::string name, const vec3d& eye, const vec3d& at, const vec3d& up, double fovDegrees, int width,
                  int height, double near, double far);

/// The part of a view, in pixels of its window: the rays are those of the whole, bit for bit. Throws Error for a tile
/// without pixels or not inside the window.
View tileOf(const View& view, const PixelRect& tile);

/// The modelview and projection (OpenGL, column-major) that draw what `viewOfScreen` describes, and throw where it
/// does. The modelview is rigid (right, up and normal of the screen become x, y, z; the eye the origin); the projection
/// is glFrustum's, and for corners with no right angle it has one more term, so that it still maps them to (+-1, +-1).
mat4d modelviewOfScreen(const vec3d& eye, const vec3d& lowerLeft, const vec3d& lowerRight, const vec3d& upperRight);
mat4d projectionOfScreen(const vec3d& eye, const vec3d& lowerLeft, const vec3d& lowerRight, const vec3d& upperRight,
                         double near, double far);

} // namespace brickwall
