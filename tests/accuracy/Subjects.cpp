// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Subjects.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/shade/DefaultTransferFunction.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <glm/ext/matrix_transform.hpp>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

namespace brickwall::test {
namespace {

const std::string sharedFolder = BRICKWALL_SOURCE_DIR "/../shared/data/";

/// Sheared by nothing, but turned and stretched differently along its axes, so that gradients need the metric.
mat4d turnedWorld()
{
    return glm::rotate(glm::scale(glm::translate(mat4d(1.0), vec3d(3.0, -20.0, 7.0)), vec3d(0.5, 0.7, 0.4)), 0.6,
                       vec3d(1.0, 2.0, -1.0));
}

/// A value per cell, in [-1, 1]: the worst that a field of that layout can do.
Model noise(std::vector<Brick> bricks, std::uint64_t seed)
{
    Model model = oracles::modelOf(
        std::move(bricks), [](const vec3d&) { return 0.0; }, turnedWorld());
    model.fields[0] = oracles::randomField(model.bricks, seed);
    return model;
}

Model oracle(const std::string& name)
{
    if (name == "jumps of 2 and 4, waves")
        return oracles::modelOf(oracles::randomLayout({.seed = 3, .rootBlocks{3, 3, 3}, .refined = 0.6}), waves,
                                turnedWorld());
    if (name == "jumps of 2 and 4, noise")
        return noise(oracles::randomLayout({.seed = 7, .refined = 0.6}), 8);
    if (name == "jumps of 4 and holes, noise")
        return noise(oracles::randomLayout({.seed = 11, .refined = 0.5, .jump = 1.0, .hole = 0.3}), 12);
    if (name == "nested levels, positive waves")
        return oracles::modelOf(oracles::nestedLevels(3, 4, 4), [](const vec3d& p) { return 3.0 + 2.0 * waves(p); });
    throw std::invalid_argument("no oracle " + name);
}

Model loaded(const DataSet& set)
{
    const Executor executor;
    Progress silent;
    return set.load(std::vector{set.defaultField()}, executor, silent);
}

/// Not there without the shared folder; no reader is a message, anything else that is wrong with a file a failure.
std::unique_ptr<DataSet> openFile(const std::string& name, std::string& missing)
{
    if (!std::filesystem::exists(sharedFolder + name)) {
        missing = "needs " + name + " in ../shared/data";
        return nullptr;
    }
    try {
        auto set = openDataSet(sharedFolder + name);
        if (set->fieldNames().empty())
            missing = name + " has no field";
        return set;
    } catch (const Error& error) {
        if (std::string(error.what()).find("of no format") == std::string::npos)
            throw;
        missing = "no reader for " + name;
        return nullptr;
    }
}

std::vector<float> shownOf(const Field& field, const TransferFunction& tf)
{
    std::vector<float> all, shown;
    for (const float v : field.values) {
        const double t = normalized(tf, v);
        if (t >= 0.0 && t <= 1.0)
            all.push_back(float(t));
        if (t > 0.05 && t < 0.95)
            shown.push_back(float(t));
    }
    if (shown.empty())
        shown = all;
    std::sort(shown.begin(), shown.end());
    return shown;
}

std::shared_ptr<const Subject> subjectOf(const std::string& name, const Model& model)
{
    const Executor executor;
    Progress silent;
    const Field& field = model.fields.front();
    auto subject = std::make_shared<Subject>();
    auto regions = std::make_shared<RegionTree>(buildRegions(model.bricks, executor, silent));
    subject->field = std::make_shared<PaddedField>(padField(field, model.bricks, *regions, executor, silent));
    subject->regions = regions;
    subject->name = name;
    subject->bounds = worldBounds(model);
    subject->worldFromVoxel = model.worldFromVoxel;
    subject->range = field.range;
    subject->standard = chooseTransferFunction(model, field).tf;
    subject->shown = shownOf(field, subject->standard);
    return subject;
}

} // namespace

float Subject::quantile(double share) const
{
    return shown.empty() ? 0.5f : shown[std::size_t(share * double(shown.size() - 1))];
}

std::vector<std::string> oracleNames()
{
    return {"jumps of 2 and 4, waves", "jumps of 2 and 4, noise", "jumps of 4 and holes, noise",
            "nested levels, positive waves"};
}

std::vector<std::string> sampleNames()
{
    return {"sample:wake:60k", "sample:cloud:60k", "sample:impact:60k"};
}

std::shared_ptr<const Subject> subjectNamed(const std::string& name, std::string& missing)
{
    static std::shared_ptr<const Subject> last;
    if (last && last->name == name)
        return last;
    last = nullptr;
    const auto oracles = oracleNames();
    if (std::ranges::find(oracles, name) != oracles.end()) {
        last = subjectOf(name, oracle(name));
    } else if (name.starts_with("sample:")) {
        last = subjectOf(name, loaded(*openDataSet(name)));
    } else if (const auto set = openFile(name, missing); missing.empty()) {
        last = subjectOf(name, loaded(*set));
    }
    return last;
}

} // namespace brickwall::test
