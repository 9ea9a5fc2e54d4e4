// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Seeds.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

namespace brickwall::fuzz {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;
using openvdb::io::COMPRESS_ACTIVE_MASK;
using openvdb::io::COMPRESS_BLOSC;
using openvdb::io::COMPRESS_ZIP;

/// A few voxels in two leaves, and a tile if `tile`. All in one node of the root, as each takes 8 kB.
template <class Grid>
typename Grid::Ptr gridOf(const std::string& name, const typename Grid::ValueType& step, bool tile = false)
{
    auto grid = Grid::create(openvdb::zeroVal<typename Grid::ValueType>());
    grid->setName(name);
    auto value = step;
    for (const Coord& c : {Coord(0, 0, 0), Coord(1, 0, 0), Coord(7, 3, 2), Coord(8, 0, 0)})
        grid->tree().setValueOn(c, value = value + step);
    if (tile)
        grid->tree().addTile(1, Coord(16, 0, 0), value, true);
    return grid;
}

void write(const std::string& path, const openvdb::GridCPtrVec& grids, std::uint32_t packing)
{
    openvdb::io::File file(path);
    file.setCompression(packing);
    file.write(grids);
}

} // namespace

void writeOpenvdbSeeds(const std::string& folder)
{
    openvdb::initialize();
    const auto density = gridOf<openvdb::FloatGrid>("density", 1.0f, true);
    write(folder + "/mask.vdb", {density}, COMPRESS_ACTIVE_MASK);
    write(folder + "/zip.vdb", {density}, COMPRESS_ZIP | COMPRESS_ACTIVE_MASK);
    write(folder + "/blosc.vdb", {density}, COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK);

    const auto half = gridOf<openvdb::FloatGrid>("half", 0.5f);
    half->setSaveFloatAsHalf(true);
    write(folder + "/half.vdb", {half}, COMPRESS_ACTIVE_MASK);
    write(folder + "/double.vdb", {gridOf<openvdb::DoubleGrid>("d", 1.0)}, COMPRESS_BLOSC | COMPRESS_ACTIVE_MASK);
    write(folder + "/int32.vdb", {gridOf<openvdb::Int32Grid>("i", 1)}, COMPRESS_ACTIVE_MASK);
    write(folder + "/int64.vdb", {gridOf<openvdb::Int64Grid>("l", 1)}, COMPRESS_ZIP | COMPRESS_ACTIVE_MASK);
    write(folder + "/vector.vdb", {gridOf<openvdb::Vec3SGrid>("v", openvdb::Vec3s(1, 2, 3))}, COMPRESS_ACTIVE_MASK);

    const auto coarse = gridOf<openvdb::FloatGrid>("rho_L0", 1.0f, true),
               fine = gridOf<openvdb::FloatGrid>("rho_L1", 2.0f);
    coarse->setTransform(openvdb::math::Transform::createLinearTransform(1.0));
    fine->setTransform(openvdb::math::Transform::createLinearTransform(0.5));
    fine->insertMeta("amr_level", openvdb::Int32Metadata(1));
    write(folder + "/levels.vdb", {coarse, fine}, COMPRESS_ACTIVE_MASK);
}

} // namespace brickwall::fuzz
