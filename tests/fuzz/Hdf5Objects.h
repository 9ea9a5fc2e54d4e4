// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fuzzer/FuzzedDataProvider.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <hdf5.h>

namespace brickwall::fuzz {

/// What there is to edit in an HDF5 file: all objects but the root, and the attributes of all objects.
struct Hdf5Objects
{
    std::vector<std::string> paths;
    std::vector<std::pair<std::string, std::string>> attributes; ///< object, name
};

/// Adds those of a file.
void addObjects(const std::string& path, Hdf5Objects& objects);

/// A number as hostile files have it: near a limit of a type, of an index or of what is stored, or any.
double hostileNumber(FuzzedDataProvider& input);

/// An extent: small, at a limit, or one whose product with others overflows.
hsize_t hostileExtent(FuzzedDataProvider& input);

/// Replaces one number of the elements, as whatever their type stores it: an integer, a float, or bytes. Elements may
/// be records of such numbers.
void patch(std::vector<char>& elements, hid_t type, FuzzedDataProvider& input);

/// Numbers, texts or records; the caller closes it.
hid_t hostileType(FuzzedDataProvider& input);

} // namespace brickwall::fuzz
