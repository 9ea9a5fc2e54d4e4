// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/WriteFlash.h"

#include "brickwall/tests/oracles/WriteHdf5.h"

#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace brickwall::oracles {
namespace {

void appendTree(const Flash3& f, int level, const vec3i& place, std::vector<FlashBlock>& blocks)
{
    const bool leaf = !f.refined(level, place);
    blocks.push_back({level, place, leaf});
    if (!leaf)
        for (int child = 0; child < 8; ++child)
            appendTree(f, level + 1, place * 2 + vec3i(child & 1, child >> 1 & 1, child >> 2), blocks);
}

/// As FLASH has it: six neighbours, here unknown, the parent and eight children, -1 for none, counted from 1.
std::vector<double> neighboursAndFamily(const std::vector<FlashBlock>& blocks)
{
    std::map<std::array<int, 4>, std::size_t> at;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        at[{blocks[b].refineLevel, blocks[b].place.x, blocks[b].place.y, blocks[b].place.z}] = b;
    std::vector<double> gid(blocks.size() * 15, -1.0);
    for (std::size_t b = 0; b < blocks.size(); ++b)
        for (int child = 0; child < 8 && !blocks[b].leaf; ++child) {
            const vec3i place = blocks[b].place * 2 + vec3i(child & 1, child >> 1 & 1, child >> 2);
            const std::size_t found = at.at({blocks[b].refineLevel + 1, place.x, place.y, place.z});
            gid[b * 15 + 7 + static_cast<std::size_t>(child)] = double(found + 1);
            gid[found * 15 + 6] = double(b + 1);
        }
    return gid;
}

void appendCells(const Flash3& f, int field, const FlashBlock& block, std::vector<double>& values)
{
    const vec3i n = f.blockCells, lower = block.place * n;
    for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
            for (int x = 0; x < n.x; ++x)
                values.push_back(block.leaf ? f.value(block.refineLevel, field, lower + vec3i(x, y, z))
                                            : std::numeric_limits<double>::quiet_NaN());
}

} // namespace

std::vector<FlashBlock> flashBlocks(const Flash3& flash)
{
    std::vector<FlashBlock> blocks;
    for (int z = 0; z < flash.rootBlocks.z; ++z)
        for (int y = 0; y < flash.rootBlocks.y; ++y)
            for (int x = 0; x < flash.rootBlocks.x; ++x)
                appendTree(flash, 1, {x, y, z}, blocks);
    return blocks;
}

void writeFlash(const std::string& path, const Flash3& flash)
{
    const std::vector<FlashBlock> blocks = flashBlocks(flash);
    const std::uint64_t count = blocks.size();
    std::vector<double> refine, node, bounds;
    for (const FlashBlock& block : blocks) {
        refine.push_back(block.refineLevel);
        node.push_back(block.leaf ? 1 : 2);
        const vec3d width = (flash.upper - flash.lower) / vec3d(flash.rootBlocks) / std::exp2(block.refineLevel - 1);
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1})
                bounds.push_back(flash.lower[axis] + (block.place[axis] + side) * width[axis]);
    }
    const Hdf5Number real = flash.floats ? Hdf5Number::float32 : Hdf5Number::float64;
    Hdf5Writer file(path);
    file.texts("unknown names", {flash.fields.size(), 1}, flash.fields, 4);
    file.numbers("refine level", {count}, refine, Hdf5Number::int32);
    file.numbers("node type", {count}, node, Hdf5Number::int32);
    file.numbers("bounding box", {count, 3, 2}, bounds, real);
    if (flash.tree)
        file.numbers("gid", {count, 15}, neighboursAndFamily(blocks), Hdf5Number::int32);
    file.pairs("string scalars", {{"geometry", flash.geometry}});
    const vec3i n = flash.blockCells;
    const std::vector<std::uint64_t> shape{count, std::uint64_t(n.z), std::uint64_t(n.y), std::uint64_t(n.x)};
    std::vector<std::uint64_t> chunk;
    if (flash.chunked)
        chunk = {1, shape[1], shape[2], shape[3]};
    for (int field = 0; field < static_cast<int>(flash.fields.size()); ++field) {
        std::vector<double> values;
        for (const FlashBlock& block : blocks)
            appendCells(flash, field, block, values);
        std::string name = flash.fields[static_cast<std::size_t>(field)];
        name.resize(4, ' ');
        file.numbers(name, shape, values, real, chunk);
    }
}

} // namespace brickwall::oracles
