// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"
#include "brickwall/core/base/Box.h"

#include <vector>

namespace brickwall {

/// Where the data and the heads are, as moved by the user. All movements are given in the room (metres, radians).
class RigNavigation
{
public:
    /// Starts with the data where worldFromRoom(rig, ...) puts them and the heads as configured.
    RigNavigation(const Rig& rig, const Box3d& worldBounds);

    /// About the centre of the data.
    void rotateData(const vec3d& axis, double angle);
    void scaleData(double factor);
    void translateData(const vec3d& distance);
    /// To a place of its own, from wherever they are.
    void placeData(const mat4d& roomFromWorld);

    /// All tracked heads at once; turning is about each head's own origin and axes (x right, y forward, z up).
    void moveHeads(const vec3d& distance);
    void turnHeads(double toTheLeft, double upwards);

    void reset();

    mat4d worldFromRoom() const;
    mat4d roomFromWorld() const { return movedFromRoom_ * startRoomFromWorld_; }
    const std::vector<mat4d>& roomFromHeads() const { return roomFromHeads_; }

    /// Counts the changes, so that whoever renders sees that something is new.
    unsigned stamp() const { return stamp_; }

private:
    void moveData(const mat4d& movement);

    std::vector<mat4d> startHeads_;
    mat4d startRoomFromWorld_;
    vec3d startCenter_; ///< of the data, in the room
    mat4d movedFromRoom_{1.0};
    std::vector<mat4d> roomFromHeads_;
    unsigned stamp_ = 0;
};

} // namespace brickwall
