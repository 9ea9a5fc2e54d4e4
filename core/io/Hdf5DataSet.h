// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/Hdf5File.h"
#include "brickwall/core/io/LeafFields.h"

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// What the data sets of HDF5 files have in common: a file, the names of its fields, and how those that are wanted are
/// loaded once it is known where their boxes lie.
class Hdf5DataSet : public DataSet
{
public:
    std::vector<std::string> fieldNames() const override { return names_; }
    std::string defaultField() const override { return usualField(names_); }
    std::vector<std::string> files() const override { return {file_.path()}; }
    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override;

protected:
    Hdf5DataSet(Hdf5File file, std::vector<std::string> names);

    /// Where the boxes lie, and how a field, by its index among the names, is read in them.
    struct Layout
    {
        LeafPlan plan;
        mat4d worldFromVoxel{1.0};
        std::function<OpenBox(std::size_t field)> open;
    };
    virtual Layout readLayout(const Executor& executor, Progress& progress) const = 0;

    const Hdf5File& file() const { return file_; }

private:
    Hdf5File file_;
    std::vector<std::string> names_;
};

} // namespace brickwall
