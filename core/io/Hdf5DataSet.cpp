// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Hdf5DataSet.h"

#include "brickwall/core/io/FieldNames.h"

#include <utility>

namespace brickwall {

Hdf5DataSet::Hdf5DataSet(Hdf5File file, std::vector<std::string> names)
    : file_(std::move(file)), names_(std::move(names))
{
}

Model Hdf5DataSet::load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
                        NonFinite nonFinite) const
{
    const std::string& place = file_.path();
    const auto wanted = fieldIndices(names_, fields, place);
    Layout layout = readLayout(executor, progress);
    std::vector<Field> read;
    for (const std::size_t i : wanted)
        read.push_back(readLeafField(layout.plan, names_[i], layout.open(i), nonFinite, executor, progress));
    return leafModel(std::move(layout.plan), std::move(read), layout.worldFromVoxel, place, nonFinite, executor,
                     progress);
}

} // namespace brickwall
