// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/ReadAll.h"

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/VectorFields.h"
#include "brickwall/core/model/Regions.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

// Freed memory is kept from reuse to find what still uses it; libFuzzer counts it as used, though.
extern "C" const char* __asan_default_options()
{
    return "quarantine_size_mb=16:allocator_may_return_null=0:strict_string_checks=1";
}

namespace brickwall::fuzz {
namespace {

/// What is drawn from: the regions, and the values padded for them.
void prepare(const Model& model, const Executor& executor, Progress& progress)
{
    const RegionTree tree = buildRegions(model.bricks, executor, progress);
    for (const Field& field : model.fields)
        padField(field, model.bricks, tree, executor, progress);
}

} // namespace

void answered(const std::function<void()>& reading)
{
    try {
        reading();
    } catch (const Error& error) {
        const std::string_view line = error.what();
        if (line.empty() || line.find('\n') != std::string_view::npos) {
            std::fprintf(stderr, "expected one line, found: %s\n", error.what());
            std::abort();
        }
    }
}

void readAll(const std::string& data)
{
    constexpr std::size_t alone = 8; // that many fields suffice to see that they do not need each other
    const Executor executor(1);
    Progress silent;
    answered([&] {
        const auto set = openDataSet(data);
        const std::vector<std::string> names = set->fieldNames();
        findVectors(names);
        set->defaultField();
        for (std::size_t i = 0; i < std::min(alone, names.size()); ++i)
            answered([&] { set->load({&names[i], 1}, executor, silent, NonFinite::empty); });
        prepare(set->load(names, executor, silent), executor, silent);
    });
}

} // namespace brickwall::fuzz
