// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/InputFile.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// Binary data of a VTK XML file, from front to back. Every error is an Error at `place`.
class VtkBytes
{
public:
    virtual ~VtkBytes() = default;

    virtual void read(std::span<std::byte> bytes) = 0;
    /// No more than so many bytes are left.
    virtual std::uint64_t most() const = 0;
};

// What they are given has to outlive them.
std::unique_ptr<VtkBytes> rawBytes(const InputFile& file, std::uint64_t offset, const std::string& place);
/// Base64 (RFC 4648) with blanks anywhere and any number of sections that end with "=", as VTK encodes headers and data
/// apart.
std::unique_ptr<VtkBytes> base64Bytes(const InputFile& file, std::uint64_t offset, const std::string& place);
std::unique_ptr<VtkBytes> base64Bytes(std::string_view text, const std::string& place);

/// How the numbers in front of the data are stored.
struct VtkEncoding
{
    int headerBytes = 4;
    bool bigEndian = false;
    bool compressed = false; ///< in blocks, by zlib
};

/// The `expected` bytes of an array. Throws Error if the headers say otherwise, before memory is asked for.
std::vector<std::byte> unpackVtk(VtkBytes& in, const VtkEncoding& encoding, std::uint64_t expected,
                                 const std::string& place);

} // namespace brickwall
