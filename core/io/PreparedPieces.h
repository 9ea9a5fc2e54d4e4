// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/ContentHash.h"
#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/PreparedFile.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace brickwall {

/// Calls body(at, piece) for every piece of an array, in parallel, and returns the hash of the pieces' hashes
/// (PreparedArray), which are taken after that. Throws Cancelled.
template <class Byte, class Body>
std::uint64_t forPreparedPieces(std::span<Byte> bytes, const Executor& executor, Progress& progress, const Body& body)
{
    std::vector<std::uint64_t> hashes((bytes.size() + preparedPiece - 1) / preparedPiece);
    executor.forEach(hashes.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            progress.check();
            const std::size_t at = i * preparedPiece;
            const auto piece = bytes.subspan(at, std::min(preparedPiece, bytes.size() - at));
            body(at, piece);
            hashes[i] = contentHash(piece);
            progress.advance(piece.size());
        }
    });
    return contentHash(std::as_bytes(std::span(hashes)));
}

} // namespace brickwall
