// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Hdf5Edits.h"

#include "brickwall/core/base/WholeFile.h"
#include "brickwall/tests/fuzz/ReadAll.h"

#include <algorithm>
#include <array>

namespace brickwall::fuzz {
namespace {

constexpr std::size_t mostBytes = 1 << 16; // that are written for an edit

struct Extents
{
    explicit Extents(FuzzedDataProvider& input) : rank(input.ConsumeIntegralInRange(0, 5))
    {
        for (int axis = 0; axis < rank; ++axis)
            of[static_cast<std::size_t>(axis)] = hostileExtent(input);
    }

    hid_t space() const { return rank == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(rank, of.data(), nullptr); }
    /// Of elements of that size; far too many count as too many.
    std::size_t bytes(std::size_t elementBytes) const
    {
        double all = double(elementBytes);
        for (int axis = 0; axis < rank; ++axis)
            all *= double(of[static_cast<std::size_t>(axis)]);
        return all <= double(mostBytes) ? static_cast<std::size_t>(all) : mostBytes + 1;
    }

    int rank;
    std::array<hsize_t, 5> of{};
};

/// Values that an earlier edit has put elsewhere: a virtual dataset may be its own source, which libhdf5 reads without
/// end.
bool storedInFile(hid_t data)
{
    const hid_t layout = H5Dget_create_plist(data);
    const bool stored = H5Pget_layout(layout) != H5D_VIRTUAL && H5Pget_external_count(layout) == 0;
    H5Pclose(layout);
    return stored;
}

void patchData(hid_t file, const std::string& path, FuzzedDataProvider& input)
{
    const hid_t data = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
    if (data < 0)
        return;
    const hid_t type = H5Dget_type(data), space = H5Dget_space(data);
    const double bytes = double(H5Sget_simple_extent_npoints(space)) * double(H5Tget_size(type));
    const bool plain = H5Tdetect_class(type, H5T_VLEN) <= 0 && !H5Tis_variable_str(type) && storedInFile(data);
    if (bytes > 0 && bytes <= double(mostBytes) && plain) {
        std::vector<char> elements(static_cast<std::size_t>(bytes));
        H5Dread(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, elements.data());
        patch(elements, type, input);
        H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, elements.data());
    }
    H5Sclose(space);
    H5Tclose(type);
    H5Dclose(data);
}

void patchAttribute(hid_t file, const std::string& object, const std::string& name, FuzzedDataProvider& input)
{
    const hid_t attribute = H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    if (attribute < 0)
        return;
    const hid_t type = H5Aget_type(attribute), space = H5Aget_space(attribute);
    const double bytes = double(H5Sget_simple_extent_npoints(space)) * double(H5Tget_size(type));
    if (bytes > 0 && bytes <= double(mostBytes) && !H5Tis_variable_str(type)) {
        std::vector<char> elements(static_cast<std::size_t>(bytes));
        H5Aread(attribute, type, elements.data());
        patch(elements, type, input);
        H5Awrite(attribute, type, elements.data());
    }
    H5Sclose(space);
    H5Tclose(type);
    H5Aclose(attribute);
}

/// Contiguous or in compressed chunks; in this file, or said to be in another one; its values written or not.
void replaceData(hid_t file, const std::string& path, FuzzedDataProvider& input)
{
    const Extents extents(input);
    const hid_t type = hostileType(input), space = extents.space(), layout = H5Pcreate(H5P_DATASET_CREATE);
    const int kind = input.ConsumeIntegralInRange(0, 4);
    if (kind == 1 && extents.rank > 0) {
        std::array<hsize_t, 5> chunk{};
        for (hsize_t& extent : chunk)
            extent = input.ConsumeBool() ? 1 : hostileExtent(input);
        H5Pset_chunk(layout, extents.rank, chunk.data());
        if (input.ConsumeBool())
            H5Pset_deflate(layout, 1);
    } else if (kind == 2) {
        H5Pset_external(layout, input.ConsumeBool() ? "/etc/passwd" : "data.h5", 0, H5F_UNLIMITED);
    } else if (kind == 3) {
        H5Pset_virtual(layout, space, "data.h5", path.c_str(), space);
    }
    H5Ldelete(file, path.c_str(), H5P_DEFAULT);
    const hid_t data = H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, layout, H5P_DEFAULT);
    const std::size_t bytes = extents.bytes(H5Tget_size(type));
    if (data >= 0 && kind < 2 && bytes > 0 && bytes <= mostBytes && input.ConsumeBool()) {
        std::vector<char> elements(bytes);
        patch(elements, type, input);
        H5Dwrite(data, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, elements.data());
    }
    if (data >= 0)
        H5Dclose(data);
    H5Pclose(layout);
    H5Sclose(space);
    H5Tclose(type);
}

void replaceAttribute(hid_t file, const std::string& object, const std::string& name, FuzzedDataProvider& input)
{
    H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT);
    const Extents extents(input);
    const hid_t type = hostileType(input), space = extents.space();
    const std::size_t bytes = extents.bytes(H5Tget_size(type));
    if (bytes <= mostBytes) {
        const hid_t attribute =
            H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
        std::vector<char> elements(std::max<std::size_t>(bytes, 1));
        patch(elements, type, input);
        H5Awrite(attribute, type, elements.data());
        H5Aclose(attribute);
    }
    H5Sclose(space);
    H5Tclose(type);
}

void variableText(hid_t file, const std::string& object, const std::string& name, FuzzedDataProvider& input)
{
    H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT);
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, H5T_VARIABLE);
    const hid_t attribute =
        H5Acreate_by_name(file, object.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const std::string text = input.ConsumeRandomLengthString(40);
    const char* const letters = text.c_str();
    H5Awrite(attribute, type, &letters);
    H5Aclose(attribute);
    H5Sclose(space);
    H5Tclose(type);
}

void unlinked(hid_t file, const std::string& path)
{
    H5Ldelete(file, path.c_str(), H5P_DEFAULT);
}

} // namespace

Hdf5Edits::Hdf5Edits(const std::vector<Write>& files)
{
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);       // many edits cannot be made
    objects_.attributes.emplace_back("/", "geometry"); // there may be none in the files
    for (const Write& write : files) {
        const std::string path = scratchFolder() + "/valid.h5";
        write(path);
        addObjects(path, objects_);
        files_.push_back(readWholeFile(path));
    }
}

std::string Hdf5Edits::path(FuzzedDataProvider& input) const
{
    return objects_.paths[input.ConsumeIntegralInRange<std::size_t>(0, objects_.paths.size() - 1)];
}

std::string Hdf5Edits::make(Input input) const
{
    constexpr int mostEdits = 16;
    FuzzedDataProvider provider(input.data(), input.size());
    const std::size_t which = provider.ConsumeIntegralInRange<std::size_t>(0, files_.size() - 1);
    const std::string path = writeScratch("data.h5", files_[which]);
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
    for (int i = 0; i < mostEdits && provider.remaining_bytes() > 0; ++i)
        edit(file, provider);
    H5Fclose(file);
    return path;
}

void Hdf5Edits::edit(hid_t file, FuzzedDataProvider& input) const
{
    const int what = input.ConsumeIntegralInRange(0, 11);
    const std::string at = path(input);
    const auto& [object, name] =
        objects_.attributes[input.ConsumeIntegralInRange<std::size_t>(0, objects_.attributes.size() - 1)];
    switch (what) {
    case 0:
        return patchData(file, at, input);
    case 1:
        return patchAttribute(file, object, name, input);
    case 2:
        return replaceData(file, at, input);
    case 3:
        return replaceAttribute(file, object, name, input);
    case 4:
        return variableText(file, object, name, input);
    case 5:
        return unlinked(file, at);
    case 6:
        H5Adelete_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT);
        return;
    case 7:
        unlinked(file, at);
        H5Gclose(H5Gcreate2(file, at.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        return;
    case 8:
        unlinked(file, at);
        H5Lcreate_soft(path(input).c_str(), file, at.c_str(), H5P_DEFAULT, H5P_DEFAULT);
        return;
    case 9:
        unlinked(file, at);
        H5Lcreate_external(input.ConsumeBool() ? "data.h5" : "/etc/passwd", path(input).c_str(), file, at.c_str(),
                           H5P_DEFAULT, H5P_DEFAULT);
        return;
    case 10: // a circle, if it leads to what it lies in
        unlinked(file, at);
        H5Lcreate_hard(file, input.ConsumeBool() ? "/" : path(input).c_str(), file, at.c_str(), H5P_DEFAULT,
                       H5P_DEFAULT);
        return;
    default: {
        const std::string to = path(input);
        unlinked(file, to);
        H5Lmove(file, at.c_str(), file, to.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    }
    }
}

void readEdited(const Hdf5Edits& edits, Input input)
{
    readAll(edits.make(input));
}

} // namespace brickwall::fuzz
