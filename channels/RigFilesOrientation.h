// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"

#include <glm/mat3x3.hpp>

namespace brickwall {

/// Orientations in display configurations are COVISE's heading, pitch and roll in degrees, R = Rz(h) Rx(p) Ry(r),
/// right-hand rule; multiples of 90 degrees are exact. The unrotated screen lies in the plane y = 0, its width along x,
/// its height along z, seen from -y.
glm::dmat3 rotationOf(const vec3d& headingPitchRoll);

/// The angles of a rotation, roll 0 where heading and roll turn about the same axis.
vec3d headingPitchRollOf(const glm::dmat3& rotation);

/// Sets the three corners.
void placeScreen(Screen& screen, const vec3d& center, double width, double height, const glm::dmat3& rotation);

/// Columns right, forward (away from the viewer), up of a screen; orthonormal if the screen is a rectangle.
glm::dmat3 rotationOf(const Screen& screen);
vec3d centerOf(const Screen& screen);
double widthOf(const Screen& screen);
double heightOf(const Screen& screen);
/// The cosine between the sides: 0 for a rectangle.
double skewOf(const Screen& screen);

/// The rectangle that a channel shows: its screen, or the part of it, as a screen of its own.
Screen screenOfChannel(const Rig& rig, const Channel& channel);

} // namespace brickwall
