// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/Hdf5Call.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// A dataset of an HDF5 file: an array of `shape`, the last axis fastest. Its values are stored in the file itself, and
/// it is no larger than its stored bytes can be when they are expanded, so that a small hostile file asks no more than
/// little memory. Closing the file before is no harm. Threads: as Hdf5File.
class Hdf5Data
{
public:
    /// `dataset` is the identifier of an open dataset; `place` names file and dataset. Throws Error if its values are
    /// not in this file.
    Hdf5Data(Hdf5Id dataset, std::string place);

    const std::string& place() const { return place_; }
    const std::vector<std::uint64_t>& shape() const { return shape_; }
    std::uint64_t size() const; ///< the number of elements

    /// The elements from `start` on, `count` of them along each axis. Throws Error if they are no numbers or reach
    /// beyond the shape.
    void read(std::span<const std::uint64_t> start, std::span<const std::uint64_t> count,
              std::vector<double>& values) const;
    /// All elements.
    std::vector<double> numbers() const;
    std::vector<std::int64_t> integers() const;
    /// The named members, which are integers, of `count` elements of a list from `first` on, one element after the
    /// other. Integers of more than 32 bits become the nearest one of 32: most files have these, which then is fast.
    std::vector<std::int32_t> records(std::span<const std::string> members, std::uint64_t first,
                                      std::uint64_t count) const;
    /// Texts of fixed length, or that member of elements which are compounds; without padding at the end.
    std::vector<std::string> texts(const std::string& member = {}) const;

    /// Throws Error unless the shape is this; 0 stands for any extent.
    void expectShape(std::span<const std::uint64_t> shape) const;

private:
    void checkStorage() const;

    Hdf5Id dataset_;
    std::string place_;
    std::vector<std::uint64_t> shape_;
};

/// What it takes to read the named integer members of a compound: a compound of 32-bit ones. Throws Error at `place` if
/// `type`, an identifier, has them not.
Hdf5Id recordType(std::int64_t type, std::span<const std::string> members, const std::string& place);

/// "(2, 16, 16)".
std::string shapeText(std::span<const std::uint64_t> shape);

/// A text of fixed length up to its first zero, without blanks at the end.
std::string trimmedText(const char* text, std::size_t length);

} // namespace brickwall
