// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/View.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

namespace brickwall {
namespace {

/// An eye nearer to its screen than this part of the screen's longer side counts as on it: the rays would be mere
/// rounding.
constexpr double onScreen = 1e-9;
/// Below this sine two directions count as parallel.
constexpr double parallel = 1e-12;

std::string placeOf(const std::string& name)
{
    return name.empty() ? "view" : fmt::format("view '{}'", name);
}

bool allFinite(const mat4d& m)
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r]))
                return false;
    return true;
}

void checkSize(const std::string& place, int width, int height)
{
    if (width <= 0 || height <= 0)
        throw Error(place,
                    fmt::format("expected at least one pixel in width and height, found {} x {}", width, height));
}

void checkDepthRange(const std::string& place, double near, double far)
{
    if (!(near > 0.0) || !(far > near) || std::isinf(near))
        throw Error(place, fmt::format("expected 0 < near < far, found near = {:g} and far = {:g}", near, far));
}

/// A screen seen from an eye, in the screen's own orthonormal base. `skew` is how far the upper edge is shifted to the
/// right against the lower one: 0 for a rectangle.
struct SeenScreen
{
    vec3d right{0.0}, up{0.0}, normal{0.0};
    double width = 0.0, height = 0.0, skew = 0.0;
    double left = 0.0, bottom = 0.0; ///< of the lower-left corner, from the eye's foot on the screen
    double distance = 0.0;
};

/// Throws for what shows nothing: no area, an eye on or behind the screen.
SeenScreen seenScreen(const std::string& place, const vec3d& eye, const vec3d& lowerLeft, const vec3d& lowerRight,
                      const vec3d& upperRight)
{
    if (!isFinite(eye))
        throw Error(place, fmt::format("the eye ({:g}, {:g}, {:g}) is not finite", eye.x, eye.y, eye.z));
    const vec3d across = lowerRight - lowerLeft;
    const vec3d upwards = upperRight - lowerRight;
    const vec3d area = glm::cross(across, upwards);
    SeenScreen s;
    s.width = glm::length(across);
    if (!isFinite(lowerLeft) || !isFinite(area) || !(glm::length(area) > parallel * s.width * glm::length(upwards)))
        throw Error(place, "the corners make no screen: expected three finite points that are not on a line");
    s.right = across / s.width;
    s.normal = glm::normalize(area);
    s.up = glm::cross(s.normal, s.right);
    s.height = glm::dot(upwards, s.up);
    s.skew = glm::dot(upwards, s.right);
    const vec3d corner = lowerLeft - eye;
    s.left = glm::dot(corner, s.right);
    s.bottom = glm::dot(corner, s.up);
    s.distance = -glm::dot(corner, s.normal);
    if (!(s.distance > onScreen * std::max(s.width, s.height)))
        throw Error(
            place,
            fmt::format("the eye is on or behind the screen (distance {:g}, expected a positive one): nothing is "
                        "shown; move the eye in front, or look whether two corners are swapped",
                        s.distance));
    return s;
}

mat4d modelviewOf(const SeenScreen& s, const vec3d& eye)
{
    const glm::dmat3 rows = glm::transpose(glm::dmat3(s.right, s.up, s.normal));
    mat4d m(rows);
    m[3] = vec4d(-(rows * eye), 1.0);
    return m;
}

/// glFrustum's matrix, written with the screen itself instead of its image on the near plane, so that near and far
/// appear in the row of z only. A skewed screen has one more term.
mat4d projectionOf(const SeenScreen& s, double near, double far)
{
    mat4d m(0.0);
    m[0][0] = 2.0 * s.distance / s.width;
    m[1][0] = -2.0 * s.distance * s.skew / (s.width * s.height);
    m[2][0] = 1.0 + 2.0 * (s.left - s.bottom * s.skew / s.height) / s.width;
    m[1][1] = 2.0 * s.distance / s.height;
    m[2][1] = 1.0 + 2.0 * s.bottom / s.height;
    m[2][2] = std::isinf(far) ? -1.0 : -(far + near) / (far - near);
    m[3][2] = std::isinf(far) ? -2.0 * near : -2.0 * far * near / (far - near);
    m[2][3] = -1.0;
    return m;
}

vec4d row(const mat4d& m, int r)
{
    return {m[0][r], m[1][r], m[2][r], m[3][r]};
}

/// The rays of a perspective matrix: all points with x = y = w = 0 (the eye), and the direction to NDC (x, y) at w = 1,
/// which is forward + x across + y upwards. The row of z takes no part, hence neither do near and far.
struct Pencil
{
    vec3d eye{0.0}, forward{0.0}, across{0.0}, upwards{0.0};
};

Pencil pencilOf(const std::string& place, const mat4d& clipFromWorld)
{
    const vec4d x = row(clipFromWorld, 0), y = row(clipFromWorld, 1), w = row(clipFromWorld, 3);
    const double lengthX = glm::length(vec3d(x)), lengthY = glm::length(vec3d(y)), lengthW = glm::length(vec3d(w));
    if (!(lengthW > parallel * std::max(lengthX, lengthY)))
        throw Error(place, "expected a perspective projection, found one without an eye (orthographic, or all zero)");
    // Off-axis views have much of w in x and y; without it the three rows are well conditioned. It moves neither the
    // eye nor w.
    const double wx = glm::dot(vec3d(x), vec3d(w)) / (lengthW * lengthW);
    const double wy = glm::dot(vec3d(y), vec3d(w)) / (lengthW * lengthW);
    const vec4d px = x - wx * w, py = y - wy * w;
    const vec3d forward = vec3d(w) / lengthW;
    const double area = glm::dot(glm::cross(vec3d(px), vec3d(py)), forward);
    if (!(glm::length(vec3d(px)) > parallel * lengthX) || !(glm::length(vec3d(py)) > parallel * lengthY) ||
        !(std::abs(area) > parallel * glm::length(vec3d(px)) * glm::length(vec3d(py))))
        throw Error(place, "expected a perspective projection, found a singular matrix: the picture has no area");
    Pencil p;
    p.across = glm::cross(vec3d(py), forward) / area;
    p.upwards = glm::cross(forward, vec3d(px)) / area;
    const vec3d unitW = forward / lengthW;
    p.eye = -(w.w * unitW + px.w * p.across + py.w * p.upwards);
    p.forward = unitW - wx * p.across - wy * p.upwards;
    return p;
}

/// A row of z that is zero or a multiple of w gives every point the same depth.
void checkDepthRow(const std::string& place, const mat4d& clipFromWorld, const vec3d& eye)
{
    const vec4d z = row(clipFromWorld, 2);
    const double atEye = std::abs(glm::dot(vec3d(z), eye) + z.w);
    const double magnitude = glm::length(vec3d(z)) * glm::length(eye) + std::abs(z.w);
    if (!(atEye > 2.0 * std::numeric_limits<double>::epsilon() * magnitude))
        throw Error(place,
                    "expected a perspective projection, found a singular matrix: all points have the same depth");
}

} // namespace

void checkSceneDepth(const View& view)
{
    if (!view.sceneDepth)
        return;
    const PixelRect &w = view.window, &d = view.sceneDepth->window;
    const auto end = [](int begin, int extent) { return std::int64_t(begin) + extent; };
    if (d.x > w.x || d.y > w.y || end(d.x, d.width) < end(w.x, w.width) || end(d.y, d.height) < end(w.y, w.height))
        throw Error(placeOf(view.name),
                    fmt::format("expected a scene depth of its {} x {} pixels at ({}, {}), found {} x {} at ({}, {})",
                                w.width, w.height, w.x, w.y, d.width, d.height, d.x, d.y));
    const std::size_t pixels = std::size_t(d.width) * std::size_t(d.height);
    if (view.sceneDepth->depth.size() != pixels)
        throw Error(placeOf(view.name), fmt::format("expected a scene depth of {} values, found {}", pixels,
                                                    view.sceneDepth->depth.size()));
}

double eyeDistance(const View& view)
{
    const vec3d area = glm::cross(view.lowerRight - view.lowerLeft, view.upperRight - view.lowerRight);
    return glm::dot(view.eye - view.lowerLeft, area) / glm::length(area);
}

vec3d rayDirection(const View& view, double x, double y)
{
    const double u = (x + 0.5) / view.screenWidth;
    const double v = (y + 0.5) / view.screenHeight;
    // Eye first: the corner's offset is exact where eye and screen are near to each other and far from the origin.
    return (view.lowerLeft - view.eye) + u * (view.lowerRight - view.lowerLeft) +
           v * (view.upperRight - view.lowerRight);
}

View viewOfScreen(std::string name, const vec3d& eye, const vec3d& lowerLeft, const vec3d& lowerRight,
                  const vec3d& upperRight, int width, int height, double near, double far)
{
    const std::string place = placeOf(name);
    checkSize(place, width, height);
    checkDepthRange(place, near, far);
    const SeenScreen seen = seenScreen(place, eye, lowerLeft, lowerRight, upperRight);
    const mat4d clipFromWorld = projectionOf(seen, near, far) * modelviewOf(seen, eye);
    return {std::move(name),       eye,          lowerLeft, lowerRight, upperRight, width, height,
            {0, 0, width, height}, clipFromWorld};
}

View viewOfMatrices(std::string name, const mat4d& modelview, const mat4d& projection, int width, int height)
{
    const std::string place = placeOf(name);
    checkSize(place, width, height);
    const mat4d clipFromWorld = projection * modelview;
    if (!allFinite(modelview) || !allFinite(projection) || !allFinite(clipFromWorld))
        throw Error(place, "expected a perspective projection, found matrices with numbers that are not finite");
    const Pencil p = pencilOf(place, clipFromWorld);
    checkDepthRow(place, clipFromWorld, p.eye);
    // Any plane w = constant will do. One as far from the eye as the eye is from the origin loses no digits in the
    // corners.
    const double scale = std::max(1.0, glm::length(p.eye) / glm::length(p.forward));
    const auto corner = [&](double x, double y) { return p.eye + scale * (p.forward + x * p.across + y * p.upwards); };
    return {std::move(name), p.eye,  corner(-1.0, -1.0),    corner(1.0, -1.0), corner(1.0, 1.0),
            width,           height, {0, 0, width, height}, clipFromWorld};
}

View viewOfCamera(std::string name, const vec3d& eye, const vec3d& at, const vec3d& up, double fovDegrees, int width,
                  int height, double near, double far)
{
    const std::string place = placeOf(name);
    checkSize(place, width, height);
    if (!(fovDegrees > 0.0 && fovDegrees < 180.0))
        throw Error(place, fmt::format("expected an opening angle between 0 and 180 degrees, found {:g}", fovDegrees));
    const vec3d forward = at - eye;
    const double distance = glm::length(forward);
    const vec3d side = glm::cross(forward, up);
    if (!isFinite(eye) || !isFinite(side) || !(glm::length(side) > parallel * distance * glm::length(up)))
        throw Error(place,
                    "expected a point to look at that is not the eye, and an up direction across the line of sight");
    const vec3d right = glm::normalize(side);
    const double halfHeight = distance * std::tan(fovDegrees * std::numbers::pi / 360.0);
    const vec3d halfRight = halfHeight * width / height * right;
    const vec3d halfUp = halfHeight * glm::normalize(glm::cross(right, forward));
    return viewOfScreen(std::move(name), eye, at - halfRight - halfUp, at + halfRight - halfUp, at + halfRight + halfUp,
                        width, height, near, far);
}

View tileOf(const View& view, const PixelRect& tile)
{
    const PixelRect& whole = view.window;
    if (tile.x < 0 || tile.y < 0 || tile.width <= 0 || tile.height <= 0 ||
        std::int64_t(tile.x) + tile.width > whole.width || std::int64_t(tile.y) + tile.height > whole.height)
        throw Error(placeOf(view.name),
                    fmt::format("the tile {} x {} at ({}, {}) is not inside the {} x {} pixels of the view", tile.width,
                                tile.height, tile.x, tile.y, whole.width, whole.height));
    View part = view;
    part.window = {whole.x + tile.x, whole.y + tile.y, tile.width, tile.height};
    return part;
}

mat4d modelviewOfScreen(const vec3d& eye, const vec3d& lowerLeft, const vec3d& lowerRight, const vec3d& upperRight)
{
    return modelviewOf(seenScreen("screen", eye, lowerLeft, lowerRight, upperRight), eye);
}

mat4d projectionOfScreen(const vec3d& eye, const vec3d& lowerLeft, const vec3d& lowerRight, const vec3d& upperRight,
                         double near, double far)
{
    checkDepthRange("screen", near, far);
    return projectionOf(seenScreen("screen", eye, lowerLeft, lowerRight, upperRight), near, far);
}

} // namespace brickwall
