// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Flight.h"
#include "JsonNode.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/WholeFile.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

using nlohmann::json;

double numberOf(const JsonNode& node, const char* key)
{
    if (!node.has(key) || !node.at(key).is_number())
        throw Error(node.place(), fmt::format("expected a number \"{}\"", key));
    return node.at(key).get<double>();
}

vec3d vectorOf(const JsonNode& node, const char* key)
{
    const json value = node.has(key) ? node.at(key) : json();
    if (!value.is_array() || value.size() != 3 ||
        !std::all_of(value.begin(), value.end(), [](const json& n) { return n.is_number(); }))
        throw Error(node.place(), fmt::format("expected three numbers \"{}\"", key));
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

FlightKey keyOf(const json& object, const std::string& place)
{
    const JsonNode node(object, place, {"time", "eye", "at", "up"});
    FlightKey key;
    key.time = numberOf(node, "time");
    key.eye = vectorOf(node, "eye");
    key.at = vectorOf(node, "at");
    if (node.has("up"))
        key.up = vectorOf(node, "up");
    return key;
}

void checkPose(const FlightKey& key, const std::string& place)
{
    if (!(glm::length(glm::cross(key.at - key.eye, key.up)) > 0.0))
        throw Error(place, "expected an eye that looks somewhere, and not along its up vector");
}

template <class Value>
Value hermite(const Value& a, const Value& b, const Value& slopeA, const Value& slopeB, double length, double u)
{
    const double v = 1.0 - u;
    return a * (v * v * (1.0 + 2.0 * u)) + b * (u * u * (1.0 + 2.0 * v)) +
           (slopeA * (u * v * v) - slopeB * (u * u * v)) * length;
}

/// The slope of the parabola's chord between the neighbours; at the ends that of the only one.
vec3d slopeAt(const std::vector<FlightKey>& keys, std::size_t i, vec3d FlightKey::*member)
{
    const std::size_t before = i > 0 ? i - 1 : i, after = std::min(i + 1, keys.size() - 1);
    return (keys[after].*member - keys[before].*member) / (keys[after].time - keys[before].time);
}

} // namespace

FlightKey Flight::at(double seconds) const
{
    const double time = keys.front().time + std::clamp(seconds, 0.0, this->seconds());
    const auto next = std::upper_bound(keys.begin() + 1, keys.end() - 1, time,
                                       [](double t, const FlightKey& key) { return t < key.time; });
    const std::size_t b = std::size_t(next - keys.begin()), a = b - 1;
    const double length = keys[b].time - keys[a].time, u = (time - keys[a].time) / length;
    const auto between = [&](vec3d FlightKey::*member) {
        return hermite(keys[a].*member, keys[b].*member, slopeAt(keys, a, member), slopeAt(keys, b, member), length, u);
    };
    return {time, between(&FlightKey::eye), between(&FlightKey::at), between(&FlightKey::up)};
}

mat4d roomFromWorldAt(const FlightKey& pose, const Rig& rig, const Box3d& bounds)
{
    const vec3d forward = glm::normalize(pose.at - pose.eye);
    const vec3d right = glm::normalize(glm::cross(forward, pose.up)), up = glm::cross(right, forward);
    const vec3d extent = bounds.extent();
    const double scale = rig.sceneSize / std::max({extent.x, extent.y, extent.z});
    mat4d turned(1.0);
    for (int c = 0; c < 3; ++c)
        turned[c] = glm::dvec4(right[c], forward[c], up[c], 0.0);
    const vec3d head = rig.viewers.empty() ? vec3d(0.0) : vec3d(rig.viewers.front().roomFromHead[3]);
    return glm::translate(mat4d(1.0), head) * glm::scale(mat4d(1.0), vec3d(scale)) * turned *
           glm::translate(mat4d(1.0), -pose.eye);
}

Flight readFlight(const std::string& path, const Box3d& bounds)
{
    json file;
    try {
        file = json::parse(readWholeFile(path));
    } catch (const json::exception& error) {
        throw Error(path, fmt::format("is no JSON: {}", error.what()));
    }
    const JsonNode node(file, path, {"units", "fov", "keys"});
    Flight flight;
    if (node.has("fov"))
        flight.fov = numberOf(node, "fov");
    if (!(flight.fov > 0.0 && flight.fov < 180.0))
        throw Error(path, fmt::format("expected a \"fov\" between 0 and 180 degrees, found {:g}", flight.fov));
    const json units = file.value("units", json("world"));
    if (units != "world" && units != "bounds")
        throw Error(path, fmt::format("expected \"units\" world or bounds, found {}", units.dump()));
    const json keys = file.value("keys", json());
    if (!keys.is_array() || keys.size() < 2)
        throw Error(path, "expected two or more \"keys\"");
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const std::string place = fmt::format("{}, key {}", path, i + 1);
        FlightKey key = keyOf(keys[i], place);
        if (units == "bounds") {
            key.eye = bounds.lower + key.eye * bounds.extent();
            key.at = bounds.lower + key.at * bounds.extent();
        }
        checkPose(key, place);
        if (i > 0 && !(key.time > flight.keys.back().time))
            throw Error(place, "expected a later \"time\" than that of the key before");
        flight.keys.push_back(key);
    }
    return flight;
}

} // namespace brickwall
