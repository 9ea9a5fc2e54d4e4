// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/WriteHdf5.h"

#include "brickwall/core/base/Error.h"

#include <hdf5.h>

namespace brickwall::oracles {
namespace {

template <class T>
T checked(T status, const std::string& what)
{
    if (status < 0)
        throw Error("HDF5 writer", "cannot make " + what);
    return status;
}

hid_t typeOf(Hdf5Number number)
{
    switch (number) {
    case Hdf5Number::float32:
        return H5T_IEEE_F32LE;
    case Hdf5Number::float32BigEndian:
        return H5T_IEEE_F32BE;
    case Hdf5Number::int32:
        return H5T_STD_I32LE;
    case Hdf5Number::int64:
        return H5T_STD_I64LE;
    case Hdf5Number::float64:
        break;
    }
    return H5T_IEEE_F64LE;
}

hid_t spaceOf(const std::vector<std::uint64_t>& shape)
{
    const std::vector<hsize_t> extents(shape.begin(), shape.end());
    return checked(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), "a shape");
}

hid_t recordType(const std::vector<std::string>& members, hid_t number)
{
    const std::size_t bytes = H5Tget_size(number);
    const hid_t type = checked(H5Tcreate(H5T_COMPOUND, members.size() * bytes), "a type");
    for (std::size_t i = 0; i < members.size(); ++i)
        checked(H5Tinsert(type, members[i].c_str(), i * bytes, number), members[i]);
    return type;
}

hid_t textType(std::size_t length)
{
    const hid_t type = checked(H5Tcopy(H5T_C_S1), "a type");
    checked(H5Tset_size(type, length), "a type");
    checked(H5Tset_strpad(type, H5T_STR_NULLPAD), "a type");
    return type;
}

std::vector<char> padded(const std::vector<std::string>& values, std::size_t length)
{
    std::vector<char> bytes;
    for (std::string value : values) {
        value.resize(length, ' ');
        bytes.insert(bytes.end(), value.begin(), value.end());
    }
    return bytes;
}

/// Takes over the identifiers.
void writeData(hid_t file, const std::string& path, hid_t type, hid_t memory, hid_t space, const void* values,
               hid_t layout = H5P_DEFAULT)
{
    const hid_t data = checked(H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, layout, H5P_DEFAULT), path);
    if (values)
        checked(H5Dwrite(data, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), path);
    H5Dclose(data);
    H5Sclose(space);
}

void writeAttribute(hid_t file, const std::string& object, const std::string& name, hid_t type, hid_t memory,
                    hid_t space, const void* values)
{
    const hid_t owner = checked(H5Oopen(file, object.empty() ? "/" : object.c_str(), H5P_DEFAULT), object);
    const hid_t id = checked(H5Acreate2(owner, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), name);
    checked(H5Awrite(id, memory, values), name);
    H5Aclose(id);
    H5Sclose(space);
    H5Oclose(owner);
}

} // namespace

Hdf5Writer::Hdf5Writer(const std::string& path, Mode mode)
    : file_(checked(mode == Mode::edit ? H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT)
                                       : H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT),
                    path))
{
}

Hdf5Writer::~Hdf5Writer()
{
    H5Fclose(file_);
}

void Hdf5Writer::group(const std::string& path)
{
    H5Gclose(checked(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), path));
}

void Hdf5Writer::numbers(const std::string& path, const std::vector<std::uint64_t>& shape,
                         const std::vector<double>& values, Hdf5Number type, const std::vector<std::uint64_t>& chunk)
{
    const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
    if (!chunk.empty()) {
        const std::vector<hsize_t> extents(chunk.begin(), chunk.end());
        checked(H5Pset_chunk(layout, static_cast<int>(extents.size()), extents.data()), "chunks");
        checked(H5Pset_deflate(layout, 1), "a filter");
    }
    writeData(file_, path, typeOf(type), H5T_NATIVE_DOUBLE, spaceOf(shape), values.empty() ? nullptr : values.data(),
              layout);
    H5Pclose(layout);
}

void Hdf5Writer::unwritten(const std::string& path, const std::vector<std::uint64_t>& shape)
{
    writeData(file_, path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, spaceOf(shape), nullptr);
}

void Hdf5Writer::elsewhere(const std::string& path, const std::vector<std::uint64_t>& shape, const std::string& file)
{
    const hid_t layout = H5Pcreate(H5P_DATASET_CREATE);
    checked(H5Pset_external(layout, file.c_str(), 0, H5F_UNLIMITED), file);
    writeData(file_, path, H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, spaceOf(shape), nullptr, layout);
    H5Pclose(layout);
}

void Hdf5Writer::records(const std::string& path, const std::vector<std::string>& members,
                         const std::vector<std::int64_t>& values)
{
    const hid_t type = recordType(members, H5T_STD_I32LE), memory = recordType(members, H5T_NATIVE_INT64);
    writeData(file_, path, type, memory, spaceOf({values.size() / members.size()}), values.data());
    H5Tclose(type);
    H5Tclose(memory);
}

void Hdf5Writer::texts(const std::string& path, const std::vector<std::uint64_t>& shape,
                       const std::vector<std::string>& values, std::size_t length)
{
    const hid_t type = textType(length);
    writeData(file_, path, type, type, spaceOf(shape), padded(values, length).data());
    H5Tclose(type);
}

void Hdf5Writer::pairs(const std::string& path, const std::vector<std::pair<std::string, std::string>>& values)
{
    constexpr std::size_t length = 80;
    std::vector<std::string> texts;
    for (const auto& [name, value] : values) {
        texts.push_back(name);
        texts.push_back(value);
    }
    const hid_t text = textType(length), type = recordType({"name", "value"}, text);
    writeData(file_, path, type, type, spaceOf({values.size()}), padded(texts, length).data());
    H5Tclose(type);
    H5Tclose(text);
}

void Hdf5Writer::remove(const std::string& path)
{
    checked(H5Ldelete(file_, path.c_str(), H5P_DEFAULT), path);
}

void Hdf5Writer::removeAttribute(const std::string& object, const std::string& name)
{
    checked(H5Adelete_by_name(file_, object.empty() ? "/" : object.c_str(), name.c_str(), H5P_DEFAULT), name);
}

void Hdf5Writer::hardLink(const std::string& path, const std::string& target)
{
    checked(H5Lcreate_hard(file_, target.c_str(), file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT), path);
}

void Hdf5Writer::softLink(const std::string& path, const std::string& target)
{
    checked(H5Lcreate_soft(target.c_str(), file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT), path);
}

void Hdf5Writer::externalLink(const std::string& path, const std::string& file, const std::string& target)
{
    checked(H5Lcreate_external(file.c_str(), target.c_str(), file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT), path);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, const std::vector<double>& values,
                           Hdf5Number type)
{
    const hid_t space = values.size() == 1 ? H5Screate(H5S_SCALAR) : spaceOf({values.size()});
    writeAttribute(file_, object, name, typeOf(type), H5T_NATIVE_DOUBLE, space, values.data());
}

void Hdf5Writer::textAttribute(const std::string& object, const std::string& name, const std::string& text)
{
    const hid_t type = textType(text.size());
    writeAttribute(file_, object, name, type, type, H5Screate(H5S_SCALAR), text.data());
    H5Tclose(type);
}

void Hdf5Writer::variableText(const std::string& object, const std::string& name, const std::string& text)
{
    const hid_t type = textType(H5T_VARIABLE);
    const char* bytes = text.c_str();
    writeAttribute(file_, object, name, type, type, H5Screate(H5S_SCALAR), &bytes);
    H5Tclose(type);
}

void Hdf5Writer::recordAttribute(const std::string& object, const std::string& name,
                                 const std::vector<std::string>& members, const std::vector<std::int64_t>& values)
{
    const hid_t type = recordType(members, H5T_STD_I32LE), memory = recordType(members, H5T_NATIVE_INT64);
    writeAttribute(file_, object, name, type, memory, H5Screate(H5S_SCALAR), values.data());
    H5Tclose(type);
    H5Tclose(memory);
}

} // namespace brickwall::oracles
