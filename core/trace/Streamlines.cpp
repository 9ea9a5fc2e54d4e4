// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/Streamlines.h"

#include "brickwall/core/base/Error.h"

#include <glm/geometric.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

constexpr int stages = 7;

/// The coefficients of Dormand and Prince, "A family of embedded Runge-Kutta formulae", J. Comp. Appl. Math. 6 (1980).
/// The last stage is at the new point and serves as the first of the next step.
constexpr double a[stages][stages - 1] = {
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
};
/// Of order 5 less of order 4.
constexpr double errorWeights[stages] = {71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                         -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

/// A step that ends so near to the edge, in cells, is the last one.
constexpr double edgeDistance = 1e-3;

struct Step
{
    vec3d point;
    VectorSampler::Sample sample; ///< there
    double error;                 ///< estimate, world units
    double length;                ///< of the way there, of order 5, too
};

/// One line in one direction.
class Tracer
{
public:
    Tracer(const VectorSampler& vectors, double leastSpeed, double sign, const StreamlineConfig& config,
           VectorSampler::Memo& memo)
        : vectors_(vectors), leastSpeed_(leastSpeed), sign_(sign), config_(config), memo_(memo)
    {
    }

    /// Appends the points behind the seed.
    StreamlineEnd trace(vec3d point, VectorSampler::Sample sample, std::vector<vec3d>& points, const Progress& progress)
    {
        double length = 0.0, time = 0.0; // of the last step that was tried; 0: the longest
        for (int steps = 0; steps < config_.steps;) {
            progress.check();
            const double speed = glm::length(sample.value);
            if (!(speed > leastSpeed_))
                return StreamlineEnd::stagnation;
            double longest = config_.longestStep * sample.cellWidth / speed;
            if (config_.length > 0.0)
                longest = std::min(longest, (config_.length - length) / speed);
            time = time > 0.0 ? std::min(time, longest) : longest;
            const std::optional<Step> step = take(point, sample, time);
            if (!step) {
                if (time * speed < edgeDistance * sample.cellWidth)
                    return StreamlineEnd::edge;
                time *= 0.5;
                continue;
            }
            const double ratio = step->error / (config_.tolerance * sample.cellWidth);
            const double next = time * std::clamp(0.9 * std::pow(std::max(ratio, 1e-10), -0.2), 0.2, 5.0);
            const bool smallest = time * speed < 1e-6 * sample.cellWidth; // where vectors have a kink
            if (ratio > 1.0 && !smallest) {
                time = next;
                continue;
            }
            length += step->length;
            point = step->point;
            sample = step->sample;
            points.push_back(point);
            ++steps;
            time = next;
            if (config_.length > 0.0 && length >= config_.length * (1.0 - 1e-6))
                return StreamlineEnd::length;
        }
        return StreamlineEnd::steps;
    }

private:
    /// Nothing if a stage is outside of the data.
    std::optional<Step> take(const vec3d& point, const VectorSampler::Sample& first, double time) const
    {
        std::array<vec3d, stages> k;
        k[0] = sign_ * first.value;
        VectorSampler::Sample last = first;
        vec3d at = point;
        for (int stage = 1; stage < stages; ++stage) {
            at = point;
            for (int i = 0; i < stage; ++i)
                at += time * a[stage][i] * k[std::size_t(i)];
            const auto sample = vectors_.at(at, memo_);
            if (!sample)
                return {};
            last = *sample;
            k[std::size_t(stage)] = sign_ * sample->value;
        }
        vec3d error(0.0);
        for (std::size_t i = 0; i < stages; ++i)
            error += time * errorWeights[i] * k[i];
        double length = 0.0;
        for (std::size_t i = 0; i + 1 < stages; ++i)
            length += time * a[stages - 1][i] * glm::length(k[i]);
        return Step{at, last, glm::length(error), length};
    }

    const VectorSampler& vectors_;
    double leastSpeed_, sign_;
    const StreamlineConfig& config_;
    VectorSampler::Memo& memo_;
};

Streamline lineThrough(const vec3d& seed, const VectorSampler& vectors, double leastSpeed,
                       const StreamlineConfig& config, VectorSampler::Memo& memo, const Progress& progress)
{
    Streamline line;
    const auto sample = vectors.at(seed, memo);
    if (!sample)
        return line;
    if (config.backward) {
        line.begin = Tracer(vectors, leastSpeed, -1.0, config, memo).trace(seed, *sample, line.points, progress);
        std::reverse(line.points.begin(), line.points.end());
    }
    line.seed = line.points.size();
    line.points.push_back(seed);
    if (config.forward)
        line.end = Tracer(vectors, leastSpeed, 1.0, config, memo).trace(seed, *sample, line.points, progress);
    return line;
}

void check(const StreamlineConfig& config)
{
    if (!(config.tolerance > 0.0 && config.longestStep > 0.0 && config.length >= 0.0 && config.steps > 0 &&
          config.stagnation >= 0.0))
        throw Error("streamlines",
                    fmt::format("expected a tolerance, a longest step and a number of steps above 0, and a length that "
                                "is not negative, found {}, {}, {} and {}",
                                config.tolerance, config.longestStep, config.steps, config.length));
}

/// The digits of an index in a base, mirrored at the point.
double radicalInverse(int index, int base)
{
    double result = 0.0, place = 1.0 / base;
    for (; index > 0; index /= base, place /= base)
        result += place * (index % base);
    return result;
}

} // namespace

std::vector<Streamline> traceStreamlines(const VectorSampler& vectors, double largestSpeed,
                                         std::span<const vec3d> seeds, const StreamlineConfig& config,
                                         const Executor& executor, Progress& progress)
{
    check(config);
    std::vector<Streamline> lines(seeds.size());
    progress.begin("tracing streamlines", seeds.size());
    executor.forEach(seeds.size(), 1, [&](std::size_t begin, std::size_t end) {
        VectorSampler::Memo memo;
        for (std::size_t i = begin; i < end; ++i) {
            lines[i] = lineThrough(seeds[i], vectors, config.stagnation * largestSpeed, config, memo, progress);
            progress.advance(1);
        }
    });
    std::erase_if(lines, [](const Streamline& line) { return line.points.empty(); });
    progress.end();
    return lines;
}

std::vector<vec3d> scatteredSeeds(const Box3d& box, int count)
{
    std::vector<vec3d> seeds;
    for (int i = 1; i <= count; ++i)
        seeds.push_back(box.lower +
                        box.extent() * vec3d(radicalInverse(i, 2), radicalInverse(i, 3), radicalInverse(i, 5)));
    return seeds;
}

std::vector<vec3d> griddedSeeds(const Box3d& box, const vec3i& counts)
{
    std::vector<vec3d> seeds;
    for (int z = 0; z < counts.z; ++z)
        for (int y = 0; y < counts.y; ++y)
            for (int x = 0; x < counts.x; ++x)
                seeds.push_back(box.lower + box.extent() * ((vec3d(x, y, z) + 0.5) / vec3d(counts)));
    return seeds;
}

} // namespace brickwall
