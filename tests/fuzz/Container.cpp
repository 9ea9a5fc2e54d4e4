// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Container.h"

#include <algorithm>
#include <filesystem>

namespace brickwall::fuzz {
namespace {

constexpr std::string_view mark = "=== ";

bool harmless(const std::string& name)
{
    constexpr std::size_t longest = 100;
    const auto allowed = [](unsigned char c) {
        return std::isalnum(c) || c == '.' || c == '_' || c == '-' || c == '/';
    };
    if (name.empty() || name.size() > longest || !std::all_of(name.begin(), name.end(), allowed))
        return false;
    for (const auto& part : std::filesystem::path(name))
        if (part == ".." || part == "." || part == "/" || part.empty())
            return false;
    return true;
}

/// Whether a file of this name can be made: nothing is there, and no file where a folder has to be.
bool isFree(const std::string& name)
{
    std::error_code error;
    const std::filesystem::path path = std::filesystem::path(scratchFolder()) / name;
    std::filesystem::create_directories(path.parent_path(), error);
    return !error && !std::filesystem::exists(path, error);
}

} // namespace

std::string unpack(Input input, const std::string& folder)
{
    std::string_view rest = asText(input);
    std::string first;
    while (rest.starts_with(mark)) {
        const std::size_t lineEnd = std::min(rest.find('\n'), rest.size());
        const std::string_view head = rest.substr(mark.size(), lineEnd - mark.size());
        rest.remove_prefix(std::min(lineEnd + 1, rest.size()));
        const std::size_t end = rest.starts_with(mark) ? 0 : rest.find("\n" + std::string(mark));
        const std::string_view content = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + (end > 0));

        const std::size_t blank = std::min(head.find(' '), head.size());
        const std::string own(head.substr(0, blank)), name = folder.empty() ? own : folder + "/" + own;
        if (!harmless(own) || !isFree(name))
            continue;
        const std::string path = writeScratch(name, content);
        if (first.empty())
            first = blank + 1 < head.size() ? path + ":" + std::string(head.substr(blank + 1)) : path;
    }
    return first;
}

} // namespace brickwall::fuzz
