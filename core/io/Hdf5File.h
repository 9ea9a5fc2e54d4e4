// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/Hdf5Call.h"
#include "brickwall/core/io/Hdf5Data.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// Whether a file begins as HDF5 does (behind a user block of up to 2048 bytes, if there is one).
bool looksLikeHdf5(const std::string& path);

/// An HDF5 file that is read. Objects are named by their path, "level_0/boxes", "" being the root.
///
/// Only hard links are followed: a soft link may lead in a circle and an external one out of the file, so that either
/// is an Error, as are values that lie in other files (external storage, virtual datasets). Every Error names the file
/// and the object. Any number of threads may use a file at once (Hdf5Call.h).
class Hdf5File
{
public:
    explicit Hdf5File(const std::string& path);

    const std::string& path() const { return path_; }

    bool has(const std::string& object) const;
    /// The names in a group, sorted; empty if there is no such group.
    std::vector<std::string> members(const std::string& group) const;
    Hdf5Data data(const std::string& dataset) const;

    bool hasAttribute(const std::string& object, const std::string& attribute) const;
    /// The elements of a numeric attribute; of one element that is a compound of numbers, its members.
    std::vector<double> numbers(const std::string& object, const std::string& attribute) const;
    /// A numeric attribute that has to be one whole number from `least` to `most`.
    std::int64_t integer(const std::string& object, const std::string& attribute, std::int64_t least,
                         std::int64_t most) const;
    /// The named members, which are integers, of a compound attribute, as Hdf5Data::records has them.
    std::vector<std::int32_t> record(const std::string& object, const std::string& attribute,
                                     std::span<const std::string> members) const;
    /// A text, of fixed or variable length, without padding.
    std::string text(const std::string& object, const std::string& attribute) const;

private:
    std::string placeOf(const std::string& object) const;
    std::string placeOf(const std::string& object, const std::string& attribute) const;
    Hdf5Id open(const std::string& object) const;
    Hdf5Id openAttribute(const std::string& object, const std::string& attribute) const;

    std::string path_;
    Hdf5Id file_;
};

} // namespace brickwall
