// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Hdf5Data.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include <hdf5.h>

namespace brickwall {
namespace {

/// Deflate makes at most 1032 bytes of one.
constexpr double largestExpansion = 1100.0;

std::uint64_t productOf(std::span<const std::uint64_t> counts)
{
    std::uint64_t product = 1;
    for (const std::uint64_t n : counts)
        product *= n;
    return product;
}

void expectClass(std::int64_t dataset, std::initializer_list<H5T_class_t> wanted, const char* what,
                 const std::string& place)
{
    const Hdf5Id type = checkHdf5(H5Dget_type(dataset), H5Tclose, place, "has no readable type");
    if (std::find(wanted.begin(), wanted.end(), H5Tget_class(type.get())) == wanted.end())
        throw Error(place, fmt::format("expected {}, found a dataset of another type", what));
}

/// A member of a compound that is a text of fixed length, else the type itself, which has to be one.
Hdf5Id textType(std::int64_t type, const std::string& member, const std::string& place)
{
    Hdf5Id text;
    if (member.empty()) {
        text = checkHdf5(H5Tcopy(type), H5Tclose, place, "has no readable type");
    } else {
        const int index = H5Tget_class(type) == H5T_COMPOUND ? H5Tget_member_index(type, member.c_str()) : -1;
        text = checkHdf5(index < 0 ? -1 : H5Tget_member_type(type, static_cast<unsigned>(index)), H5Tclose, place,
                         fmt::format("expected elements with a member '{}'", member));
    }
    if (H5Tget_class(text.get()) != H5T_STRING || H5Tis_variable_str(text.get()) != 0)
        throw Error(place, "expected texts of fixed length, found another type");
    return text;
}

} // namespace

Hdf5Data::Hdf5Data(Hdf5Id dataset, std::string place) : dataset_(std::move(dataset)), place_(std::move(place))
{
    const Hdf5Call call;
    const Hdf5Id space = checkHdf5(H5Dget_space(dataset_.get()), H5Sclose, place_, "has no readable shape");
    if (H5Sget_simple_extent_type(space.get()) == H5S_NULL)
        throw Error(place_, "expected values, found an empty dataset");
    const int rank = checkHdf5(H5Sget_simple_extent_ndims(space.get()), place_, "has no readable shape");
    std::vector<hsize_t> shape(static_cast<std::size_t>(rank));
    checkHdf5(H5Sget_simple_extent_dims(space.get(), shape.data(), nullptr), place_, "has no readable shape");
    shape_.assign(shape.begin(), shape.end());
    checkStorage();
}

void Hdf5Data::checkStorage() const
{
    const Hdf5Id layout = checkHdf5(H5Dget_create_plist(dataset_.get()), H5Pclose, place_, "has no readable layout");
    if (H5Pget_layout(layout.get()) == H5D_VIRTUAL || H5Pget_external_count(layout.get()) > 0)
        throw Error(place_, "expected values in this file, found a dataset whose values are in other files, which is "
                            "not followed");
    const Hdf5Id type = checkHdf5(H5Dget_type(dataset_.get()), H5Tclose, place_, "has no readable type");
    // Hostile extents may multiply beyond 2^64. A chunk is expanded as a whole, however little of it is in the shape.
    double bytes = double(H5Tget_size(type.get())), chunkBytes = bytes;
    for (const std::uint64_t n : shape_)
        bytes *= double(n);
    std::vector<hsize_t> chunk(shape_.size());
    if (H5Pget_layout(layout.get()) == H5D_CHUNKED) {
        checkHdf5(H5Pget_chunk(layout.get(), static_cast<int>(chunk.size()), chunk.data()), place_,
                  "has no readable layout");
        for (const hsize_t n : chunk)
            chunkBytes *= double(n);
        bytes = bytes > 0.0 ? std::max(bytes, chunkBytes) : 0.0;
    }
    hsize_t fileBytes = 0;
    const Hdf5Id file = checkHdf5(H5Iget_file_id(dataset_.get()), H5Fclose, place_, "belongs to no file");
    checkHdf5(H5Fget_filesize(file.get(), &fileBytes), place_, "belongs to a file of unknown size");
    const hsize_t stored = std::min(H5Dget_storage_size(dataset_.get()), fileBytes);
    if (bytes > largestExpansion * double(stored))
        throw Error(place_, fmt::format("truncated: its shape {} and chunks ask for {} bytes, but only {} are stored",
                                        shapeText(shape_), bytes, stored));
}

std::uint64_t Hdf5Data::size() const
{
    return productOf(shape_);
}

void Hdf5Data::read(std::span<const std::uint64_t> start, std::span<const std::uint64_t> count,
                    std::vector<double>& values) const
{
    bool inside = start.size() == shape_.size() && count.size() == shape_.size() && !shape_.empty();
    for (std::size_t i = 0; inside && i < shape_.size(); ++i)
        inside = start[i] <= shape_[i] && count[i] <= shape_[i] - start[i];
    if (!inside)
        throw Error(place_, fmt::format("truncated: expected {} elements from {} on, found a shape of {}",
                                        shapeText(count), shapeText(start), shapeText(shape_)));
    values.resize(productOf(count));
    if (values.empty())
        return;
    const Hdf5Call call;
    expectClass(dataset_.get(), {H5T_INTEGER, H5T_FLOAT}, "numbers", place_);
    const std::vector<hsize_t> first(start.begin(), start.end()), extent(count.begin(), count.end());
    const Hdf5Id there = checkHdf5(H5Dget_space(dataset_.get()), H5Sclose, place_, "has no readable shape");
    checkHdf5(H5Sselect_hyperslab(there.get(), H5S_SELECT_SET, first.data(), nullptr, extent.data(), nullptr), place_,
              "cannot be read in part");
    const Hdf5Id here = checkHdf5(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), H5Sclose,
                                  place_, "cannot be read");
    checkHdf5(H5Dread(dataset_.get(), H5T_NATIVE_DOUBLE, here.get(), there.get(), H5P_DEFAULT, values.data()), place_,
              "cannot be read");
}

std::vector<double> Hdf5Data::numbers() const
{
    std::vector<double> values;
    const std::vector<std::uint64_t> start(shape_.size(), 0);
    read(start, shape_, values);
    return values;
}

std::vector<std::int64_t> Hdf5Data::integers() const
{
    const Hdf5Call call;
    expectClass(dataset_.get(), {H5T_INTEGER}, "integers", place_);
    std::vector<std::int64_t> values(size());
    checkHdf5(H5Dread(dataset_.get(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), place_,
              "cannot be read");
    return values;
}

std::vector<std::int32_t> Hdf5Data::records(std::span<const std::string> members, std::uint64_t first,
                                            std::uint64_t count) const
{
    if (shape_.size() != 1 || first > shape_[0] || count > shape_[0] - first)
        throw Error(place_, fmt::format("truncated: expected a list with {} elements from {} on, found a shape of {}",
                                        count, first, shapeText(shape_)));
    const Hdf5Call call;
    const Hdf5Id type = checkHdf5(H5Dget_type(dataset_.get()), H5Tclose, place_, "has no readable type");
    const Hdf5Id memory = recordType(type.get(), members, place_);
    std::vector<std::int32_t> values(count * members.size());
    if (values.empty())
        return values;
    const hsize_t start = first, extent = count;
    const Hdf5Id there = checkHdf5(H5Dget_space(dataset_.get()), H5Sclose, place_, "has no readable shape");
    checkHdf5(H5Sselect_hyperslab(there.get(), H5S_SELECT_SET, &start, nullptr, &extent, nullptr), place_,
              "cannot be read in part");
    const Hdf5Id here = checkHdf5(H5Screate_simple(1, &extent, nullptr), H5Sclose, place_, "cannot be read");
    checkHdf5(H5Dread(dataset_.get(), memory.get(), here.get(), there.get(), H5P_DEFAULT, values.data()), place_,
              "cannot be read");
    return values;
}

std::vector<std::string> Hdf5Data::texts(const std::string& member) const
{
    const Hdf5Call call;
    const Hdf5Id type = checkHdf5(H5Dget_type(dataset_.get()), H5Tclose, place_, "has no readable type");
    const Hdf5Id text = textType(type.get(), member, place_);
    const std::size_t length = H5Tget_size(text.get());
    Hdf5Id memory;
    if (!member.empty()) {
        memory = checkHdf5(H5Tcreate(H5T_COMPOUND, length), H5Tclose, place_, "cannot be read");
        checkHdf5(H5Tinsert(memory.get(), member.c_str(), 0, text.get()), place_, "cannot be read");
    }
    std::vector<char> bytes(size() * length);
    checkHdf5(H5Dread(dataset_.get(), member.empty() ? text.get() : memory.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT,
                      bytes.data()),
              place_, "cannot be read");
    std::vector<std::string> texts;
    for (std::size_t i = 0; i + length <= bytes.size(); i += length)
        texts.push_back(trimmedText(bytes.data() + i, length));
    return texts;
}

void Hdf5Data::expectShape(std::span<const std::uint64_t> shape) const
{
    bool same = shape.size() == shape_.size();
    for (std::size_t i = 0; same && i < shape.size(); ++i)
        same = shape[i] == 0 || shape[i] == shape_[i];
    if (!same)
        throw Error(place_, fmt::format("expected a shape of {}{}, found {}", shapeText(shape),
                                        std::find(shape.begin(), shape.end(), 0) != shape.end() ? " (0: any)" : "",
                                        shapeText(shape_)));
}

Hdf5Id recordType(std::int64_t type, std::span<const std::string> members, const std::string& place)
{
    Hdf5Id memory =
        checkHdf5(H5Tcreate(H5T_COMPOUND, members.size() * sizeof(std::int32_t)), H5Tclose, place, "cannot be read");
    for (std::size_t i = 0; i < members.size(); ++i) {
        const int index = H5Tget_class(type) == H5T_COMPOUND ? H5Tget_member_index(type, members[i].c_str()) : -1;
        if (index < 0 || H5Tget_member_class(type, static_cast<unsigned>(index)) != H5T_INTEGER)
            throw Error(place, fmt::format("expected elements with the integers {}, found no '{}'",
                                           fmt::join(members, ", "), members[i]));
        checkHdf5(H5Tinsert(memory.get(), members[i].c_str(), i * sizeof(std::int32_t), H5T_NATIVE_INT32), place,
                  "cannot be read");
    }
    return memory;
}

std::string shapeText(std::span<const std::uint64_t> shape)
{
    return fmt::format("({})", fmt::join(shape, ", "));
}

std::string trimmedText(const char* text, std::size_t length)
{
    std::string trimmed(text, strnlen(text, length));
    trimmed.resize(trimmed.find_last_not_of(' ') + 1);
    return trimmed;
}

} // namespace brickwall
