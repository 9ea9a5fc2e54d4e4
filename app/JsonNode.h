// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace brickwall {

/// An object of the file with its place, so that every message says where it is.
class JsonNode
{
public:
    JsonNode(const nlohmann::json& value, std::string place, std::initializer_list<const char*> keys)
        : value_(value), place_(std::move(place))
    {
        if (!value.is_object())
            throw Error(place_, fmt::format("expected an object, found {}", value.type_name()));
        const std::set<std::string> known(keys.begin(), keys.end());
        for (const auto& [key, unused] : value.items())
            if (!known.contains(key))
                throw Error(place_, fmt::format("unknown key \"{}\"; known: {}", key, fmt::join(known, ", ")));
    }

    const std::string& place() const { return place_; }
    bool has(const char* key) const { return value_.contains(key); }
    const nlohmann::json& at(const char* key) const
    {
        if (!has(key))
            throw Error(place_, fmt::format("\"{}\" is missing", key));
        return value_.at(key);
    }
    template <class T>
    T get(const char* key) const
    {
        try {
            return at(key).get<T>();
        } catch (const nlohmann::json::exception&) {
            throw Error(place_, fmt::format("\"{}\" has the wrong type, found {}", key, at(key).dump()));
        }
    }
    template <class T>
    void maybe(const char* key, T& target) const
    {
        if (has(key))
            target = get<T>(key);
    }
    void maybe(const char* key, std::optional<double>& target) const
    {
        if (has(key))
            target = get<double>(key);
    }

private:
    const nlohmann::json& value_;
    std::string place_;
};

} // namespace brickwall
