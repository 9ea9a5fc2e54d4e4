// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/CacheFile.h"
#include "brickwall/core/io/OutputFile.h"
#include "brickwall/core/io/Writers.h"

#include <fmt/format.h>

#include <utility>

namespace brickwall {
namespace {

std::uint64_t aligned(std::uint64_t offset)
{
    return (offset + cacheAlignment - 1) / cacheAlignment * cacheAlignment;
}

/// Writes one .brickwall file (CacheFile.h).
class CacheWriter : public Writer
{
public:
    CacheWriter(const Output& output, OutputFiles& files) : output_(output), file_(files.file(output.path), output.path)
    {
    }

    void write(const SelectedValues& values, const Executor& executor, Progress& progress) override
    {
        const Field& field = values.field();
        progress.begin(fmt::format("writing {}", field.name), output_.cells.cellCount);
        const std::uint64_t begin = aligned(end_);
        forEachPiece(output_.cells, values, executor, progress,
                     [&](std::size_t brick, std::uint64_t first, std::span<const float> piece) {
                         const std::uint64_t cell = output_.cells.bricks[brick].begin + first;
                         file_.writeAt(begin + cell * sizeof(float), bytesOf(piece));
                     });
        end_ = begin + output_.cells.cellCount * sizeof(float);
        fields_.push_back({{begin, field.preferredRange, static_cast<std::uint32_t>(field.name.size()),
                            static_cast<std::uint32_t>(field.unit.size())},
                           field.name + field.unit});
        progress.end();
    }

    void finish() override
    {
        CacheHeader header;
        header.magic = cacheMagic;
        header.version = cacheVersion;
        header.tableOffset = end_;
        header.cellCount = output_.cells.cellCount;
        header.brickCount = output_.cells.bricks.size();
        header.fieldCount = fields_.size();
        header.meshCount = static_cast<std::uint32_t>(output_.model.meshes.size());
        for (int i = 0; i < 16; ++i)
            header.worldFromVoxel[i] = output_.model.worldFromVoxel[i / 4][i % 4];
        putTable();
        header.fileSize = end_;
        file_.writeAt(0, std::as_bytes(std::span(&header, 1)));
        file_.close();
    }

private:
    void put(std::span<const std::byte> bytes)
    {
        file_.writeAt(end_, bytes);
        end_ += bytes.size();
    }

    void putTable()
    {
        std::vector<CacheBrick> bricks;
        for (const Brick& b : output_.cells.bricks)
            bricks.push_back({b.lower, b.size, b.level});
        put(bytesOf(std::span(bricks)));
        for (const auto& [field, names] : fields_) {
            put(std::as_bytes(std::span(&field, 1)));
            put(bytesOf(names));
        }
        for (const TriangleMesh& mesh : output_.model.meshes) {
            const CacheMesh counts{mesh.vertices.size(), mesh.triangles.size()};
            put(std::as_bytes(std::span(&counts, 1)));
            put(bytesOf(std::span(mesh.vertices)));
            put(bytesOf(std::span(mesh.triangles)));
        }
    }

    const Output& output_;
    OutputFile file_;
    std::uint64_t end_ = sizeof(CacheHeader); ///< of what is written
    std::vector<std::pair<CacheField, std::string>> fields_;
};

} // namespace

std::unique_ptr<Writer> makeCacheWriter(const Output& output, OutputFiles& files, const Executor&, Progress&)
{
    return std::make_unique<CacheWriter>(output, files);
}

} // namespace brickwall
