// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/ContentHash.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/OutputFile.h"
#include "brickwall/core/io/OutputFiles.h"
#include "brickwall/core/io/PreparedFile.h"
#include "brickwall/core/io/PreparedPieces.h"
#include "brickwall/core/io/PreparedVisit.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <span>
#include <type_traits>

namespace brickwall {
namespace {

/// The archive (PreparedVisit.h) that writes arrays at once and gathers the table.
class PreparedWriter
{
public:
    PreparedWriter(OutputFile& file, const Executor& executor, Progress& progress)
        : file_(file), executor_(executor), progress_(progress)
    {
    }

    template <class T>
    void value(const T& value)
    {
        const auto bytes = std::as_bytes(std::span(&value, 1));
        table_.insert(table_.end(), bytes.begin(), bytes.end());
    }

    void text(const std::string& text)
    {
        value(std::uint64_t(text.size()));
        const auto bytes = bytesOf(text);
        table_.insert(table_.end(), bytes.begin(), bytes.end());
    }

    template <class T>
    void array(const std::vector<T>& values)
    {
        end_ = (end_ + alignment - 1) / alignment * alignment;
        if constexpr (std::is_same_v<T, Brick> || std::is_same_v<T, PaddedBrick>)
            value(PreparedArray{values.size(), end_, write(withoutGaps(values))});
        else
            value(PreparedArray{values.size(), end_, write(std::as_bytes(std::span(values)))});
        end_ += values.size() * sizeof(T);
    }

    template <class T>
    void resize(const std::vector<T>& list)
    {
        value(std::uint64_t(list.size()));
    }

    void finish()
    {
        file_.writeAt(end_, table_);
        const PreparedHeader header{preparedMagic, preparedVersion, 0, end_ + table_.size(), end_, contentHash(table_)};
        file_.writeAt(0, std::as_bytes(std::span(&header, 1)));
        file_.close();
    }

private:
    static constexpr std::uint64_t alignment = 4096;

    /// What happens to lie between the members is nothing to be written down.
    template <class AnyBrick>
    static std::vector<std::byte> withoutGaps(const std::vector<AnyBrick>& bricks)
    {
        std::vector<std::byte> bytes(bricks.size() * sizeof(AnyBrick));
        std::byte* to = bytes.data();
        for (const AnyBrick& b : bricks) {
            std::memcpy(to, &b, offsetof(AnyBrick, level) + sizeof b.level);
            std::memcpy(to + offsetof(AnyBrick, begin), &b.begin, sizeof b.begin);
            to += sizeof b;
        }
        return bytes;
    }

    std::uint64_t write(std::span<const std::byte> bytes)
    {
        return forPreparedPieces(bytes, executor_, progress_, [&](std::size_t at, std::span<const std::byte> piece) {
            file_.writeAt(end_ + at, piece);
        });
    }

    OutputFile& file_;
    const Executor& executor_;
    Progress& progress_;
    std::uint64_t end_ = sizeof(PreparedHeader); ///< of what is written
    std::vector<std::byte> table_;
};

/// A file under a temporary name: there is none when this ends, unless it was renamed. Unlike OutputFiles it takes the
/// place of an older one in one step, as other processes read that.
class TemporaryFile
{
public:
    explicit TemporaryFile(const std::string& path) : path_(path), name_(temporaryName(path)) {}
    ~TemporaryFile() { std::remove(name_.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const std::string& name() const { return name_; }

    void rename() const
    {
        if (std::rename(name_.c_str(), path_.c_str()) != 0)
            throw Error(path_, fmt::format("cannot be written: {}", std::strerror(errno)));
    }

private:
    std::string path_, name_;
};

} // namespace

std::string preparedKey(const VolumeRequest& request, const std::string& stamp)
{
    return fmt::format("{}\n{}\n{}\n{}{}\n{}", request.data, fmt::join(request.derive, "\n"),
                       fmt::join(request.fields, "\n"), request.nonFinite == NonFinite::empty ? "empty" : "error",
                       request.pyramid ? " pyramid" : "", stamp);
}

void writePrepared(const std::string& path, const std::string& key, const PreparedVolume& volume,
                   const Executor& executor, Progress& progress)
{
    progress.begin("writing the cache", volume.bytes());
    const TemporaryFile temporary(path);
    OutputFile file(temporary.name(), path);
    PreparedWriter writer(file, executor, progress);
    writer.text(key);
    PreparedVolume shown = volume; // its arrays are shared
    PreparedVisit(writer).visit(shown);
    writer.finish();
    temporary.rename();
    progress.end();
}

} // namespace brickwall
