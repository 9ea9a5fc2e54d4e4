// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/ValueSource.h"
#include "brickwall/core/model/Model.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// What is done about a cell whose value is a NaN or infinite.
enum class NonFinite {
    error, ///< an Error that names file, field and cell
    empty, ///< there is no such cell: the data have a hole there, and the model's notes say how many
};

/// Data whose values are not in memory: the fields of the model have none (and no range), values[f] gives those of
/// field f. It lives no longer than its data set.
struct StreamedModel
{
    Model model;
    std::vector<ValueSource> values;
};

/// An opened data set: its fields are known by name, values are read when asked for.
class DataSet
{
public:
    virtual ~DataSet() = default;

    virtual std::string format() const = 0;                  ///< for people: "ExaBrick", "AMReX plotfile"
    virtual std::vector<std::string> fieldNames() const = 0; ///< in the file's order; may be empty (geometry alone)
    /// What is shown if nobody says what: the file's choice, or the first field.
    virtual std::string defaultField() const = 0;
    /// The bricks with the values of these fields, in this order. Throws Error for an unknown name (listing those there
    /// are), for anything broken in the files, and Cancelled. May be called several times, from one thread at a time.
    virtual Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
                       NonFinite nonFinite = NonFinite::error) const = 0;
    /// All files that what `load` yields depends on. None: it is not known what it depends on, or on no file.
    virtual std::vector<std::string> files() const { return {}; }
    /// The same without the values, all of which are finite, for data that can make or read them piece by piece;
    /// nothing for others, which have to be loaded. Throws as load does.
    virtual std::optional<StreamedModel> stream(std::span<const std::string> fields, const Executor& executor,
                                                Progress& progress) const
    {
        (void)fields;
        (void)executor;
        (void)progress;
        return std::nullopt;
    }
};

/// All regular files in a folder and below, in a fixed order; nothing where it cannot be read.
std::vector<std::string> filesBelow(const std::string& folder);

/// One format. Which reader answers is decided by what is in the file, not by its name.
///
/// A null result means "not mine"; "mine, but broken at ..." is an Error.
using OpenFunction = std::unique_ptr<DataSet> (*)(const std::string& data);

struct Format
{
    std::string name;
    std::string looksLike; ///< for the message that lists what can be read
    OpenFunction open;
    bool takesOptions = false; ///< what follows the file's name after a colon (DataName.h)
};

/// All formats, in the order in which they are asked.
std::span<const Format> formats();

/// `data` is a file, a folder, a file with options (DataName.h), or `sample:NAME[:SIZE]`. Throws Error if it does not
/// exist, is empty, or belongs to no format.
std::unique_ptr<DataSet> openDataSet(const std::string& data);

} // namespace brickwall
