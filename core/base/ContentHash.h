// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace brickwall {

/// A hash of bytes that tells accidental changes, at the speed of memory; no protection against those who want to
/// deceive. The same on all little-endian machines. Hashes of pieces are joined by passing that of the first as the
/// start of the next, which is not the hash of both at once.
std::uint64_t contentHash(std::span<const std::byte> bytes, std::uint64_t start = 0);

} // namespace brickwall
