// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/DataStamp.h"

#include "brickwall/core/base/ContentHash.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/InputFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace brickwall {
namespace {

constexpr std::uint64_t looked = 1 << 16; // bytes at the beginning and at the end

std::string timeOf(const std::string& path)
{
    const auto changed = std::filesystem::last_write_time(path).time_since_epoch().count();
    return fmt::format("{} {} {}", std::filesystem::canonical(path).string(), std::filesystem::file_size(path),
                       changed);
}

std::string contentOf(const std::string& path)
{
    const InputFile file(path);
    std::vector<std::byte> bytes(std::min(looked, file.size()));
    file.readAt(0, std::span(bytes), "its beginning");
    const std::uint64_t hash = contentHash(bytes);
    file.readAt(file.size() - bytes.size(), std::span(bytes), "its end");
    return fmt::format("{:016x}", contentHash(bytes, hash));
}

/// A line for each file; nothing if one of them cannot be read.
template <class LineOf>
std::string linesOf(std::span<const std::string> files, const LineOf& lineOf)
{
    std::string lines;
    try {
        for (const std::string& file : files)
            lines += lineOf(file) + '\n';
    } catch (const Error&) {
        return {};
    } catch (const std::filesystem::filesystem_error&) {
        return {};
    }
    return lines;
}

} // namespace

std::string stampOf(std::span<const std::string> files)
{
    return linesOf(files, [](const std::string& file) { return timeOf(file) + ' ' + contentOf(file); });
}

std::string timesOf(std::span<const std::string> files)
{
    return linesOf(files, timeOf);
}

} // namespace brickwall
