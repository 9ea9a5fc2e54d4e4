// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VdbFile.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/VdbHead.h"
#include "brickwall/core/io/VdbTreeCheck.h"

#include <openvdb/io/Archive.h>
#include <openvdb/io/GridDescriptor.h>
#include <openvdb/io/io.h>
#include <openvdb/openvdb.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>

namespace brickwall {
namespace {

/// io::File would not notice the end of a file in the middle of a grid; a stream of our own that throws does.
class Archive : public openvdb::io::Archive
{
public:
    explicit Archive(const std::string& path) : path_(path), stream_(path, std::ios::binary)
    {
        stream_.exceptions(std::ios::failbit | std::ios::badbit);
        readHeader(stream_);
        metadata_.reset(new openvdb::io::StreamMetadata);
        metadata_->setSeekable(true);
        openvdb::io::setStreamMetadataPtr(stream_, metadata_, false);
        setFormatVersion(stream_);
        setLibraryVersion(stream_);
        setDataCompression(stream_);
    }
    ~Archive() override { openvdb::io::clearStreamMetadataPtr(stream_); }

    openvdb::GridBase::Ptr readAll(std::int64_t entry)
    {
        openvdb::io::GridDescriptor descriptor;
        const openvdb::GridBase::Ptr grid = open(entry, descriptor);
        if (descriptor.isInstance())
            throw openvdb::IoError("a grid that shares the values of another one (instancing)");
        readGridCompression(stream_);
        grid->readMeta(stream_);
        grid->readTransform(stream_);
        checkTree(*grid);
        descriptor.seekToGrid(stream_);
        readGrid(grid, descriptor, stream_);
        return grid;
    }

    /// Metadata and transform alone.
    openvdb::GridBase::Ptr readHead(std::int64_t entry)
    {
        openvdb::io::GridDescriptor descriptor;
        const openvdb::GridBase::Ptr grid = open(entry, descriptor);
        readGridCompression(stream_);
        grid->readMeta(stream_);
        grid->readTransform(stream_);
        return grid;
    }

private:
    /// What the stream is at. Whether floats have 16 bits follows from the metadata, which OpenVDB goes by: the type's
    /// name in the file may say something else.
    void checkTree(const openvdb::GridBase& grid)
    {
        const std::string type = grid.type();
        const std::uint32_t components = type.starts_with("Tree_vec3") ? 3 : 1;
        const bool wide = type.find("double") != std::string::npos || type.find("int64") != std::string::npos ||
                          type.find("vec3d") != std::string::npos;
        const bool integer = type.find("int") != std::string::npos || type.find("vec3i") != std::string::npos;
        VdbStorage storage;
        storage.compression = openvdb::io::getDataCompression(stream_);
        storage.valueBytes = components * (wide ? 8 : 4);
        storage.storedBytes = grid.saveFloatAsHalf() && !integer ? components * 2 : storage.valueBytes;
        checkVdbTree(InputFile(path_), static_cast<std::uint64_t>(std::streamoff(stream_.tellg())), storage, path_);
    }

    openvdb::GridBase::Ptr open(std::int64_t entry, openvdb::io::GridDescriptor& descriptor)
    {
        stream_.seekg(entry);
        const openvdb::GridBase::Ptr grid = descriptor.read(stream_);
        descriptor.seekToGrid(stream_);
        return grid;
    }

    std::string path_;
    std::ifstream stream_;
    openvdb::io::StreamMetadata::Ptr metadata_;
};

/// Runs `work`; what the library throws becomes an Error.
template <class Work>
auto translated(const std::string& place, const Work& work)
{
    try {
        return work();
    } catch (const Error&) {
        throw;
    } catch (const std::ios_base::failure&) {
        throw Error(place, "truncated: the file ends before its grids do");
    } catch (const std::bad_alloc&) {
        throw Error(place, "has sizes that no memory is enough for");
    } catch (const std::exception& error) {
        throw Error(place, fmt::format("cannot be read by OpenVDB: {}", error.what()));
    }
}

bool hasNumbers(const std::string& type)
{
    constexpr std::array<std::string_view, 7> types{"float", "double", "int32", "int64", "vec3s", "vec3d", "vec3i"};
    return std::any_of(types.begin(), types.end(), [&](std::string_view t) {
        const std::string tree = fmt::format("Tree_{}_5_4_3", t);
        return type == tree || type == tree + "_HalfFloat";
    });
}

/// AMR codes say where index 0 begins, whatever they made of the transform.
bool hasAmrOrigin(const openvdb::GridBase& grid)
{
    return grid.getMetadata<openvdb::Vec3DMetadata>("origin") && (grid["dx"] || grid["amr_level"]);
}

void place(const openvdb::GridBase& grid, const std::string& where, VdbGridInfo& info)
{
    const openvdb::math::Transform& transform = grid.transform();
    if (!transform.isLinear())
        throw Error(where, fmt::format("expected a transform of scale and translation, found a {}",
                                       std::string(transform.mapType())));
    const openvdb::Mat4d m = transform.baseMap()->getAffineMap()->getMat4(); // row vectors: p m
    for (int axis = 0; axis < 3; ++axis) {
        for (int other = 0; other < 3; ++other)
            if (other != axis && !(std::abs(m(axis, other)) <= 1e-9 * std::abs(m(axis, axis))))
                throw Error(where, "expected a transform of scale and translation, found a rotation or shear; resample "
                                   "the grid along the axes");
        if (!(m(axis, axis) > 0.0) || !std::isfinite(m(axis, axis)) || !std::isfinite(m(3, axis)))
            throw Error(where,
                        fmt::format("expected a positive voxel size, found {} along {}", m(axis, axis), "xyz"[axis]));
        info.voxelSize[axis] = m(axis, axis);
        // OpenVDB's indices are at the centres of voxels.
        info.lower[axis] = m(3, axis) - m(axis, axis) / 2.0;
        if (hasAmrOrigin(grid))
            info.lower[axis] = grid.metaValue<openvdb::Vec3d>("origin")[axis];
    }
}

} // namespace

VdbFile::VdbFile(const std::string& path) : path_(path)
{
    const std::vector<VdbEntry> entries = readVdbHead(InputFile(path));
    translated(path, [&] {
        openvdb::initialize();
        Archive archive(path);
        for (const VdbEntry& entry : entries) {
            if (!hasNumbers(entry.type))
                continue;
            VdbGridInfo info;
            info.name = openvdb::io::GridDescriptor::nameAsString(entry.name);
            info.type = entry.type;
            info.begin = entry.begin;
            place(*archive.readHead(entry.begin), fmt::format("{}: grid '{}'", path, info.name), info);
            grids_.push_back(info);
        }
    });
    if (!grids_.empty())
        return;
    std::string found;
    for (const VdbEntry& entry : entries)
        found += fmt::format("{}{} ({})", found.empty() ? "" : ", ", entry.name, entry.type);
    throw Error(path, fmt::format("expected grids of numbers or vectors of three, found {}",
                                  found.empty() ? "no grid" : found));
}

openvdb::GridBase::Ptr VdbFile::read(const VdbGridInfo& info) const
{
    return translated(fmt::format("{}: grid '{}'", path_, info.name),
                      [&] { return Archive(path_).readAll(info.begin); });
}

bool isVdb(const std::string& path)
{
    return fileStart(path, 8) == std::string("\x20\x42\x44\x56\0\0\0\0", 8);
}

} // namespace brickwall
