// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/AmrexFab.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/AmrexHeader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace brickwall {
namespace {

/// "(8, (64 11 52 0 1 12 0 1023))" as a list of numbers.
std::vector<std::int64_t> readList(TextCursor& text, const std::string& what)
{
    text.expect("(", what);
    const std::int64_t count = text.integer(what, 1, 64);
    text.expect(",", what);
    text.expect("(", what);
    std::vector<std::int64_t> list;
    for (std::int64_t i = 0; i < count; ++i)
        list.push_back(text.integer(what, 0, INT64_MAX));
    text.expect(")", what);
    text.expect(")", what);
    return list;
}

void readNumberFormat(TextCursor& text, const std::string& place, FabLayout& layout)
{
    const std::vector<std::int64_t> floatBits{32, 8, 23, 0, 1, 9, 0, 127}, doubleBits{64, 11, 52, 0, 1, 12, 0, 1023};
    text.expect("(", "the number format of the FAB");
    const auto bits = readList(text, "the bits of a number");
    text.expect(",", "the number format of the FAB");
    const auto order = readList(text, "the order of bytes");
    text.expect(")", "the number format of the FAB");
    if (bits != floatBits && bits != doubleBits)
        throw Error(place,
                    fmt::format("expected IEEE numbers of 32 or 64 bits, found bits ({})", fmt::join(bits, " ")));
    layout.bytes = bits == floatBits ? 4 : 8;
    std::vector<std::int64_t> normal;
    for (int i = 1; i <= layout.bytes; ++i)
        normal.push_back(i);
    const std::vector<std::int64_t> reverse(normal.rbegin(), normal.rend());
    if (order != normal && order != reverse)
        throw Error(place, fmt::format("expected the byte order 1 to {} or {} to 1, found ({})", layout.bytes,
                                       layout.bytes, fmt::join(order, " ")));
    layout.bigEndian = order == normal;
}

template <class T, class Bits>
double decode(const std::byte* bytes, bool swap)
{
    Bits bits;
    std::memcpy(&bits, bytes, sizeof(bits));
    if (swap)
        bits = sizeof(bits) == 4 ? __builtin_bswap32(static_cast<std::uint32_t>(bits)) : __builtin_bswap64(bits);
    return std::bit_cast<T>(bits);
}

} // namespace

FabLayout readFabLayout(const InputFile& file, std::uint64_t offset)
{
    const std::string place = fmt::format("{}: FAB at byte {}", file.path(), offset);
    if (offset >= file.size())
        throw Error(place, fmt::format("expected a FAB, found the end of the file at byte {}", file.size()));
    std::string line(std::min<std::uint64_t>(1024, file.size() - offset), '\0');
    file.readAt(offset, std::span<char>(line), "the header of a FAB");
    const std::size_t end = line.find('\n');
    if (!line.starts_with("FAB ") || end == std::string::npos)
        throw Error(place, "expected a header line 'FAB ((...', found something else");
    line.resize(end);

    TextCursor text(place, line);
    text.expect("FAB", "the header of a FAB");
    FabLayout layout;
    readNumberFormat(text, place, layout);
    layout.box = readAmrexBox(text);
    layout.components = text.integer("the number of components", 1, 1 << 20);
    layout.offset = offset + end + 1;

    // Extents are below 2^32, so that dividing step by step keeps the products from overflowing.
    std::uint64_t room = (file.size() - layout.offset) / layout.bytes / layout.components;
    for (int axis = 0; axis < 3; ++axis)
        room /= static_cast<std::uint64_t>(layout.box.extent()[axis]);
    if (room == 0)
        throw Error(
            place,
            fmt::format("truncated: {} components of {} x {} x {} numbers of {} bytes reach beyond the end of the "
                        "file at byte {}",
                        layout.components, layout.box.extent().x, layout.box.extent().y, layout.box.extent().z,
                        layout.bytes, file.size()));
    return layout;
}

FabPlanes::FabPlanes(const InputFile& file, const FabLayout& layout, std::int64_t component, int zBegin, int zEnd)
    : layout_(layout), zBegin_(zBegin)
{
    const vec3i size = layout.box.extent();
    const std::uint64_t plane = std::uint64_t(size.x) * size.y * layout.bytes;
    const std::uint64_t first = static_cast<std::uint64_t>(component) * size.z + (zBegin - layout.box.lower.z);
    bytes_.resize(plane * static_cast<std::uint64_t>(zEnd - zBegin));
    file.readAt(layout.offset + first * plane, std::span<std::byte>(bytes_), "a component of a FAB");
}

double FabPlanes::at(int x, int y, int z) const
{
    const vec3i size = layout_.box.extent();
    const std::uint64_t row = std::uint64_t(z - zBegin_) * size.y + (y - layout_.box.lower.y);
    const std::byte* number = bytes_.data() + (row * size.x + (x - layout_.box.lower.x)) * layout_.bytes;
    const bool swap = layout_.bigEndian != (std::endian::native == std::endian::big);
    return layout_.bytes == 4 ? decode<float, std::uint32_t>(number, swap)
                              : decode<double, std::uint64_t>(number, swap);
}

} // namespace brickwall
