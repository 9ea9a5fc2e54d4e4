// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/OutputFiles.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <sys/stat.h>
#include <unistd.h>

namespace brickwall {
namespace {

[[noreturn]] void fail(const std::string& path, int error)
{
    throw Error(path, fmt::format("cannot be written: {}", std::strerror(error)));
}

void rename(const std::string& from, const std::string& to, const std::string& path)
{
    if (std::rename(from.c_str(), to.c_str()) != 0)
        fail(path, errno);
}

bool isNumbered(const std::string& name, const std::string& prefix, const std::string& suffix)
{
    if (!name.starts_with(prefix) || !name.ends_with(suffix) || name.size() <= prefix.size() + suffix.size())
        return false;
    const std::string number = name.substr(prefix.size(), name.size() - prefix.size() - suffix.size());
    return std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; });
}

} // namespace

std::string temporaryName(const std::string& path)
{
    static std::atomic<unsigned> count{0};
    return fmt::format("{}.{}-{}.part", path, ::getpid(), count++);
}

OutputFiles::~OutputFiles()
{
    std::error_code ignored;
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) {
        if (!committed_)
            std::filesystem::remove_all(entry->renamed ? entry->path : entry->temporary, ignored);
        if (entry->retired.empty())
            continue;
        if (committed_)
            std::filesystem::remove_all(entry->retired, ignored);
        else
            std::filesystem::rename(entry->retired, entry->path, ignored);
    }
}

void OutputFiles::checkReplaceable(const std::string& path, bool folderWanted) const
{
    std::error_code none;
    const auto status = std::filesystem::symlink_status(path, none);
    if (!std::filesystem::exists(status))
        return;
    if (!overwrite_)
        throw Error(path, "is there already; --overwrite replaces it");
    if (folderWanted ? !std::filesystem::is_directory(status) : !std::filesystem::is_regular_file(status))
        throw Error(path, fmt::format("is there already and no {}, so that it is not replaced",
                                      folderWanted ? "folder" : "regular file"));
}

std::string OutputFiles::file(const std::string& path)
{
    checkReplaceable(path, false);
    entries_.push_back({temporaryName(path), path, {}});
    return entries_.back().temporary;
}

std::string OutputFiles::folder(const std::string& path, const std::string& prefix, const std::string& suffix)
{
    checkReplaceable(path, true);
    std::error_code none;
    for (const auto& old : std::filesystem::directory_iterator(path, none))
        if (!isNumbered(old.path().filename().string(), prefix, suffix))
            throw Error(path, fmt::format("is not replaced: it has {}, which is no {}NUMBER{}",
                                          old.path().filename().string(), prefix, suffix));
    const std::string temporary = temporaryName(path);
    if (::mkdir(temporary.c_str(), 0777) != 0)
        fail(path, errno);
    entries_.push_back({temporary, path, {}, true});
    return temporary;
}

void OutputFiles::retire(Entry& entry)
{
    std::error_code none;
    if (!std::filesystem::exists(std::filesystem::symlink_status(entry.path, none)))
        return;
    const std::string retired = temporaryName(entry.path);
    rename(entry.path, retired, entry.path);
    entry.retired = retired;
}

void OutputFiles::commit()
{
    for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry)
        retire(*entry);
    for (Entry& entry : entries_) {
        rename(entry.temporary, entry.path, entry.path);
        entry.renamed = true;
    }
    committed_ = true;
}

} // namespace brickwall
