// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/Hdf5Data.h"
#include "brickwall/core/io/LeafFields.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// Where the values of a box lie in a dataset: those of its first plane, z = box.lower.z, and how the next planes
/// follow.
struct Hdf5BoxPlace
{
    Box3i box;                        ///< with ghost cells if there are any, in its level's indices
    std::vector<std::uint64_t> start; ///< of the first plane
    std::vector<std::uint64_t> count; ///< of one plane, whose elements are in the order x, y
    std::size_t zAxis = 0;            ///< the dataset's axis along which planes follow one another
    std::uint64_t step = 1;           ///< how many elements along this axis a plane has
};

/// Reads a box of a dataset plane by plane. The dataset has to outlive it.
class Hdf5Box : public BoxReader
{
public:
    Hdf5Box(const Hdf5Data& data, Hdf5BoxPlace where) : data_(data), where_(std::move(where)) {}

    std::string place() const override { return data_.place(); }
    Box3i box() const override { return where_.box; }
    void read(int zBegin, int zEnd, std::vector<double>& values) override
    {
        std::vector<std::uint64_t> start = where_.start, count = where_.count;
        start[where_.zAxis] += static_cast<std::uint64_t>(zBegin - where_.box.lower.z) * where_.step;
        count[where_.zAxis] = static_cast<std::uint64_t>(zEnd - zBegin) * where_.step;
        data_.read(start, count, values);
    }

private:
    const Hdf5Data& data_;
    Hdf5BoxPlace where_;
};

} // namespace brickwall
