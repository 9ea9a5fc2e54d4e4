// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/io/NumberType.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace brickwall {

/// A structured volume: where its numbers lie, x fastest, and what they mean.
struct VolumeFile
{
    std::string format;       ///< for people
    std::string place;        ///< the file that describes it, for messages
    std::string data;         ///< the file with the numbers; may be the same
    std::uint64_t offset = 0; ///< in `data`, of the numbers or of the gzip stream
    bool gzip = false;
    std::uint64_t skip = 0; ///< bytes to leave out at the beginning of what gzip holds
    vec3i size{0};
    NumberType type = NumberType::uint8;
    bool bigEndian = false;
    std::string field;
    std::string unit;
    mat4d worldFromVoxel{1.0};
    double threshold = 0.0; ///< see VolumeCells.h
};

/// Hands out the planes of a volume in order. For one thread.
class VolumePlanes
{
public:
    virtual ~VolumePlanes() = default;

    /// The values of the next plane, as float. Throws Error for a file that ends before.
    virtual void next(std::span<float> plane) = 0;
};

/// From the first plane.
std::unique_ptr<VolumePlanes> openPlanes(const VolumeFile& volume);

/// Throws Error, naming `place`, for a size without cells or beyond what can be shown, and for a data file that cannot
/// have as many numbers (gzip makes at most 1032 bytes of one).
void checkVolume(const VolumeFile& volume);

/// The number in [0, 1] of the option threshold=T; 0 without the text. Throws Error at `place`.
double parseThreshold(const std::string& text, const std::string& place);

/// One field; its cells are merged as the threshold says.
std::unique_ptr<DataSet> makeVolumeDataSet(VolumeFile volume);

} // namespace brickwall
