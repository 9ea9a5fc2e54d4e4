// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/PreparedVolume.h"

#include "brickwall/core/base/FreeMemory.h"
#include "brickwall/core/base/Stopwatch.h"
#include "brickwall/core/io/DataStamp.h"
#include "brickwall/core/io/PreparedCache.h"
#include "brickwall/core/model/PadField.h"

#include <utility>

namespace brickwall {
namespace {

PreparedVolume make(const DataSet& data, const VolumeRequest& request, const Executor& executor, Progress& progress)
{
    PreparedVolume volume;
    const Stopwatch loading;
    volume.model = data.load(request.fields, executor, progress, request.nonFinite);
    volume.loadMilliseconds = loading.milliseconds();

    const Stopwatch preparing;
    Model& model = volume.model;
    if (request.pyramid)
        volume.pyramid = buildPyramid(model, {}, executor, progress);
    const auto regions = std::make_shared<RegionTree>(buildRegions(model.bricks, executor, progress));
    releaseFreeMemory();
    for (Field& field : model.fields) {
        Field known{field.name, field.unit, {}, field.range, field.preferredRange};
        volume.fields.push_back(
            std::make_shared<PaddedField>(padField(std::move(field), model.bricks, *regions, executor, progress)));
        field = std::move(known);
    }
    volume.regions = regions;
    volume.prepareMilliseconds = preparing.milliseconds();
    return volume;
}

} // namespace

std::size_t PreparedVolume::bytes() const
{
    std::size_t sum = regions->bytes();
    for (const auto& field : fields)
        sum += field->bytes();
    for (const PyramidMember& member : pyramid)
        sum += member.bytes();
    return sum;
}

PreparedVolume prepareVolume(const DataSet& data, const VolumeRequest& request, const VolumeCache& cache,
                             const Executor& executor, Progress& progress)
{
    const std::vector<std::string> files = cache.folder.empty() ? std::vector<std::string>() : data.files();
    const PreparedCache kept(cache, request, files);
    const Stopwatch reading;
    if (auto volume = kept.read(executor, progress)) {
        volume->loadMilliseconds = reading.milliseconds();
        return std::move(*volume);
    }
    const std::string before = timesOf(files);
    PreparedVolume volume = make(data, request, executor, progress);
    if (before.empty() || volume.model.cellCount < cache.leastCells)
        return volume;
    const std::string stamp = stampOf(files);
    if (!stamp.empty() && before == timesOf(files))
        kept.write(volume, stamp, executor, progress);
    return volume;
}

} // namespace brickwall
