// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VolumeFile.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/TextCursor.h"
#include "brickwall/core/model/Model.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace brickwall {
namespace {

/// Bytes that are read from front to back.
class ByteStream
{
public:
    virtual ~ByteStream() = default;
    virtual void read(std::span<std::byte> bytes) = 0;
};

class RawStream : public ByteStream
{
public:
    RawStream(const std::string& path, std::uint64_t offset) : file_(path), at_(offset) {}

    void read(std::span<std::byte> bytes) override
    {
        file_.readAt(at_, bytes, "a plane of the volume");
        at_ += bytes.size();
    }

private:
    InputFile file_;
    std::uint64_t at_;
};

/// What a gzip stream (RFC 1952) holds, by zlib.
class GzipStream : public ByteStream
{
public:
    GzipStream(const std::string& path, std::uint64_t offset) : file_(path), at_(offset), buffer_(std::size_t(1) << 18)
    {
        constexpr int gzipOrZlib = 32 + MAX_WBITS;
        if (inflateInit2(&zlib_, gzipOrZlib) != Z_OK)
            throw Error(path, "zlib cannot be started");
    }
    ~GzipStream() override { inflateEnd(&zlib_); }
    GzipStream(const GzipStream&) = delete;
    GzipStream& operator=(const GzipStream&) = delete;

    void read(std::span<std::byte> bytes) override
    {
        while (!bytes.empty()) {
            const std::size_t piece = std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max());
            readPiece(bytes.first(piece));
            bytes = bytes.subspan(piece);
        }
    }

private:
    void readPiece(std::span<std::byte> bytes)
    {
        zlib_.next_out = reinterpret_cast<Bytef*>(bytes.data());
        zlib_.avail_out = static_cast<uInt>(bytes.size());
        while (zlib_.avail_out > 0) {
            if (zlib_.avail_in == 0)
                refill();
            const int result = inflate(&zlib_, Z_NO_FLUSH);
            if (result == Z_STREAM_END && zlib_.avail_out > 0)
                throw Error(file_.path(),
                            fmt::format("truncated: its gzip data end after {} bytes, expected more", zlib_.total_out));
            if (result != Z_OK && result != Z_STREAM_END)
                throw Error(file_.path(), fmt::format("its gzip data are broken before byte {}: {}", at_,
                                                      zlib_.msg ? zlib_.msg : "unexpected end"));
        }
    }

    void refill()
    {
        const std::size_t bytes = std::min<std::uint64_t>(buffer_.size(), file_.size() - std::min(at_, file_.size()));
        if (bytes == 0)
            throw Error(
                file_.path(),
                fmt::format("truncated: its gzip data do not end before the file does, at byte {}", file_.size()));
        file_.readAt(at_, std::span(buffer_).first(bytes), "gzip data");
        at_ += bytes;
        zlib_.next_in = reinterpret_cast<Bytef*>(buffer_.data());
        zlib_.avail_in = static_cast<uInt>(bytes);
    }

    InputFile file_;
    std::uint64_t at_;
    std::vector<std::byte> buffer_;
    z_stream zlib_ = {};
};

class StreamPlanes : public VolumePlanes
{
public:
    explicit StreamPlanes(const VolumeFile& volume) : type_(volume.type), bigEndian_(volume.bigEndian)
    {
        if (!volume.gzip) {
            stream_ = std::make_unique<RawStream>(volume.data, volume.offset);
            return;
        }
        stream_ = std::make_unique<GzipStream>(volume.data, volume.offset);
        for (std::uint64_t left = volume.skip; left > 0;) {
            bytes_.resize(std::min<std::uint64_t>(left, 1 << 16));
            stream_->read(bytes_);
            left -= bytes_.size();
        }
    }

    void next(std::span<float> plane) override
    {
        // Row by row would be as good for memory, but slow where rows are short.
        constexpr std::size_t most = 1 << 16;
        for (std::size_t begin = 0; begin < plane.size(); begin += most) {
            const std::size_t count = std::min(most, plane.size() - begin);
            bytes_.resize(count * static_cast<std::size_t>(bytesOf(type_)));
            numbers_.resize(count);
            stream_->read(bytes_);
            decodeNumbers(type_, bigEndian_, bytes_, 1, numbers_);
            std::transform(numbers_.begin(), numbers_.end(), plane.begin() + std::ptrdiff_t(begin),
                           [](double number) { return static_cast<float>(number); });
        }
    }

private:
    NumberType type_;
    bool bigEndian_;
    std::unique_ptr<ByteStream> stream_;
    std::vector<std::byte> bytes_;
    std::vector<double> numbers_;
};

} // namespace

std::unique_ptr<VolumePlanes> openPlanes(const VolumeFile& volume)
{
    return std::make_unique<StreamPlanes>(volume);
}

void checkVolume(const VolumeFile& volume)
{
    constexpr std::uint64_t most = std::uint64_t(1) << 32, gzipFactor = 1032;
    const vec3i& size = volume.size;
    std::uint64_t cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (size[axis] < 1 || size[axis] > coordinateLimit || cells > most / std::uint64_t(size[axis]))
            throw Error(volume.place,
                        fmt::format("expected a size of at least 1 along each axis and at most 2^32 cells "
                                    "in all, found {} x {} x {}",
                                    size.x, size.y, size.z));
        cells *= std::uint64_t(size[axis]);
    }
    const InputFile file(volume.data);
    const std::uint64_t bytes = cells * std::uint64_t(bytesOf(volume.type));
    const std::uint64_t room = file.size() - std::min(volume.offset, file.size());
    if (volume.gzip ? bytes / gzipFactor > room : bytes > room)
        throw Error(volume.data,
                    fmt::format("truncated: {} x {} x {} numbers of {} bytes need {} bytes from byte {}{}, "
                                "but the file ends at byte {}",
                                size.x, size.y, size.z, bytesOf(volume.type), bytes, volume.offset,
                                volume.gzip ? " when unpacked" : "", file.size()));
}

double parseThreshold(const std::string& text, const std::string& place)
{
    double threshold = 0.0;
    if (!text.empty() && (!parseNumber(text, threshold) || !(threshold >= 0.0 && threshold <= 1.0)))
        throw Error(place,
                    fmt::format("expected threshold=T with T from 0 to 1, a share of the range, found '{}'", text));
    return threshold;
}

} // namespace brickwall
