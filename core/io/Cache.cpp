// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/CacheFile.h"
#include "brickwall/core/io/EmptyCells.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/model/CheckModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace brickwall {
namespace {

constexpr std::size_t chunk = 1 << 20; // values that are read at a time

/// Everything but the values.
struct CacheTable
{
    std::vector<Brick> bricks;
    std::vector<Field> fields;          ///< without values
    std::vector<std::uint64_t> offsets; ///< of the fields' values
    std::vector<TriangleMesh> meshes;
};

/// Takes a table apart from front to back; no size in it is believed before it fits what is left.
class TableReader
{
public:
    TableReader(const std::string& place, std::vector<std::byte> bytes) : place_(place), bytes_(std::move(bytes)) {}

    template <class T>
    T record(const char* what)
    {
        T value;
        std::memcpy(static_cast<void*>(&value), take(sizeof(T), 1, what), sizeof(T));
        return value;
    }

    template <class T>
    std::vector<T> records(std::uint64_t count, const char* what)
    {
        const std::byte* from = take(sizeof(T), count, what);
        std::vector<T> values(count);
        if (count > 0)
            std::memcpy(static_cast<void*>(values.data()), from, count * sizeof(T));
        return values;
    }

    void expectEnd() const
    {
        if (at_ != bytes_.size())
            throw Error(place_, fmt::format("expected the end of the table, found {} bytes more", bytes_.size() - at_));
    }

private:
    const std::byte* take(std::uint64_t size, std::uint64_t count, const char* what)
    {
        if (count > (bytes_.size() - at_) / size)
            throw Error(place_, fmt::format("expected {} ({} times {} bytes), found {} bytes left in the table", what,
                                            count, size, bytes_.size() - at_));
        const std::byte* from = bytes_.data() + at_;
        at_ += size * count;
        return from;
    }

    const std::string& place_;
    std::vector<std::byte> bytes_;
    std::size_t at_ = 0;
};

CacheHeader readHeader(const InputFile& file)
{
    CacheHeader header;
    file.readAt(0, std::span(&header, 1), "the header");
    if (header.version != cacheVersion)
        throw Error(file.path(), fmt::format("expected a .brickwall file of version {}, found version {}; convert the "
                                             "original again",
                                             cacheVersion, header.version));
    if (header.fileSize != file.size())
        throw Error(file.path(),
                    fmt::format("{}: expected {} bytes, as its header says, found {}",
                                file.size() < header.fileSize ? "truncated" : "damaged", header.fileSize, file.size()));
    if (header.tableOffset < sizeof header || header.tableOffset > file.size())
        throw Error(file.path(), fmt::format("expected a table from byte {} to {}, found byte {}", sizeof header,
                                             file.size(), header.tableOffset));
    return header;
}

std::vector<Brick> bricksOf(const std::vector<CacheBrick>& records)
{
    std::vector<Brick> bricks;
    std::uint64_t begin = 0;
    for (const CacheBrick& r : records) {
        bricks.push_back({r.lower, r.size, r.level, begin});
        begin += bricks.back().cellCount();
    }
    return bricks;
}

Field fieldOf(TableReader& table, const CacheField& record)
{
    Field field;
    const auto text = [&](std::uint32_t size, const char* what) {
        const std::vector<char> letters = table.records<char>(size, what);
        return std::string(letters.begin(), letters.end());
    };
    field.name = text(record.nameSize, "a field's name");
    field.unit = text(record.unitSize, "a field's unit");
    field.preferredRange = record.preferredRange.lo < record.preferredRange.hi ? record.preferredRange : Range();
    return field;
}

void checkPlaceOfValues(const InputFile& file, const CacheHeader& header, const Field& field, std::uint64_t offset)
{
    const std::uint64_t room = header.tableOffset < offset ? 0 : (header.tableOffset - offset) / sizeof(float);
    if (offset % sizeof(float) != 0 || offset < sizeof header || header.cellCount > room)
        throw Error(file.path(), fmt::format("expected the {} values of field '{}' between header and table, found "
                                             "them at byte {}",
                                             header.cellCount, field.name, offset));
}

CacheTable readTable(const InputFile& file, const CacheHeader& header)
{
    std::vector<std::byte> bytes(file.size() - header.tableOffset);
    file.readAt(header.tableOffset, std::span(bytes), "the table");
    TableReader reader(file.path(), std::move(bytes));
    CacheTable table;
    table.bricks = bricksOf(reader.records<CacheBrick>(header.brickCount, "bricks"));
    checkBricks(table.bricks, file.path());
    const std::uint64_t cells = table.bricks.empty() ? 0 : table.bricks.back().begin + table.bricks.back().cellCount();
    if (cells != header.cellCount)
        throw Error(file.path(), fmt::format("expected {} cells, as its header says, found bricks with {}",
                                             header.cellCount, cells));
    for (std::uint64_t f = 0; f < header.fieldCount; ++f) {
        const auto record = reader.record<CacheField>("a field");
        table.fields.push_back(fieldOf(reader, record));
        table.offsets.push_back(record.offset);
        checkPlaceOfValues(file, header, table.fields.back(), record.offset);
    }
    for (std::uint32_t m = 0; m < header.meshCount; ++m) {
        const auto counts = reader.record<CacheMesh>("a mesh");
        TriangleMesh mesh{reader.records<vec3f>(counts.vertexCount, "vertices"),
                          reader.records<vec3i>(counts.triangleCount, "triangles")};
        for (const vec3i& t : mesh.triangles)
            for (int corner = 0; corner < 3; ++corner)
                if (t[corner] < 0 || std::size_t(t[corner]) >= mesh.vertices.size())
                    throw Error(file.path(), fmt::format("mesh {}: expected a vertex from 0 to {}, found {}", m,
                                                         std::int64_t(mesh.vertices.size()) - 1, t[corner]));
        table.meshes.push_back(std::move(mesh));
    }
    reader.expectEnd();
    return table;
}

/// What `brickwall convert` wrote for itself (CacheFile.h).
class Cache : public DataSet
{
public:
    explicit Cache(const std::string& path) : path_(path)
    {
        const InputFile file(path);
        header_ = readHeader(file);
        table_ = readTable(file, header_);
    }

    std::string format() const override { return "Brickwall cache"; }

    std::vector<std::string> fieldNames() const override
    {
        std::vector<std::string> names;
        for (const Field& field : table_.fields)
            names.push_back(field.name);
        return names;
    }

    std::string defaultField() const override { return table_.fields.empty() ? "" : table_.fields[0].name; }

    std::vector<std::string> files() const override { return {path_}; }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const auto wanted = fieldIndices(fieldNames(), fields, path_);
        Model model;
        model.name = stemOf(path_);
        model.bricks = table_.bricks;
        model.cellCount = header_.cellCount;
        model.meshes = table_.meshes;
        for (int i = 0; i < 16; ++i)
            model.worldFromVoxel[i / 4][i % 4] = header_.worldFromVoxel[i];
        const InputFile file(path_);
        for (const std::size_t f : wanted)
            model.fields.push_back(read(file, f, executor, progress));
        if (nonFinite == NonFinite::empty)
            leaveOutNonFinite(model, path_, executor, progress);
        for (const std::string& note : model.notes)
            progress.note(note);
        checkModel(model, path_);
        return model;
    }

private:
    Field read(const InputFile& file, std::size_t index, const Executor& executor, Progress& progress) const
    {
        Field field = table_.fields[index];
        progress.begin(fmt::format("reading {}", field.name), header_.cellCount);
        field.values.resize(header_.cellCount);
        executor.forEach(field.values.size(), chunk, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; i += chunk) {
                progress.check();
                const std::size_t n = std::min(chunk, end - i);
                file.readAt(table_.offsets[index] + i * sizeof(float), std::span(field.values).subspan(i, n), "values");
                progress.advance(n);
            }
        });
        field.range = rangeOf(field.values);
        progress.end();
        return field;
    }

    std::string path_;
    CacheHeader header_;
    CacheTable table_;
};

} // namespace

std::unique_ptr<DataSet> openCache(const std::string& data)
{
    const std::string start = fileStart(data, cacheMagic.size());
    if (!std::equal(start.begin(), start.end(), cacheMagic.begin(), cacheMagic.end()))
        return nullptr;
    return std::make_unique<Cache>(data);
}

} // namespace brickwall
