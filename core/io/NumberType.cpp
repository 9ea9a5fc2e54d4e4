// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/NumberType.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

namespace brickwall {
namespace {

template <class T>
void decode(const std::byte* in, bool swap, std::size_t stride, std::span<double> values)
{
    for (double& value : values) {
        std::array<std::byte, sizeof(T)> raw;
        std::memcpy(raw.data(), in, sizeof(T));
        if (swap)
            std::reverse(raw.begin(), raw.end());
        value = static_cast<double>(std::bit_cast<T>(raw));
        in += stride * sizeof(T);
    }
}

constexpr std::pair<std::string_view, NumberType> names[] = {
    {"int8", NumberType::int8},
    {"signed char", NumberType::int8},
    {"int8_t", NumberType::int8},
    {"uint8", NumberType::uint8},
    {"uchar", NumberType::uint8},
    {"unsigned char", NumberType::uint8},
    {"uint8_t", NumberType::uint8},
    {"byte", NumberType::uint8},
    {"int16", NumberType::int16},
    {"short", NumberType::int16},
    {"short int", NumberType::int16},
    {"signed short", NumberType::int16},
    {"signed short int", NumberType::int16},
    {"int16_t", NumberType::int16},
    {"uint16", NumberType::uint16},
    {"ushort", NumberType::uint16},
    {"unsigned short", NumberType::uint16},
    {"unsigned short int", NumberType::uint16},
    {"uint16_t", NumberType::uint16},
    {"int32", NumberType::int32},
    {"int", NumberType::int32},
    {"signed int", NumberType::int32},
    {"int32_t", NumberType::int32},
    {"uint32", NumberType::uint32},
    {"uint", NumberType::uint32},
    {"unsigned int", NumberType::uint32},
    {"uint32_t", NumberType::uint32},
    {"int64", NumberType::int64},
    {"longlong", NumberType::int64},
    {"long long", NumberType::int64},
    {"long long int", NumberType::int64},
    {"signed long long", NumberType::int64},
    {"signed long long int", NumberType::int64},
    {"int64_t", NumberType::int64},
    {"uint64", NumberType::uint64},
    {"ulonglong", NumberType::uint64},
    {"unsigned long long", NumberType::uint64},
    {"unsigned long long int", NumberType::uint64},
    {"uint64_t", NumberType::uint64},
    {"float32", NumberType::float32},
    {"float", NumberType::float32},
    {"float64", NumberType::float64},
    {"double", NumberType::float64},
};

} // namespace

int bytesOf(NumberType type)
{
    constexpr std::array bytes{1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
    return bytes[static_cast<std::size_t>(type)];
}

std::optional<NumberType> numberTypeNamed(std::string_view name)
{
    std::string lower(name);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    for (const auto& [known, type] : names)
        if (known == lower)
            return type;
    return std::nullopt;
}

void decodeNumbers(NumberType type, bool bigEndian, std::span<const std::byte> bytes, std::size_t stride,
                   std::span<double> values)
{
    const bool swap = bigEndian != (std::endian::native == std::endian::big);
    switch (type) {
    case NumberType::int8:
        return decode<std::int8_t>(bytes.data(), swap, stride, values);
    case NumberType::uint8:
        return decode<std::uint8_t>(bytes.data(), swap, stride, values);
    case NumberType::int16:
        return decode<std::int16_t>(bytes.data(), swap, stride, values);
    case NumberType::uint16:
        return decode<std::uint16_t>(bytes.data(), swap, stride, values);
    case NumberType::int32:
        return decode<std::int32_t>(bytes.data(), swap, stride, values);
    case NumberType::uint32:
        return decode<std::uint32_t>(bytes.data(), swap, stride, values);
    case NumberType::int64:
        return decode<std::int64_t>(bytes.data(), swap, stride, values);
    case NumberType::uint64:
        return decode<std::uint64_t>(bytes.data(), swap, stride, values);
    case NumberType::float32:
        return decode<float>(bytes.data(), swap, stride, values);
    case NumberType::float64:
        return decode<double>(bytes.data(), swap, stride, values);
    }
}

} // namespace brickwall
