// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Hdf5Objects.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>

namespace brickwall::fuzz {
namespace {

herr_t addAttribute(hid_t owner, const char* name, const H5A_info_t*, void* objects)
{
    char path[256] = {};
    H5Iget_name(owner, path, sizeof path - 1);
    static_cast<Hdf5Objects*>(objects)->attributes.emplace_back(path, name);
    return 0;
}

herr_t addObject(hid_t file, const char* name, const H5O_info_t*, void* objects)
{
    if (std::string(name) != ".")
        static_cast<Hdf5Objects*>(objects)->paths.emplace_back(name);
    const hid_t object = H5Oopen(file, name, H5P_DEFAULT);
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, addAttribute, objects);
    H5Oclose(object);
    return 0;
}

/// Of the number that an element of this type begins with, or the type itself.
hid_t firstNumber(hid_t type)
{
    return H5Tget_class(type) == H5T_COMPOUND ? H5Tget_member_type(type, 0) : H5Tcopy(type);
}

} // namespace

void addObjects(const std::string& path, Hdf5Objects& objects)
{
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, addObject, &objects, H5O_INFO_BASIC);
    H5Fclose(file);
}

double hostileNumber(FuzzedDataProvider& input)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    constexpr double numbers[] = {0.0,          1.0,           -1.0,         2.0,
                                  3.0,          -2.0,          4.0,          7.0,
                                  8.0,          16.0,          0.5,          1e-300,
                                  1e300,        infinite,      -1e9,         65536.0,
                                  1 << 24,      (1 << 28) - 1, 1 << 28,      -(1 << 28),
                                  1 << 29,      1 << 30,       2147483647.0, -2147483648.0,
                                  2147483648.0, 4294967295.0,  4294967296.0, 0x1p53,
                                  0x1p62,       0x1p63,        -0x1p63,      std::numeric_limits<double>::quiet_NaN()};
    const auto choice = input.ConsumeIntegralInRange<std::size_t>(0, std::size(numbers) + 2);
    if (choice < std::size(numbers))
        return numbers[choice];
    if (choice == std::size(numbers))
        return input.ConsumeIntegral<std::int8_t>();
    if (choice == std::size(numbers) + 1)
        return input.ConsumeIntegral<std::int32_t>();
    return input.ConsumeFloatingPoint<double>();
}

hsize_t hostileExtent(FuzzedDataProvider& input)
{
    constexpr hsize_t extents[] = {
        0, 1, 2, 3, 4, 6, 8, 64, 512, 4096, 65536, 1u << 31, hsize_t(1) << 32, hsize_t(1) << 40, hsize_t(1) << 62};
    return input.PickValueInArray(extents);
}

void patch(std::vector<char>& elements, hid_t type, FuzzedDataProvider& input)
{
    const hid_t number = firstNumber(type);
    const H5T_class_t kind = H5Tget_class(number);
    const std::size_t size = std::min<std::size_t>(H5Tget_size(number), 8);
    H5Tclose(number);
    if (elements.size() < size || size == 0)
        return;
    const std::size_t at = size * input.ConsumeIntegralInRange<std::size_t>(0, elements.size() / size - 1);
    const double value = hostileNumber(input);
    const float single = static_cast<float>(value);
    const std::int64_t whole =
        std::abs(value) < 0x1p63 ? static_cast<std::int64_t>(value) : std::numeric_limits<std::int64_t>::min();
    if (kind == H5T_FLOAT && size == sizeof single)
        std::memcpy(elements.data() + at, &single, size);
    else if (kind == H5T_FLOAT)
        std::memcpy(elements.data() + at, &value, size);
    else
        std::memcpy(elements.data() + at, &whole, size); // the lower bytes, as files are little-endian
}

hid_t hostileType(FuzzedDataProvider& input)
{
    const hid_t numbers[] = {H5T_IEEE_F64LE, H5T_IEEE_F32LE, H5T_STD_I32LE,
                             H5T_STD_I64LE,  H5T_STD_U8LE,   H5T_IEEE_F32BE};
    const auto choice = input.ConsumeIntegralInRange<std::size_t>(0, std::size(numbers) + 2);
    if (choice < std::size(numbers))
        return H5Tcopy(numbers[choice]);
    if (choice == std::size(numbers)) {
        const hid_t text = H5Tcopy(H5T_C_S1);
        H5Tset_size(text, input.ConsumeIntegralInRange<std::size_t>(1, 80));
        return text;
    }
    if (choice == std::size(numbers) + 1) {
        const char* names[] = {"lo_i", "lo_j", "lo_k", "hi_i", "hi_j", "hi_k"};
        const hid_t record = H5Tcreate(H5T_COMPOUND, 48);
        for (std::size_t i = 0; i < std::size(names); ++i)
            H5Tinsert(record, names[i], 8 * i, input.ConsumeBool() ? H5T_STD_I64LE : H5T_IEEE_F64LE);
        return record;
    }
    const hsize_t extent = 3;
    return H5Tarray_create2(H5T_STD_I32LE, 1, &extent);
}

} // namespace brickwall::fuzz
