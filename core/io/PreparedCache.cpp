// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/PreparedCache.h"

#include "brickwall/core/base/ContentHash.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/DataStamp.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/OutputFile.h"
#include "brickwall/core/io/PreparedFile.h"
#include "brickwall/core/io/Writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <utility>

namespace brickwall {
namespace {

namespace fs = std::filesystem;

constexpr const char* extension = ".prepared";

/// One file for each request, so that a changed data set takes the place of what it was before.
std::string fileName(const VolumeRequest& request)
{
    const std::uint64_t hash = contentHash(bytesOf(preparedKey(request, {})));
    const std::string field = request.fields.empty() ? "" : fileNamePart(request.fields.front()).substr(0, 32);
    return fmt::format("{}-{}-{:016x}{}", fileNamePart(stemOf(request.data)).substr(0, 64), field, hash, extension);
}

struct KeptFile
{
    fs::file_time_type used;
    std::uint64_t size;
    fs::path path;
};

/// All kept files and what killed processes left, those not used for longest first.
std::vector<KeptFile> keptFiles(const std::string& folder)
{
    constexpr auto abandoned = std::chrono::hours(24);
    std::vector<KeptFile> kept;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
        const std::string name = entry.path().filename().string();
        const auto used = entry.last_write_time(none);
        if (none)
            continue; // another process has removed it
        const std::uint64_t size = entry.file_size(none);
        if (name.ends_with(extension) && !none)
            kept.push_back({used, size, entry.path()});
        else if (name.ends_with(".part") && name.find(extension) != std::string::npos &&
                 fs::file_time_type::clock::now() - used > abandoned)
            fs::remove(entry.path(), none);
    }
    std::ranges::sort(kept, {}, &KeptFile::used);
    return kept;
}

std::string noRoom(std::uint64_t bytes)
{
    return fmt::format("no room for {:.1f} GiB", double(bytes) / double(1 << 30));
}

} // namespace

PreparedCache::PreparedCache(const VolumeCache& cache, const VolumeRequest& request,
                             const std::vector<std::string>& files)
    : cache_(cache), request_(request), files_(files)
{
    if (cache.folder.empty() || files.empty())
        return;
    std::error_code none;
    const fs::path canonical = fs::weakly_canonical(request.data, none);
    request_.data = none ? request.data : canonical.string();
    path_ = (fs::path(cache.folder) / fileName(request_)).string();
}

std::optional<PreparedVolume> PreparedCache::read(const Executor& executor, Progress& progress) const
{
    if (path_.empty() || !isRegularFile(path_))
        return {};
    const std::string stamp = stampOf(files_);
    if (stamp.empty())
        return {};
    try {
        PreparedVolume volume = readPrepared(path_, preparedKey(request_, stamp), executor, progress);
        std::error_code none;
        fs::last_write_time(path_, fs::file_time_type::clock::now(), none); // it was used
        return volume;
    } catch (const Error& error) {
        progress.note(fmt::format("not taken from the cache: {}", error.what()));
    } catch (const std::bad_alloc&) {
        progress.note(fmt::format("not taken from the cache: {}: no memory", path_));
    }
    return {};
}

void PreparedCache::makeRoom(std::uint64_t bytes) const
{
    if (bytes > cache_.mostBytes)
        throw Error(path_, noRoom(bytes));
    const std::vector<KeptFile> kept = keptFiles(cache_.folder);
    std::uint64_t sum = bytes;
    for (const KeptFile& file : kept)
        sum += file.path == path_ ? 0 : file.size;
    std::error_code none;
    for (const KeptFile& file : kept) {
        if (sum <= cache_.mostBytes || file.path == path_)
            continue;
        fs::remove(file.path, none);
        sum -= file.size;
    }
    const std::uint64_t available = fs::space(cache_.folder, none).available;
    if (none)
        throw Error(cache_.folder, none.message());
    if (available < cache_.leastFreeBytes || available - cache_.leastFreeBytes < bytes)
        throw Error(path_, noRoom(bytes));
}

void PreparedCache::write(const PreparedVolume& volume, const std::string& stamp, const Executor& executor,
                          Progress& progress) const
{
    if (path_.empty())
        return;
    std::error_code failure;
    fs::create_directories(cache_.folder, failure);
    try {
        if (failure)
            throw Error(cache_.folder, fmt::format("cannot be made: {}", failure.message()));
        makeRoom(volume.bytes());
        writePrepared(path_, preparedKey(request_, stamp), volume, executor, progress);
    } catch (const Error& error) {
        progress.note(fmt::format("not kept in the cache: {}", error.what()));
    }
}

VolumeCache userCache()
{
    const auto variable = [](const char* name) {
        const char* value = std::getenv(name);
        return std::string(value ? value : "");
    };
    VolumeCache cache;
    const std::string own = variable("BRICKWALL_CACHE"), user = variable("XDG_CACHE_HOME"), home = variable("HOME");
    if (own == "off")
        return cache;
    if (!own.empty())
        cache.folder = own;
    else if (fs::path(user).is_absolute()) // as the specification of these folders says
        cache.folder = (fs::path(user) / "brickwall").string();
    else if (!home.empty())
        cache.folder = (fs::path(home) / ".cache" / "brickwall").string();
    return cache;
}

} // namespace brickwall
