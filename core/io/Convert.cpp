// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Convert.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/Writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

namespace brickwall {
namespace {

const TargetFormat& targetOf(const std::string& destination)
{
    const std::string extension = extensionOf(destination);
    for (const TargetFormat& target : targetFormats())
        if (target.extension == extension)
            return target;
    std::string known;
    for (const TargetFormat& target : targetFormats())
        known += fmt::format("{}{} ({})", known.empty() ? "" : ", ", target.extension, target.name);
    throw Error(destination, fmt::format("expected a file that ends in one of {}", known));
}

bool sameBricks(const std::vector<Brick>& a, const std::vector<Brick>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Brick& x, const Brick& y) {
        return x.lower == y.lower && x.size == y.size && x.level == y.level;
    });
}

/// One conversion: what is known once the first field has been read.
class Conversion
{
public:
    Conversion(const DataSet& source, const std::string& destination, const ConvertOptions& options,
               const Executor& executor, Progress& progress)
        : source_(source),
          destination_(destination),
          options_(options),
          executor_(executor),
          progress_(progress),
          files_(options.overwrite),
          names_(options.fields.empty() ? source.fieldNames() : options.fields)
    {
        files_.checkReplaceable(destination, false);
        for (std::size_t i = 0; i < names_.size(); ++i)
            if (std::find(names_.begin(), names_.begin() + std::ptrdiff_t(i), names_[i]) !=
                names_.begin() + std::ptrdiff_t(i))
                throw Error(destination, fmt::format("expected each field once, found '{}' twice", names_[i]));
    }

    void run()
    {
        if (auto streamed = source_.stream(names_, executor_, progress_))
            add(std::move(streamed->model), streamed->values);
        else
            load();
        progress_.begin("finishing", 0);
        writer_->finish();
        progress_.check();
        files_.commit();
        progress_.end();
    }

private:
    void load()
    {
        const std::size_t atOnce = options_.nonFinite == NonFinite::empty ? std::max<std::size_t>(names_.size(), 1) : 1;
        std::size_t done = 0;
        do {
            const auto batch = std::span(names_).subspan(done, std::min(atOnce, names_.size() - done));
            add(source_.load(batch, executor_, progress_, options_.nonFinite), {});
            done += batch.size();
        } while (done < names_.size());
    }

    /// `sources` are those of the fields' values, or none where the fields have them.
    void add(Model model, std::span<const ValueSource> sources)
    {
        std::vector<Field> fields = std::move(model.fields);
        if (!writer_) {
            model_ = std::move(model);
            output_.emplace(Output{destination_, model_, cells_, names_, options_.compress});
            cells_ = selectCells(model_, options_.cells, destination_);
            writer_ = targetOf(destination_).make(*output_, files_, executor_, progress_);
        } else if (!sameBricks(model.bricks, model_.bricks)) {
            throw Error(destination_, fmt::format("field '{}' has other cells than '{}'; convert them one by one",
                                                  fields.front().name, names_.front()));
        }
        for (std::size_t f = 0; f < fields.size(); ++f) {
            const ValueSource source = sources.empty() ? ValueSource() : sources[f];
            writer_->write(SelectedValues(cells_, model_, fields[f], source), executor_, progress_);
            fields[f].values = {};
        }
    }

    const DataSet& source_;
    const std::string& destination_;
    const ConvertOptions& options_;
    const Executor& executor_;
    Progress& progress_;
    OutputFiles files_; // outlives the writer: files are closed before they are removed
    std::vector<std::string> names_;
    Model model_; ///< without values
    CellSelection cells_;
    std::optional<Output> output_;
    std::unique_ptr<Writer> writer_;
};

} // namespace

void convert(const DataSet& source, const std::string& destination, const ConvertOptions& options,
             const Executor& executor, Progress& progress)
{
    checkDestination(destination);
    Conversion(source, destination, options, executor, progress).run();
}

std::string targetExtensions()
{
    std::vector<std::string> extensions;
    for (const TargetFormat& target : targetFormats())
        extensions.push_back(target.extension);
    return fmt::format("{}", fmt::join(extensions, ", "));
}

void checkDestination(const std::string& destination)
{
    targetOf(destination);
    const std::filesystem::path folder = std::filesystem::path(destination).parent_path();
    std::error_code none;
    if (!folder.empty() && !std::filesystem::is_directory(folder, none))
        throw Error(destination, fmt::format("expected a folder {}, found none", folder.string()));
}

} // namespace brickwall
