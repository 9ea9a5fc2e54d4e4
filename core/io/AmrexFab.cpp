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

void swapBytes(std::span<double> values)
{
    for (double& v : values)
        v = std::bit_cast<double>(__builtin_bswap64(std::bit_cast<std::uint64_t>(v)));
}

/// Floats at the end of the same memory become doubles, first to last: a double never reaches beyond its own float.
void widen(std::span<double> values, bool swap)
{
    std::byte* const bytes = reinterpret_cast<std::byte*>(values.data());
    const std::byte* in = bytes + values.size() * sizeof(float);
    for (std::size_t i = 0; i < values.size(); ++i, in += sizeof(float)) {
        std::uint32_t bits;
        std::memcpy(&bits, in, sizeof(bits));
        values[i] = std::bit_cast<float>(swap ? __builtin_bswap32(bits) : bits);
    }
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

void readFabPlanes(const InputFile& file, const FabLayout& layout, std::int64_t component, int zBegin, int zEnd,
                   std::vector<double>& values)
{
    const vec3i size = layout.box.extent();
    const std::uint64_t plane = std::uint64_t(size.x) * size.y;
    const std::uint64_t first = static_cast<std::uint64_t>(component) * size.z + (zBegin - layout.box.lower.z);
    values.resize(plane * static_cast<std::uint64_t>(zEnd - zBegin));
    const std::span<std::byte> bytes = std::as_writable_bytes(std::span(values));
    file.readAt(layout.offset + first * plane * layout.bytes, bytes.last(values.size() * layout.bytes),
                "a component of a FAB");
    const bool swap = layout.bigEndian != (std::endian::native == std::endian::big);
    if (layout.bytes == 4)
        widen(values, swap);
    else if (swap)
        swapBytes(values);
}

} // namespace brickwall
