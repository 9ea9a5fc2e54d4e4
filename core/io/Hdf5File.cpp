// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Hdf5File.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/InputFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <hdf5.h>

namespace brickwall {
namespace {

Hdf5Id openFile(const std::string& path)
{
    const Hdf5Call call;
    const Hdf5Id access = checkHdf5(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, path, "cannot be opened as HDF5");
    // Reading needs no lock, and not every shared file system has them.
    H5Pset_file_locking(access.get(), false, true);
    return checkHdf5(H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.get()), H5Fclose, path, "cannot be opened as HDF5");
}

/// Whether there is a link of this path to something in the file itself.
bool linked(std::int64_t file, const std::string& path, const std::string& place)
{
    for (std::size_t end = 0; end != std::string::npos;) {
        end = path.find('/', end + 1);
        const std::string part = path.substr(0, end);
        if (H5Lexists(file, part.c_str(), H5P_DEFAULT) <= 0)
            return false;
        H5L_info_t info;
        checkHdf5(H5Lget_info(file, part.c_str(), &info, H5P_DEFAULT), place, "has a link that cannot be read");
        if (info.type != H5L_TYPE_HARD)
            throw Error(place, fmt::format("expected an object of this file, found {} link, which is not followed",
                                           info.type == H5L_TYPE_SOFT ? "a soft" : "an external"));
    }
    return true;
}

herr_t keepName(hid_t, const char* name, const H5L_info_t*, void* names)
{
    constexpr std::size_t limit = 1 << 20; // hostile
    auto& list = *static_cast<std::vector<std::string>*>(names);
    list.emplace_back(name);
    return list.size() < limit ? 0 : -1;
}

std::uint64_t elementsOf(const Hdf5Id& attribute, const std::string& place)
{
    constexpr hssize_t limit = 1 << 16;
    const Hdf5Id space = checkHdf5(H5Aget_space(attribute.get()), H5Sclose, place, "has no readable shape");
    const hssize_t count = checkHdf5(H5Sget_simple_extent_npoints(space.get()), place, "has no readable shape");
    if (count < 1 || count > limit)
        throw Error(place, fmt::format("expected 1 to {} elements, found {}", limit, count));
    return static_cast<std::uint64_t>(count);
}

/// The members of an attribute that is one compound of numbers.
std::vector<double> membersOf(const Hdf5Id& attribute, const Hdf5Id& type, const std::string& place)
{
    const int count = checkHdf5(H5Tget_nmembers(type.get()), place, "has no readable type");
    const Hdf5Id memory = checkHdf5(H5Tcreate(H5T_COMPOUND, static_cast<std::size_t>(count) * sizeof(double)), H5Tclose,
                                    place, "cannot be read");
    for (unsigned i = 0; i < static_cast<unsigned>(count); ++i) {
        const H5T_class_t kind = H5Tget_member_class(type.get(), i);
        char* const name = H5Tget_member_name(type.get(), i);
        const bool inserted = name && (kind == H5T_INTEGER || kind == H5T_FLOAT) &&
                              H5Tinsert(memory.get(), name, i * sizeof(double), H5T_NATIVE_DOUBLE) >= 0;
        H5free_memory(name);
        if (!inserted)
            throw Error(place, "expected numbers, found a compound of something else");
    }
    if (elementsOf(attribute, place) != 1)
        throw Error(place, "expected one element, found several");
    std::vector<double> values(static_cast<std::size_t>(count));
    checkHdf5(H5Aread(attribute.get(), memory.get(), values.data()), place, "cannot be read");
    return values;
}

} // namespace

bool looksLikeHdf5(const std::string& path)
{
    const std::string signature("\x89HDF\r\n\x1a\n", 8), start = fileStart(path, 2048 + 8);
    const auto at = [&](std::size_t place) { return start.compare(place, 8, signature) == 0; };
    return start.size() >= 8 && (at(0) || (start.size() == 2048 + 8 && (at(512) || at(1024) || at(2048))));
}

Hdf5File::Hdf5File(const std::string& path) : path_(path), file_(openFile(path)) {}

std::string Hdf5File::placeOf(const std::string& object) const
{
    return fmt::format("{}: /{}", path_, object);
}

std::string Hdf5File::placeOf(const std::string& object, const std::string& attribute) const
{
    return fmt::format("{}: attribute '{}' of /{}", path_, attribute, object);
}

Hdf5Id Hdf5File::open(const std::string& object) const
{
    const std::string place = placeOf(object);
    if (!has(object))
        throw Error(place, "expected an object of this name, found none");
    return checkHdf5(H5Oopen(file_.get(), object.empty() ? "/" : object.c_str(), H5P_DEFAULT), H5Oclose, place,
                     "cannot be opened");
}

Hdf5Id Hdf5File::openAttribute(const std::string& object, const std::string& attribute) const
{
    const Hdf5Id owner = open(object);
    const std::string place = placeOf(object, attribute);
    if (H5Aexists(owner.get(), attribute.c_str()) <= 0)
        throw Error(place, "expected an attribute of this name, found none");
    return checkHdf5(H5Aopen(owner.get(), attribute.c_str(), H5P_DEFAULT), H5Aclose, place, "cannot be opened");
}

bool Hdf5File::has(const std::string& object) const
{
    const Hdf5Call call;
    return object.empty() || linked(file_.get(), object, placeOf(object));
}

std::vector<std::string> Hdf5File::members(const std::string& group) const
{
    const Hdf5Call call;
    std::vector<std::string> names;
    if (!has(group))
        return names;
    const Hdf5Id id = open(group);
    if (H5Iget_type(id.get()) != H5I_GROUP)
        return names;
    hsize_t next = 0;
    checkHdf5(H5Literate(id.get(), H5_INDEX_NAME, H5_ITER_INC, &next, keepName, &names), placeOf(group),
              "its members cannot be listed");
    return names;
}

Hdf5Data Hdf5File::data(const std::string& dataset) const
{
    const Hdf5Call call;
    Hdf5Id id = open(dataset);
    if (H5Iget_type(id.get()) != H5I_DATASET)
        throw Error(placeOf(dataset), "expected a dataset, found something else");
    return Hdf5Data(std::move(id), placeOf(dataset));
}

bool Hdf5File::hasAttribute(const std::string& object, const std::string& attribute) const
{
    const Hdf5Call call;
    return has(object) && H5Aexists(open(object).get(), attribute.c_str()) > 0;
}

std::vector<double> Hdf5File::numbers(const std::string& object, const std::string& attribute) const
{
    const Hdf5Call call;
    const std::string place = placeOf(object, attribute);
    const Hdf5Id id = openAttribute(object, attribute);
    const Hdf5Id type = checkHdf5(H5Aget_type(id.get()), H5Tclose, place, "has no readable type");
    const H5T_class_t kind = H5Tget_class(type.get());
    if (kind == H5T_COMPOUND)
        return membersOf(id, type, place);
    if (kind != H5T_INTEGER && kind != H5T_FLOAT)
        throw Error(place, "expected numbers, found an attribute of another type");
    std::vector<double> values(elementsOf(id, place));
    checkHdf5(H5Aread(id.get(), H5T_NATIVE_DOUBLE, values.data()), place, "cannot be read");
    return values;
}

std::int64_t Hdf5File::integer(const std::string& object, const std::string& attribute, std::int64_t least,
                               std::int64_t most) const
{
    const std::vector<double> values = numbers(object, attribute);
    if (values.size() != 1 || !(values[0] >= double(least) && values[0] <= double(most)) ||
        values[0] != std::floor(values[0]))
        throw Error(
            placeOf(object, attribute),
            fmt::format("expected a whole number from {} to {}, found {}", least, most,
                        values.size() == 1 ? fmt::format("{}", values[0]) : fmt::format("{} numbers", values.size())));
    return static_cast<std::int64_t>(values[0]);
}

std::vector<std::int32_t> Hdf5File::record(const std::string& object, const std::string& attribute,
                                           std::span<const std::string> members) const
{
    const Hdf5Call call;
    const std::string place = placeOf(object, attribute);
    const Hdf5Id id = openAttribute(object, attribute);
    const Hdf5Id type = checkHdf5(H5Aget_type(id.get()), H5Tclose, place, "has no readable type");
    const Hdf5Id memory = recordType(type.get(), members, place);
    if (elementsOf(id, place) != 1)
        throw Error(place, "expected one element, found several");
    std::vector<std::int32_t> values(members.size());
    checkHdf5(H5Aread(id.get(), memory.get(), values.data()), place, "cannot be read");
    return values;
}

std::string Hdf5File::text(const std::string& object, const std::string& attribute) const
{
    const Hdf5Call call;
    const std::string place = placeOf(object, attribute);
    const Hdf5Id id = openAttribute(object, attribute);
    const Hdf5Id type = checkHdf5(H5Aget_type(id.get()), H5Tclose, place, "has no readable type");
    if (H5Tget_class(type.get()) != H5T_STRING || elementsOf(id, place) != 1)
        throw Error(place, "expected a text, found an attribute of another type");
    if (H5Tis_variable_str(type.get()) == 0) {
        const std::size_t length = H5Tget_size(type.get());
        std::vector<char> bytes(length);
        checkHdf5(H5Aread(id.get(), type.get(), bytes.data()), place, "cannot be read");
        return trimmedText(bytes.data(), length);
    }
    char* bytes = nullptr;
    checkHdf5(H5Aread(id.get(), type.get(), &bytes), place, "cannot be read");
    const std::string text = bytes ? bytes : "";
    H5free_memory(bytes);
    return text;
}

} // namespace brickwall
