// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFilesRecord.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace brickwall {

/// One table of the record. Every key has to be asked for: `finish` throws at the first that nobody knows.
class RecordTable
{
public:
    using Json = nlohmann::ordered_json;

    RecordTable(const RigRecord& rigRecord, const Json& json, std::string jsonPointer)
        : record(rigRecord), value(json), pointer(std::move(jsonPointer))
    {
        if (!value.is_object())
            throw Error(record.placeOf(pointer),
                        fmt::format("{}: expected a table, found {}", pointer, value.type_name()));
    }

    bool has(const std::string& key)
    {
        known.insert(key);
        return value.contains(key);
    }

    [[noreturn]] void fail(const std::string& key, const std::string& message) const
    {
        throw Error(record.placeOf(key.empty() ? pointer : pointer + "/" + key),
                    key.empty() ? message : fmt::format("{}: {}", key, message));
    }

    std::string text(const std::string& key, const std::string& fallback)
    {
        if (!has(key))
            return fallback;
        if (!value[key].is_string())
            fail(key, "expected a text in quotes, found " + value[key].dump());
        return value[key];
    }

    bool flag(const std::string& key, bool fallback)
    {
        if (!has(key))
            return fallback;
        if (!value[key].is_boolean())
            fail(key, "expected true or false, found " + value[key].dump());
        return value[key];
    }

    double number(const std::string& key, double fallback) { return has(key) ? asNumber(key, value[key]) : fallback; }

    /// "inf" is an infinite distance; JSON has no number for it.
    double distance(const std::string& key, double fallback)
    {
        const bool infinite =
            has(key) && (value[key] == "inf" || value[key] == std::numeric_limits<double>::infinity());
        return infinite ? std::numeric_limits<double>::infinity() : number(key, fallback);
    }

    std::vector<double> numbers(const std::string& key, std::size_t count)
    {
        const Json& list = array(key, count);
        std::vector<double> all;
        for (const Json& item : list)
            all.push_back(asNumber(key, item));
        return all;
    }

    vec3d vector(const std::string& key)
    {
        const std::vector<double> v = numbers(key, 3);
        return {v[0], v[1], v[2]};
    }

    vec3d vector(const std::string& key, const vec3d& fallback) { return has(key) ? vector(key) : fallback; }

    std::vector<int> integers(const std::string& key, std::size_t count)
    {
        std::vector<int> all;
        for (const Json& item : array(key, count)) {
            if (!item.is_number_integer() || item < Json(-1000000) || item > Json(1000000))
                fail(key, "expected a whole number of pixels, found " + item.dump());
            all.push_back(item.get<int>());
        }
        return all;
    }

    mat4d matrix(const std::string& key)
    {
        mat4d m(1.0);
        const Json& rows = array(key, 4);
        for (int r = 0; r < 4; ++r) {
            if (!rows[r].is_array() || rows[r].size() != 4)
                fail(key, "expected four rows of four numbers");
            for (int c = 0; c < 4; ++c)
                m[c][r] = asNumber(key, rows[r][c]);
        }
        return m;
    }

    std::vector<std::string> texts(const std::string& key)
    {
        std::vector<std::string> all;
        if (!has(key))
            return all;
        if (!value[key].is_array())
            fail(key, "expected a list of texts");
        for (const Json& item : value[key]) {
            if (!item.is_string())
                fail(key, "expected a text in quotes, found " + item.dump());
            all.push_back(item);
        }
        return all;
    }

    /// The index of a thing that is given by name or number; the only one if the key is absent.
    template <typename Thing>
    int reference(const std::string& key, const std::vector<Thing>& things, int ifThereIsNone)
    {
        if (!has(key)) {
            if (things.size() > 1)
                fail("", fmt::format("expected {} = \"NAME\", because there are {} of them", key, things.size()));
            return things.empty() ? ifThereIsNone : 0;
        }
        const Json& item = value[key];
        if (item.is_number_integer() && item >= Json(ifThereIsNone) && item < Json(int(things.size())))
            return item.get<int>();
        std::vector<std::string> names;
        int found = -1, count = 0;
        for (std::size_t i = 0; i < things.size(); ++i) {
            names.push_back('"' + things[i].name + '"');
            if (item.is_string() && item == things[i].name)
                found = int(i), ++count;
        }
        if (count > 1)
            fail(key, fmt::format("{} of them are named {}; give the number, counted from 0", count, item.dump()));
        if (count == 0)
            fail(key, fmt::format("expected the name of a [[{}]] ({}), found {}", key,
                                  names.empty() ? "there is none" : enumerate(names), item.dump()));
        return found;
    }

    void finish() const
    {
        for (const auto& [key, unused] : value.items())
            if (!known.contains(key))
                throw Error(record.placeOf(pointer + "/" + key),
                            fmt::format("unknown key {}; expected {}", key,
                                        enumerate(std::vector<std::string>(known.begin(), known.end()))));
    }

    /// The tables of an array of tables, none if the key is absent.
    std::vector<RecordTable> tables(const std::string& key)
    {
        std::vector<RecordTable> all;
        if (!has(key))
            return all;
        if (!value[key].is_array())
            fail(key, fmt::format("expected [[{}]], a list of tables", key));
        for (std::size_t i = 0; i < value[key].size(); ++i)
            all.emplace_back(record, value[key][i], fmt::format("{}/{}/{}", pointer, key, i));
        return all;
    }

    RecordTable table(const std::string& key)
    {
        static const Json empty = Json::object();
        return has(key) ? RecordTable(record, value[key], pointer + "/" + key) : RecordTable(record, empty, pointer);
    }

private:
    const RigRecord& record;
    const Json& value;
    std::string pointer;
    std::set<std::string> known;

    double asNumber(const std::string& key, const Json& item) const
    {
        if (!item.is_number() || !std::isfinite(item.get<double>()))
            fail(key, "expected a number, found " + item.dump());
        return item;
    }

    const Json& array(const std::string& key, std::size_t count)
    {
        if (!has(key))
            fail("", fmt::format("{} is missing", key));
        if (!value[key].is_array() || value[key].size() != count)
            fail(key, fmt::format("expected {} numbers in brackets, found {}", count, value[key].dump()));
        return value[key];
    }
};

} // namespace brickwall
