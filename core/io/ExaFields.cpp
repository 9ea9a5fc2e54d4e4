// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ExaFields.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/LargeArray.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/ScalarsFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <set>
#include <utility>

namespace brickwall {
namespace {

constexpr std::size_t grain = 1 << 16;

/// Evaluates fields once each, as several may be used by one expression.
class Reader
{
public:
    Reader(std::span<const ExaField> all, const ExaGeometry& geometry, const Executor& executor, Progress& progress)
        : all_(all), geometry_(geometry), executor_(executor), progress_(progress)
    {
    }

    const std::vector<float>& values(std::size_t index)
    {
        for (const std::size_t i : missing(index)) {
            const ExaField& field = all_[i];
            done_[i] = field.expression          ? evaluate(field)
                       : field.files.size() == 3 ? magnitude(field)
                                                 : gatherFile(field, field.files[0]);
        }
        return done_.at(index);
    }

    /// The values, of which the reader keeps no copy.
    std::vector<float> take(std::size_t index)
    {
        values(index);
        return std::move(done_.extract(index).mapped());
    }

private:
    /// What has to be known for a field, itself the last, as expressions use fields before them. No recursion: hostile
    /// expressions may be a chain that no stack is deep enough for.
    std::set<std::size_t> missing(std::size_t index) const
    {
        std::set<std::size_t> found;
        std::vector<std::size_t> open{index};
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            if (done_.contains(i) || !found.insert(i).second || !all_[i].expression)
                continue;
            const auto used = all_[i].expression->fields();
            open.insert(open.end(), used.begin(), used.end());
        }
        return found;
    }

    std::vector<float> gatherFile(const ExaField& field, const std::string& path)
    {
        progress_.begin(fmt::format("reading {}", field.name), geometry_.cellCount);
        ScalarsFile scalars(path, progress_);
        std::vector<float> result = makeLargeArray(geometry_.cellCount, executor_);
        geometry_.forEachId(executor_, progress_, [&](std::uint64_t first, std::span<const std::uint32_t> ids) {
            for (std::size_t i = 0; i < ids.size(); ++i)
                if (ids[i] >= scalars.size())
                    throw Error(geometry_.place, fmt::format("cell ID {} of {} is outside {}, which has {} values",
                                                             static_cast<std::int32_t>(ids[i]),
                                                             geometry_.describe(first + i), path, scalars.size()));
            scalars.gather(ids, std::span(result).subspan(first, ids.size()));
        });
        progress_.end();
        return result;
    }

    std::vector<float> magnitude(const ExaField& field)
    {
        std::vector<float> result = gatherFile(field, field.files[0]);
        const std::vector<float> y = gatherFile(field, field.files[1]);
        const std::vector<float> z = gatherFile(field, field.files[2]);
        executor_.forEach(result.size(), grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const double a = result[i], b = y[i], c = z[i];
                result[i] = static_cast<float>(std::sqrt(a * a + b * b + c * c));
            }
        });
        return result;
    }

    std::vector<float> evaluate(const ExaField& field)
    {
        std::vector<const std::vector<float>*> inputs; // nodes of a map stay where they are
        for (const std::size_t used : field.expression->fields())
            inputs.push_back(&done_.at(used));
        progress_.begin(fmt::format("evaluating {}", field.name), geometry_.cellCount);
        std::vector<float> result(geometry_.cellCount);
        executor_.forEach(result.size(), grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; i += grain) {
                progress_.check();
                const std::size_t n = std::min(grain, end - i);
                std::vector<std::span<const float>> parts;
                for (const auto* input : inputs)
                    parts.push_back(std::span(*input).subspan(i, n));
                field.expression->evaluate(parts, std::span(result).subspan(i, n));
                progress_.advance(n);
            }
        });
        progress_.end();
        return result;
    }

    std::span<const ExaField> all_;
    const ExaGeometry& geometry_;
    const Executor& executor_;
    Progress& progress_;
    std::map<std::size_t, std::vector<float>> done_;
};

/// The range of the values. Throws Error for one that is not finite, if `nonFinite` says so.
Range rangeOfFinite(const ExaField& field, const std::vector<float>& values, const ExaGeometry& geometry,
                    NonFinite nonFinite, const Executor& executor)
{
    std::mutex mutex;
    Range range;
    std::uint64_t firstBad = values.size();
    executor.forEach(values.size(), grain, [&](std::size_t begin, std::size_t end) {
        const auto part = std::span(values).subspan(begin, end - begin);
        const auto bad = std::ranges::find_if(part, [](float v) { return !std::isfinite(v); });
        const Range partRange = rangeOf(part);
        const std::lock_guard lock(mutex);
        range.extend(partRange);
        if (bad != part.end())
            firstBad = std::min<std::uint64_t>(firstBad, begin + std::uint64_t(bad - part.begin()));
    });
    if (firstBad < values.size() && nonFinite == NonFinite::error)
        failNotFinite(values[firstBad], field.files.size() == 1 ? field.files[0] : field.place, field.name,
                      geometry.describe(firstBad));
    return range;
}

} // namespace

std::vector<Field> readExaFields(std::span<const ExaField> all, std::span<const std::size_t> wanted,
                                 const ExaGeometry& geometry, NonFinite nonFinite, const Executor& executor,
                                 Progress& progress)
{
    Reader reader(all, geometry, executor, progress);
    // Only expressions ask for a field again, and then a copy has to stay with the reader.
    const bool expressions =
        std::any_of(wanted.begin(), wanted.end(), [&](std::size_t i) { return all[i].expression.has_value(); });
    std::vector<Field> fields;
    for (const std::size_t index : wanted) {
        const ExaField& declared = all[index];
        Field field;
        field.name = declared.name;
        if (expressions) // not by a conditional operator, whose result is const here, and would be copied
            field.values = reader.values(index);
        else
            field.values = reader.take(index);
        field.range = rangeOfFinite(declared, field.values, geometry, nonFinite, executor);
        field.preferredRange = declared.preferredRange;
        fields.push_back(std::move(field));
    }
    return fields;
}

} // namespace brickwall
