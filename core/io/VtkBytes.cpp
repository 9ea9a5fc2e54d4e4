// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VtkBytes.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>

namespace brickwall {
namespace {

[[noreturn]] void failTruncated(const std::string& place)
{
    throw Error(place, "truncated: its data end before all numbers have been read");
}

class RawBytes : public VtkBytes
{
public:
    RawBytes(const InputFile& file, std::uint64_t offset, const std::string& place)
        : file_(file), at_(std::min(offset, file.size())), place_(place)
    {
    }

    void read(std::span<std::byte> bytes) override
    {
        if (bytes.size() > most())
            failTruncated(place_);
        file_.readAt(at_, bytes, place_);
        at_ += bytes.size();
    }
    std::uint64_t most() const override { return file_.size() - at_; }

private:
    const InputFile& file_;
    std::uint64_t at_;
    std::string place_;
};

/// 0 to 63; -1 for what is no digit.
int base64Digit(char c)
{
    if (c >= 'A' && c <= 'Z')
        return c - 'A';
    if (c >= 'a' && c <= 'z')
        return c - 'a' + 26;
    if (c >= '0' && c <= '9')
        return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
}

class Base64Bytes : public VtkBytes
{
public:
    Base64Bytes(const InputFile& file, std::uint64_t offset, const std::string& place)
        : file_(&file), at_(std::min(offset, file.size())), end_(file.size()), place_(place)
    {
    }
    Base64Bytes(std::string_view text, const std::string& place) : buffer_(text), place_(place) {}

    void read(std::span<std::byte> bytes) override
    {
        for (std::byte& byte : bytes) {
            if (used_ == count_)
                nextGroup();
            byte = static_cast<std::byte>(group_[used_++]);
        }
    }
    std::uint64_t most() const override
    {
        return (end_ - at_ + buffer_.size() - next_ + 3) / 4 * 3 + static_cast<std::uint64_t>(count_ - used_);
    }

private:
    char nextCharacter()
    {
        while (true) {
            if (next_ == buffer_.size())
                refill();
            const char c = buffer_[next_++];
            if (c != ' ' && c != '\n' && c != '\r' && c != '\t')
                return c;
        }
    }

    void refill()
    {
        if (at_ == end_)
            failTruncated(place_);
        storage_.resize(std::min<std::uint64_t>(1 << 16, end_ - at_));
        file_->readAt(at_, std::span<char>(storage_), place_);
        at_ += storage_.size();
        buffer_ = storage_;
        next_ = 0;
    }

    /// Four characters are three bytes, two if the last of them is "=", one if the last two are.
    void nextGroup()
    {
        std::uint32_t bits = 0;
        int digits = 0;
        for (int i = 0; i < 4; ++i) {
            const char c = nextCharacter();
            const int digit = base64Digit(c);
            if (digit < 0 && (c != '=' || i < 2))
                c == '<' ? failTruncated(place_) : throw Error(place_, fmt::format("expected base64, found '{}'", c));
            if (digit >= 0 && digits < i)
                throw Error(place_, "expected the end of a base64 section after '=', found more of it");
            digits += digit >= 0;
            bits = bits << 6 | static_cast<std::uint32_t>(std::max(digit, 0));
        }
        group_ = {static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(bits >> 8),
                  static_cast<std::uint8_t>(bits)};
        count_ = digits - 1;
        used_ = 0;
    }

    const InputFile* file_ = nullptr;
    std::uint64_t at_ = 0; ///< in the file, of what is to be read next
    std::uint64_t end_ = 0;
    std::string storage_;
    std::string_view buffer_;
    std::size_t next_ = 0;
    std::array<std::uint8_t, 3> group_{};
    int count_ = 0; ///< bytes in the group
    int used_ = 0;
    std::string place_;
};

std::uint64_t readNumber(VtkBytes& in, const VtkEncoding& encoding)
{
    std::array<std::byte, 8> raw{};
    const std::size_t size = static_cast<std::size_t>(encoding.headerBytes);
    in.read(std::span(raw).first(size));
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < size; ++i)
        number = number << 8 | static_cast<std::uint64_t>(raw[encoding.bigEndian ? i : size - 1 - i]);
    return number;
}

void checkSize(std::uint64_t expected, std::uint64_t found, const std::string& place)
{
    if (found != expected)
        throw Error(place, fmt::format("expected {} bytes for the cells of its extent, found {}", expected, found));
}

/// [blocks][bytes of a block][bytes of the last one, 0 if it is as the others][packed bytes of each block][blocks]
std::vector<std::byte> unpackBlocks(VtkBytes& in, const VtkEncoding& encoding, std::uint64_t expected,
                                    const std::string& place)
{
    constexpr std::uint64_t zlibFactor = 1032;
    const std::uint64_t blocks = readNumber(in, encoding), full = readNumber(in, encoding);
    const std::uint64_t last = readNumber(in, encoding);
    const std::uint64_t partial = last > 0 ? 1 : 0;
    if (blocks == 0 || blocks > in.most() || last > std::min(full, expected))
        throw Error(place, fmt::format("expected {} bytes in compressed blocks, found {} blocks of {} bytes, the last "
                                       "of {}",
                                       expected, blocks, full, last));
    if (blocks > partial && full > expected / (blocks - partial))
        checkSize(expected, std::uint64_t(-1), place);
    checkSize(expected, (blocks - partial) * full + last, place);
    if (expected / zlibFactor > in.most())
        failTruncated(place);
    std::vector<std::uint64_t> sizes(blocks);
    for (std::uint64_t& size : sizes)
        size = readNumber(in, encoding);
    std::vector<std::byte> bytes(expected), packed;
    std::uint64_t done = 0;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        if (sizes[b] > in.most())
            failTruncated(place);
        packed.resize(sizes[b]);
        in.read(packed);
        const uLong size = b + 1 == blocks && partial ? last : full;
        uLongf found = size;
        const int result = uncompress(reinterpret_cast<Bytef*>(bytes.data() + done), &found,
                                      reinterpret_cast<const Bytef*>(packed.data()), packed.size());
        if (result != Z_OK || found != size)
            throw Error(place, fmt::format("compressed block {} is broken: expected {} bytes in it", b, size));
        done += size;
    }
    return bytes;
}

} // namespace

std::unique_ptr<VtkBytes> rawBytes(const InputFile& file, std::uint64_t offset, const std::string& place)
{
    return std::make_unique<RawBytes>(file, offset, place);
}

std::unique_ptr<VtkBytes> base64Bytes(const InputFile& file, std::uint64_t offset, const std::string& place)
{
    return std::make_unique<Base64Bytes>(file, offset, place);
}

std::unique_ptr<VtkBytes> base64Bytes(std::string_view text, const std::string& place)
{
    return std::make_unique<Base64Bytes>(text, place);
}

std::vector<std::byte> unpackVtk(VtkBytes& in, const VtkEncoding& encoding, std::uint64_t expected,
                                 const std::string& place)
{
    if (encoding.compressed)
        return unpackBlocks(in, encoding, expected, place);
    checkSize(expected, readNumber(in, encoding), place);
    if (expected > in.most())
        failTruncated(place);
    std::vector<std::byte> bytes(expected);
    in.read(bytes);
    return bytes;
}

} // namespace brickwall
