// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/scene/StreamlineTubes.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/VectorFields.h"
#include "brickwall/core/trace/Streamlines.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace brickwall {
namespace {

constexpr int mostSeeds = 1000000;

/// Seeds as they were asked for; the data's box stands for one that was not given.
struct SeedText
{
    std::vector<int> counts; ///< one: scattered; three: a grid
    std::optional<Box3d> box;
};

template <class Number>
std::vector<Number> numbersOf(std::string_view text, char separator)
{
    std::vector<Number> numbers;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(separator, at), text.size());
        Number number{};
        const auto [stop, error] = std::from_chars(text.data() + at, text.data() + end, number);
        if (error != std::errc() || stop != text.data() + end)
            return {};
        numbers.push_back(number);
        at = end + 1;
    }
    return numbers;
}

SeedText parseSeeds(const std::string& text, const std::string& place)
{
    const auto fail = [&](std::string_view expected) {
        throw Error(place, fmt::format("expected {}, found \"{}\"", expected, text));
    };
    const std::size_t colon = std::min(text.find(':'), text.size());
    SeedText seeds{numbersOf<int>(std::string_view(text).substr(0, colon), 'x'), {}};
    if (seeds.counts.size() != 1 && seeds.counts.size() != 3)
        fail("COUNT or NXxNYxNZ, and maybe :x0,y0,z0,x1,y1,z1");
    double product = 1.0;
    for (const int count : seeds.counts)
        product *= count > 0 ? count : mostSeeds + 1.0;
    if (product > mostSeeds)
        fail(fmt::format("1 to {} seeds", mostSeeds));
    if (colon == text.size())
        return seeds;
    const auto corners = numbersOf<double>(std::string_view(text).substr(colon + 1), ',');
    if (corners.size() != 6)
        fail("six numbers x0,y0,z0,x1,y1,z1 behind the colon");
    seeds.box = Box3d{{corners[0], corners[1], corners[2]}, {corners[3], corners[4], corners[5]}};
    for (int axis = 0; axis < 3; ++axis)
        if (!(seeds.box->lower[axis] <= seeds.box->upper[axis]) || !std::isfinite(seeds.box->extent()[axis]))
            fail("a box with its lower corner first");
    return seeds;
}

VectorFields vectorOf(const SceneOptions& options, const DataSet& data)
{
    const std::string& name = options.streamlineVector;
    const auto vectors = findVectors(data.fieldNames());
    if (vectors.empty())
        throw Error("--streamlines", fmt::format("{} has no vector: no three fields with names such as velx vely velz "
                                                 "or u v w",
                                                 options.data));
    const auto found = name.empty() ? vectors.begin() : std::ranges::find(vectors, name, &VectorFields::name);
    if (found != vectors.end())
        return *found;
    std::vector<std::string> names;
    for (const VectorFields& vector : vectors)
        names.push_back(vector.name);
    throw Error("--streamline-vector",
                fmt::format("there is no vector '{}' (those there are: {})", name, fmt::join(names, ", ")));
}

double largestLength(const Model& model)
{
    double most = 0.0;
    for (std::uint64_t i = 0; i < model.cellCount; ++i)
        most = std::max(
            most, glm::length(vec3d(model.fields[0].values[i], model.fields[1].values[i], model.fields[2].values[i])));
    return most;
}

std::vector<vec3d> seedsOf(const SceneOptions& options, const Box3d& bounds)
{
    std::vector<vec3d> seeds;
    for (const std::string& text : options.streamlines) {
        const SeedText parsed = parseSeeds(text, "--streamlines");
        const Box3d box = parsed.box.value_or(bounds);
        const auto more = parsed.counts.size() == 1
                              ? scatteredSeeds(box, parsed.counts[0])
                              : griddedSeeds(box, {parsed.counts[0], parsed.counts[1], parsed.counts[2]});
        seeds.insert(seeds.end(), more.begin(), more.end());
    }
    return seeds;
}

std::string describe(const std::vector<Streamline>& lines, std::size_t seeds, const std::string& vector)
{
    std::size_t points = 0;
    std::array<std::size_t, 4> ends{};
    for (const Streamline& line : lines) {
        points += line.points.size();
        ++ends[std::size_t(line.begin)];
        ++ends[std::size_t(line.end)];
    }
    return fmt::format(
        "--streamlines: {} lines of {} for {} seeds, {} points; {} ends at the edge of the data or a hole, "
        "{} where nothing moves, {} at the longest length, {} at the most steps",
        lines.size(), vector, seeds, points, ends[0], ends[1], ends[2], ends[3]);
}

} // namespace

void checkStreamlines(const SceneOptions& options, const PlaceOfOption& placeOf)
{
    for (const std::string& text : options.streamlines)
        parseSeeds(text, placeOf("streamlines"));
    const auto positive = [&](std::string_view key, double value) {
        if (!(value >= 0.0 && std::isfinite(static_cast<float>(value))))
            throw Error(placeOf(key), fmt::format("expected a finite number above 0, found {}", value));
    };
    positive("streamline_length", options.streamlineLength);
    positive("streamline_radius", options.streamlineRadius);
    const auto belongs = [&](std::string_view key, bool given) {
        if (given && options.streamlines.empty())
            throw Error(placeOf(key), fmt::format("has no effect without {}", placeOf("streamlines")));
    };
    belongs("streamline_vector", !options.streamlineVector.empty());
    belongs("streamline_length", options.streamlineLength > 0.0);
    belongs("streamline_radius", options.streamlineRadius > 0.0);
}

std::vector<TriangleMesh> streamlineTubes(const SceneOptions& options, const DataSet& data, const Executor& executor,
                                          Progress& progress)
{
    if (options.streamlines.empty())
        return {};
    const VectorFields vector = vectorOf(options, data);
    const Model model = data.load(vector.components, executor, progress, nonFiniteOf(options));
    const Box3d bounds = worldBounds(model);
    const double diagonal = glm::length(bounds.extent());
    StreamlineConfig config;
    config.length = options.streamlineLength > 0.0 ? options.streamlineLength : 2.0 * diagonal;
    const std::vector<vec3d> seeds = seedsOf(options, bounds);
    const auto lines =
        traceStreamlines(VectorSampler(model, {0, 1, 2}), largestLength(model), seeds, config, executor, progress);
    if (lines.empty())
        throw Error("--streamlines", fmt::format("none of {} seeds is in a cell; the data are in {},{},{},{},{},{}",
                                                 seeds.size(), bounds.lower.x, bounds.lower.y, bounds.lower.z,
                                                 bounds.upper.x, bounds.upper.y, bounds.upper.z));
    progress.note(describe(lines, seeds.size(), vector.name));
    constexpr int sides = 8;
    std::vector<TriangleMesh> meshes;
    meshes.push_back(
        tubesAround(lines, options.streamlineRadius > 0.0 ? options.streamlineRadius : diagonal / 1000.0, sides));
    return meshes;
}

} // namespace brickwall
