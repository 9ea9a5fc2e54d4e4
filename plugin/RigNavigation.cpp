// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigNavigation.h"

#include <glm/gtc/matrix_transform.hpp>

namespace brickwall {

RigNavigation::RigNavigation(const Rig& rig, const Box3d& worldBounds)
    : startRoomFromWorld_(glm::inverse(brickwall::worldFromRoom(rig, worldBounds.lower, worldBounds.upper))),
      startCenter_(transformPoint(startRoomFromWorld_, (worldBounds.lower + worldBounds.upper) * 0.5))
{
    for (const Viewer& viewer : rig.viewers)
        startHeads_.push_back(viewer.roomFromHead);
    roomFromHeads_ = startHeads_;
}

void RigNavigation::moveData(const mat4d& movement)
{
    movedFromRoom_ = movement * movedFromRoom_;
    ++stamp_;
}

void RigNavigation::rotateData(const vec3d& axis, double angle)
{
    const vec3d center = transformPoint(movedFromRoom_, startCenter_);
    const mat4d there = glm::translate(mat4d(1.0), center);
    moveData(there * glm::rotate(mat4d(1.0), angle, axis) * glm::translate(mat4d(1.0), -center));
}

void RigNavigation::scaleData(double factor)
{
    const vec3d center = transformPoint(movedFromRoom_, startCenter_);
    const mat4d there = glm::translate(mat4d(1.0), center);
    moveData(there * glm::scale(mat4d(1.0), vec3d(factor)) * glm::translate(mat4d(1.0), -center));
}

void RigNavigation::translateData(const vec3d& distance)
{
    moveData(glm::translate(mat4d(1.0), distance));
}

void RigNavigation::placeData(const mat4d& roomFromWorld)
{
    movedFromRoom_ = roomFromWorld * glm::inverse(startRoomFromWorld_);
    ++stamp_;
}

void RigNavigation::moveHeads(const vec3d& distance)
{
    for (mat4d& head : roomFromHeads_)
        head = glm::translate(mat4d(1.0), distance) * head;
    ++stamp_;
}

void RigNavigation::turnHeads(double toTheLeft, double upwards)
{
    for (mat4d& head : roomFromHeads_) {
        head = glm::rotate(head, toTheLeft, vec3d(0, 0, 1));
        head = glm::rotate(head, upwards, vec3d(1, 0, 0));
    }
    ++stamp_;
}

void RigNavigation::reset()
{
    movedFromRoom_ = mat4d(1.0);
    roomFromHeads_ = startHeads_;
    ++stamp_;
}

mat4d RigNavigation::worldFromRoom() const
{
    return glm::inverse(roomFromWorld());
}

} // namespace brickwall
