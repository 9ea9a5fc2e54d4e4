// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VdbTreeCheck.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace brickwall {
namespace {

class TreeWalk
{
public:
    TreeWalk(const InputFile& file, std::uint64_t at, const VdbStorage& storage, const std::string& place)
        : file_(file), at_(at), storage_(storage), place_(place)
    {
    }

    void walk()
    {
        number<std::int32_t>();    // of buffers
        skip(storage_.valueBytes); // the background
        const auto tiles = number<std::uint32_t>(), children = number<std::uint32_t>();
        for (std::uint32_t i = 0; i < tiles; ++i) {
            checkOrigin();
            skip(storage_.valueBytes);
            if (const auto active = number<std::uint8_t>(); active > 1)
                fail(fmt::format("expected 0 or 1 for whether a tile is active, found {}", active));
        }
        std::array<std::int32_t, 3> last{};
        for (std::uint32_t i = 0; i < children; ++i) {
            // OpenVDB reads values in this order, whatever the file's, and one child per place.
            const auto origin = checkOrigin();
            if (i > 0 && origin <= last)
                fail("expected the nodes of a tree in the order of their places");
            last = origin;
            const std::uint32_t inner = internalNode(5);
            for (std::uint32_t k = 0; k < inner; ++k) {
                const std::uint32_t leaves = internalNode(4);
                for (std::uint32_t l = 0; l < leaves; ++l)
                    leafCounts_.push_back(static_cast<std::uint16_t>(countOf(mask(leafSize))));
            }
        }
        for (const std::uint16_t active : leafCounts_) {
            skip(leafSize / 8); // the mask again
            values(leafSize, active);
        }
    }

private:
    static constexpr std::uint32_t leafSize = 8 * 8 * 8;
    static constexpr int rootLog2 = 12;

    [[noreturn]] void fail(const std::string& message) const
    {
        throw Error(fmt::format("{}: byte {}", place_, at_), message);
    }

    void skip(std::uint64_t bytes)
    {
        if (bytes > file_.size() - at_)
            fail(fmt::format("truncated: {} bytes are needed, but the file ends at byte {}", bytes, file_.size()));
        at_ += bytes;
    }

    void read(void* out, std::uint64_t bytes)
    {
        const std::uint64_t begin = at_;
        skip(bytes);
        if (begin < bufferBegin_ || at_ > bufferBegin_ + buffer_.size()) {
            buffer_.resize(std::min(std::max<std::uint64_t>(bytes, 1 << 16), file_.size() - begin));
            file_.readAt(begin, std::span<std::byte>(buffer_), "a tree");
            bufferBegin_ = begin;
        }
        std::memcpy(out, buffer_.data() + (begin - bufferBegin_), bytes);
    }

    template <class T>
    T number()
    {
        T value{};
        read(&value, sizeof(T));
        return value;
    }

    std::vector<std::uint64_t> mask(std::uint32_t size)
    {
        std::vector<std::uint64_t> words(size / 64);
        read(words.data(), size / 8);
        return words;
    }

    static std::uint32_t countOf(const std::vector<std::uint64_t>& mask)
    {
        std::uint32_t count = 0;
        for (const std::uint64_t word : mask)
            count += static_cast<std::uint32_t>(std::popcount(word));
        return count;
    }

    std::array<std::int32_t, 3> checkOrigin()
    {
        std::array<std::int32_t, 3> origin{};
        for (std::int32_t& o : origin)
            if (o = number<std::int32_t>(); o % (1 << rootLog2) != 0)
                fail(fmt::format("expected a node at a multiple of {}, found {}", 1 << rootLog2, o));
        return origin;
    }

    /// Returns the number of its children.
    std::uint32_t internalNode(int log2Width)
    {
        const std::uint32_t size = std::uint32_t(1) << 3 * log2Width;
        const auto children = mask(size), active = mask(size);
        for (std::size_t i = 0; i < children.size(); ++i)
            if ((children[i] & active[i]) != 0)
                fail("expected a child or a value in each place of a node, found both");
        values(size, countOf(active));
        return countOf(children);
    }

    /// What a node of so many values stores, of which so many are active.
    void values(std::uint32_t size, std::uint32_t active)
    {
        enum Flag { oneInactive = 2, mask = 3, maskOneInactive = 4, maskTwoInactive = 5, all = 6 };
        constexpr std::uint32_t zip = 1, activeMask = 2, blosc = 4;
        const int flag = number<std::int8_t>();
        if (flag == oneInactive || flag == maskOneInactive || flag == maskTwoInactive)
            skip(storage_.valueBytes);
        if (flag == maskTwoInactive)
            skip(storage_.valueBytes);
        if (flag == mask || flag == maskOneInactive || flag == maskTwoInactive)
            skip(size / 8);
        const std::uint32_t count = (storage_.compression & activeMask) && flag != all ? active : size;
        const bool half = storage_.storedBytes != storage_.valueBytes;
        const std::uint64_t bytes = std::uint64_t(count) * storage_.storedBytes;
        if (half && count == 0)
            return; // not even its size is stored
        if (!(storage_.compression & (zip | blosc)))
            return skip(bytes);
        const auto packed = number<std::int64_t>();
        if (packed <= 0 && static_cast<std::uint64_t>(-(packed + 1)) + 1 != bytes && !(packed == 0 && bytes == 0))
            fail(fmt::format("expected {} bytes of values in a node, found {}", bytes, packed));
        if (packed > 0 && (storage_.compression & blosc))
            checkBlosc(file_, at_, static_cast<std::uint64_t>(packed), bytes, place_);
        skip(packed > 0 ? static_cast<std::uint64_t>(packed) : bytes);
    }

    const InputFile& file_;
    std::uint64_t at_;
    VdbStorage storage_;
    std::string place_;
    std::vector<std::uint16_t> leafCounts_; ///< active voxels of the leaves, in the order of their values
    std::vector<std::byte> buffer_;
    std::uint64_t bufferBegin_ = 0;
};

} // namespace

void checkBlosc(const InputFile& file, std::uint64_t at, std::uint64_t packed, std::uint64_t bytes,
                const std::string& place)
{
    // versions and flags, then three sizes: unpacked, of a block, packed
    std::uint32_t header[4] = {};
    if (packed >= sizeof(header))
        file.readAt(at, std::span<std::uint32_t>(header), "the header of packed values");
    if (packed < sizeof(header) || header[1] > bytes || header[3] > packed)
        throw Error(
            fmt::format("{}: byte {}", place, at),
            fmt::format("expected {} bytes in {} packed ones, found {} in {}", bytes, packed, header[1], header[3]));
}

void checkVdbTree(const InputFile& file, std::uint64_t at, const VdbStorage& storage, const std::string& place)
{
    TreeWalk(file, at, storage, place).walk();
}

} // namespace brickwall
