// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferFunctionFile.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/Srgb.h"
#include "brickwall/core/shade/TransferShapes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <optional>
#include <set>

namespace brickwall {
namespace {

using Json = nlohmann::json;

constexpr std::size_t xfCount = 128;

/// A `.xf` may begin with any byte, '{' included; but text has no control characters, and 128 floats always have.
bool looksLikeJson(std::string_view bytes)
{
    const auto isBlank = [](unsigned char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; };
    const auto first = std::find_if_not(bytes.begin(), bytes.end(), isBlank);
    return first != bytes.end() && *first == '{' &&
           std::all_of(bytes.begin(), bytes.end(), [&](unsigned char c) { return c >= 0x20 || isBlank(c); });
}

TransferFunction fromXf(const std::string& bytes, const std::string& path, const std::vector<ColorPoint>& colors,
                        const Range& range)
{
    if (bytes.size() != xfCount * sizeof(float))
        throw Error(path, fmt::format("expected a .xf of 512 bytes (128 float32 opacities) or a JSON object, found {} "
                                      "bytes",
                                      bytes.size()));
    TransferFunction tf;
    tf.range = range;
    tf.colors = colors;
    for (std::size_t i = 0; i < xfCount; ++i) {
        float value = 0.0f;
        std::memcpy(&value, bytes.data() + i * sizeof value, sizeof value);
        if (!(value >= 0.0f && value <= 1.0f))
            throw Error(path, fmt::format("byte {}: expected an opacity in [0, 1], found {}", i * sizeof value, value));
        tf.opacity.push_back({float(i) / float(xfCount - 1), value});
    }
    return tf;
}

Json parse(const std::string& text, const std::string& path)
{
    std::set<std::string> keys;
    const auto refuseDoubles = [&](int depth, Json::parse_event_t event, Json& value) {
        if (event == Json::parse_event_t::key && depth == 1 && !keys.insert(value.get<std::string>()).second)
            throw Error(path, fmt::format("'{}' is given twice", value.get<std::string>()));
        return true;
    };
    try {
        return Json::parse(text, refuseDoubles);
    } catch (const Json::parse_error& e) {
        const std::size_t end = std::min(text.size(), e.byte);
        const auto line = 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(end), '\n');
        std::string message = e.what();
        if (const auto at = message.find(": "); at != std::string::npos)
            message = message.substr(at + 2);
        throw Error(fmt::format("{}:{}", path, line), message);
    } catch (const Json::out_of_range& e) { // a number that no double holds
        throw Error(path, e.what());
    }
}

const Json& required(const Json& json, const char* key, const std::string& path)
{
    if (!json.contains(key))
        throw Error(path, fmt::format("expected a key '{}'", key));
    return json[key];
}

float numberOf(const Json& json, const std::string& place)
{
    if (!json.is_number())
        throw Error(place, fmt::format("expected a number, found {}", json.dump()));
    return float(json.get<double>());
}

std::vector<float> numbersOf(const Json& json, std::size_t count, const std::string& place)
{
    if (!json.is_array() || json.size() != count)
        throw Error(place, fmt::format("expected [{} numbers], found {}", count, json.dump()));
    std::vector<float> numbers;
    for (const Json& item : json)
        numbers.push_back(numberOf(item, place));
    return numbers;
}

template <class Use>
void eachPoint(const Json& json, std::size_t count, const std::string& place, Use use)
{
    if (!json.is_array())
        throw Error(place, fmt::format("expected a list of points, found {}", json.dump()));
    for (std::size_t i = 0; i < json.size(); ++i)
        use(numbersOf(json[i], count, fmt::format("{}[{}]", place, i)), fmt::format("{}[{}]", place, i));
}

float displayValue(float v, const std::string& place)
{
    if (!(v >= 0.0f && v <= 1.0f))
        throw Error(place, fmt::format("expected colour components in [0, 1], found {}", v));
    return linearFromSrgb(v);
}

std::vector<ColorPoint> colorsOf(const Json& json, const std::string& place)
{
    if (json.is_string()) {
        try {
            return colorMap(json.get<std::string>());
        } catch (const Error& e) {
            throw Error(place, e.what());
        }
    }
    std::vector<ColorPoint> colors;
    eachPoint(json, 4, place, [&](const std::vector<float>& v, const std::string& at) {
        colors.push_back({v[0], {displayValue(v[1], at), displayValue(v[2], at), displayValue(v[3], at)}});
    });
    return colors;
}

const char* nameOf(Scale scale)
{
    return scale == Scale::linear ? "linear" : "log";
}

Scale scaleOf(const Json& json, const std::string& place)
{
    if (json == "linear")
        return Scale::linear;
    if (json == "log")
        return Scale::logarithmic;
    throw Error(place, fmt::format("expected \"linear\" or \"log\", found {}", json.dump()));
}

void refuseUnknown(const Json& json, const std::string& path)
{
    static const std::set<std::string> known{"range",       "scale",          "colors",           "color_flat",
                                             "color_field", "color_range",    "color_scale",      "extinction",
                                             "opacity",     "opacity_window", "reference_length", "opacity_scale"};
    for (const auto& [key, value] : json.items())
        if (!known.contains(key))
            throw Error(path, fmt::format("unknown key '{}'; known are {}", key, fmt::join(known, ", ")));
}

/// An object of the file, with the place of each key for messages.
class Keys
{
public:
    Keys(const Json& json, const std::string& path) : json_(json), path_(path) {}

    bool has(const char* key) const { return json_.contains(key); }
    const Json& operator[](const char* key) const { return required(json_, key, path_); }
    std::string place(const char* key) const { return fmt::format("{}: {}", path_, key); }
    float number(const char* key) const { return numberOf((*this)[key], place(key)); }
    Range range(const char* key) const
    {
        const std::vector<float> ends = numbersOf((*this)[key], 2, place(key));
        return {ends[0], ends[1]};
    }
    /// Without another key this one means nothing.
    void belongs(const char* key, const char* other) const
    {
        if (has(key) && !has(other))
            throw Error(place(key), fmt::format("belongs to '{}', which is not there", other));
    }

private:
    const Json& json_;
    const std::string& path_;
};

void readColors(const Keys& keys, TransferFunction& tf)
{
    tf.colors = colorsOf(keys["colors"], keys.place("colors"));
    if (keys.has("color_flat")) {
        const float width = keys.number("color_flat");
        if (!(width >= 0.0f && width <= 1.0f))
            throw Error(keys.place("color_flat"), fmt::format("expected a width in [0, 1], found {}", width));
        TransferFunction checked; // points that are out of order would make none
        checked.colors = tf.colors;
        checked.opacity = {{0.0f, 0.0f}};
        checkTransferFunction(checked, keys.place("colors"));
        tf.colors = flatAround(tf.colors, width);
    }
    keys.belongs("color_range", "color_field");
    keys.belongs("color_scale", "color_field");
    if (!keys.has("color_field"))
        return;
    const Json& name = keys["color_field"];
    if (!name.is_string() || name.get<std::string>().empty())
        throw Error(keys.place("color_field"), fmt::format("expected the name of a field, found {}", name.dump()));
    tf.colorField = ColorField{name.get<std::string>(), keys.range("color_range"), Scale::linear};
    if (keys.has("color_scale"))
        tf.colorField->scale = scaleOf(keys["color_scale"], keys.place("color_scale"));
}

OpacityWindow windowOf(const Json& json, const std::string& place)
{
    if (!json.is_object())
        throw Error(place, fmt::format("expected an object, found {}", json.dump()));
    static const std::set<std::string> known{"center", "width", "opacity"};
    for (const auto& [key, value] : json.items())
        if (!known.contains(key))
            throw Error(place, fmt::format("unknown key '{}'; known are {}", key, fmt::join(known, ", ")));
    const Keys keys(json, place);
    OpacityWindow window{keys.number("center"), keys.number("width"), 1.0f};
    if (keys.has("opacity"))
        window.opacity = keys.number("opacity");
    if (!(window.width > 0.0))
        throw Error(keys.place("width"), fmt::format("expected a number above 0, found {}", window.width));
    if (!(window.opacity >= 0.0f && window.opacity <= 1.0f))
        throw Error(keys.place("opacity"), fmt::format("expected an opacity in [0, 1], found {}", window.opacity));
    return window;
}

/// Range, scale and one of the three ways to say how opaque.
void readOpacity(const Keys& keys, const std::string& path, TransferFunction& tf)
{
    if (keys.has("opacity") + keys.has("extinction") + keys.has("opacity_window") != 1)
        throw Error(path, "expected either 'opacity' or 'extinction' or 'opacity_window'");
    std::optional<OpacityWindow> window;
    if (keys.has("opacity_window"))
        window = windowOf(keys["opacity_window"], keys.place("opacity_window"));
    tf.range = window && !keys.has("range") ? rangeOf(*window) : keys.range("range");
    if (keys.has("scale"))
        tf.scale = scaleOf(keys["scale"], keys.place("scale"));
    tf.kind = keys.has("extinction") ? TransferFunction::Kind::extinction : TransferFunction::Kind::opacity;
    if (window) {
        tf.opacity = {{0.0f, 0.0f}}; // until the range is known to be one
        checkTransferFunction(tf, path);
        tf.opacity = opacityPoints(*window, tf.range, tf.scale);
        return;
    }
    const char* key = keys.has("opacity") ? "opacity" : "extinction";
    eachPoint(keys[key], 2, keys.place(key), [&](const std::vector<float>& v, const std::string&) {
        tf.opacity.push_back({v[0], v[1]});
    });
}

TransferFunction fromJson(const std::string& text, const std::string& path)
{
    const Json json = parse(text, path);
    refuseUnknown(json, path);
    const Keys keys(json, path);
    TransferFunction tf;
    readColors(keys, tf);
    readOpacity(keys, path, tf);
    if (keys.has("reference_length")) {
        if (tf.kind == TransferFunction::Kind::extinction)
            throw Error(keys.place("reference_length"), "belongs to 'opacity'; an extinction is per finest cell");
        tf.referenceLength = keys.number("reference_length");
    }
    if (keys.has("opacity_scale"))
        tf.opacityScale = keys.number("opacity_scale");
    return tf;
}

} // namespace

TransferFunction readTransferFunction(const std::string& path, const std::vector<ColorPoint>& xfColors,
                                      const Range& xfRange)
{
    const std::string bytes = readWholeFile(path);
    const TransferFunction tf = looksLikeJson(bytes) ? fromJson(bytes, path) : fromXf(bytes, path, xfColors, xfRange);
    checkTransferFunction(tf, path);
    return tf;
}

TransferFunction transferFunctionOf(const std::string& json, const std::string& place)
{
    const TransferFunction tf = fromJson(json, place);
    checkTransferFunction(tf, place);
    return tf;
}

void writeTransferFunction(const TransferFunction& tf, const std::string& path)
{
    checkTransferFunction(tf, path);
    writeWholeFile(path, toJson(tf));
}

std::string toJson(const TransferFunction& tf)
{
    const bool isOpacity = tf.kind == TransferFunction::Kind::opacity;
    std::string colors;
    for (const ColorPoint& p : tf.colors)
        colors += fmt::format("{}\n    [{}, {}, {}, {}]", colors.empty() ? "" : ",", p.t, srgbFromLinear(p.color.x),
                              srgbFromLinear(p.color.y), srgbFromLinear(p.color.z));
    std::string points;
    for (const OpacityPoint& p : tf.opacity)
        points += fmt::format("{}\n    [{}, {}]", points.empty() ? "" : ",", p.t, p.value);
    std::string text =
        fmt::format("{{\n  \"range\": [{}, {}],\n  \"scale\": \"{}\",\n", tf.range.lo, tf.range.hi, nameOf(tf.scale));
    if (tf.colorField)
        text += fmt::format("  \"color_field\": {},\n  \"color_range\": [{}, {}],\n  \"color_scale\": \"{}\",\n",
                            Json(tf.colorField->name).dump(-1, ' ', false, Json::error_handler_t::replace),
                            tf.colorField->range.lo, tf.colorField->range.hi, nameOf(tf.colorField->scale));
    text += fmt::format("  \"colors\": [{}\n  ],\n", colors);
    if (isOpacity)
        text += fmt::format("  \"reference_length\": {},\n", tf.referenceLength);
    text += fmt::format("  \"opacity_scale\": {},\n", tf.opacityScale);
    text += fmt::format("  \"{}\": [{}\n  ]\n}}\n", isOpacity ? "opacity" : "extinction", points);
    return text;
}

} // namespace brickwall
