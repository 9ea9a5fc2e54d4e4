// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace brickwall {

/// How a number is stored in a file.
enum class NumberType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

int bytesOf(NumberType type);

/// By its usual names, in any case: those of the enumerators, of VTK ("UInt8", "Float32"), of NRRD and C ("unsigned
/// char", "short", "ushort", "float", "double").
std::optional<NumberType> numberTypeNamed(std::string_view name);

/// The first numbers of `bytes`, as many as `values` has; every `stride`th of them.
void decodeNumbers(NumberType type, bool bigEndian, std::span<const std::byte> bytes, std::size_t stride,
                   std::span<double> values);

} // namespace brickwall
