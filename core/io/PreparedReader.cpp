// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/ContentHash.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/LargeArray.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/PreparedFile.h"
#include "brickwall/core/io/PreparedPieces.h"
#include "brickwall/core/io/PreparedVisit.h"
#include "brickwall/core/model/CheckModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <span>

namespace brickwall {
namespace {

/// The archive (PreparedVisit.h) that reads. No size is believed before it fits the file.
class PreparedReader
{
public:
    PreparedReader(const InputFile& file, const Executor& executor, Progress& progress)
        : file_(file), executor_(executor), progress_(progress)
    {
        PreparedHeader header;
        file.readAt(0, std::span(&header, 1), "the header");
        if (header.magic != preparedMagic || header.version != preparedVersion || header.fileSize != file.size() ||
            header.tableOffset < sizeof header || header.tableOffset > file.size())
            fail("expected the header of this version");
        table_.resize(file.size() - header.tableOffset);
        file.readAt(header.tableOffset, std::span(table_), "the table");
        if (contentHash(table_) != header.tableHash)
            fail("damaged table");
    }

    template <class T>
    void value(T& value)
    {
        std::memcpy(static_cast<void*>(&value), take(sizeof(T)), sizeof(T));
    }

    void text(std::string& text)
    {
        std::uint64_t size = 0;
        value(size);
        const std::byte* from = take(size);
        text.assign(reinterpret_cast<const char*>(from), size);
    }

    template <class T>
    void array(std::vector<T>& values)
    {
        PreparedArray where;
        value(where);
        if (where.offset > file_.size() || where.count > (file_.size() - where.offset) / sizeof(T))
            fail("array beyond the end");
        if constexpr (std::is_same_v<T, float>)
            values = makeLargeArray(where.count, executor_);
        else
            values.resize(where.count);
        if (read(where.offset, std::as_writable_bytes(std::span(values))) != where.hash)
            fail("damaged array");
    }

    template <class T>
    void resize(std::vector<T>& list)
    {
        std::uint64_t size = 0;
        value(size);
        if (size > table_.size() - at_) // each takes a byte at least
            fail("list beyond the end");
        list.resize(size);
    }

    [[noreturn]] void fail(const char* what) const { throw Error(file_.path(), what); }

private:
    const std::byte* take(std::uint64_t size)
    {
        if (size > table_.size() - at_)
            fail("table ends too early");
        at_ += size;
        return table_.data() + (at_ - size);
    }

    std::uint64_t read(std::uint64_t offset, std::span<std::byte> bytes)
    {
        return forPreparedPieces(bytes, executor_, progress_, [&](std::size_t at, std::span<std::byte> piece) {
            file_.readAt(offset + at, piece, "an array");
        });
    }

    const InputFile& file_;
    const Executor& executor_;
    Progress& progress_;
    std::vector<std::byte> table_;
    std::size_t at_ = 0;
};

bool isSound(const RegionTree& tree)
{
    const auto nodeIsSound = [&](const KdNode& node) {
        const std::size_t self = std::size_t(&node - tree.nodes.data());
        if (node.axis != 3)
            return node.child > self && std::size_t(node.child) + 1 < tree.nodes.size();
        return node.child == KdNode::emptyLeaf || node.child < tree.regions.size();
    };
    const auto regionIsSound = [&](const Region& region) {
        return std::uint64_t(region.firstBrick) + region.brickCount <= tree.brickLists.size();
    };
    const auto brickIsSound = [&](const PaddedBrick& brick) {
        const vec3i n = brick.paddedSize();
        const std::uint64_t cells = std::uint64_t(n.x) * std::uint64_t(n.y) * std::uint64_t(n.z);
        return brick.begin <= tree.paddedCellCount && cells <= tree.paddedCellCount - brick.begin;
    };
    return !tree.nodes.empty() && std::ranges::all_of(tree.nodes, nodeIsSound) &&
           std::ranges::all_of(tree.regions, regionIsSound) && std::ranges::all_of(tree.bricks, brickIsSound) &&
           std::ranges::all_of(tree.brickLists, [&](std::uint32_t brick) { return brick < tree.bricks.size(); });
}

bool isSound(const RegionTree& tree, const std::vector<std::shared_ptr<const PaddedField>>& fields)
{
    const std::size_t n = tree.regions.size();
    return isSound(tree) && std::ranges::all_of(fields, [&](const auto& field) {
               return field->values.size() == tree.paddedCellCount && field->regionRanges.size() == n &&
                      field->regionSlopes.size() == n && field->regionLogSlopes.size() == n;
           });
}

} // namespace

PreparedVolume readPrepared(const std::string& path, const std::string& key, const Executor& executor,
                            Progress& progress)
{
    const InputFile file(path);
    progress.begin("reading the cache", file.size());
    PreparedReader reader(file, executor, progress);
    std::string found;
    reader.text(found);
    if (found != key)
        reader.fail("made from other data");
    PreparedVolume volume;
    PreparedVisit(reader).visit(volume);
    checkBricks(volume.model.bricks, path);
    bool sound = volume.fields.size() == volume.model.fields.size() && isSound(*volume.regions, volume.fields) &&
                 volume.regions->bricks.size() == volume.model.bricks.size();
    for (const PyramidMember& member : volume.pyramid)
        sound = sound && member.fields.size() == volume.fields.size() && isSound(*member.regions, member.fields);
    if (!sound)
        reader.fail("damaged regions");
    volume.fromCache = true;
    progress.end();
    return volume;
}

} // namespace brickwall
