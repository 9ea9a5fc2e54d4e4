// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/WholeFile.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include <unistd.h>

namespace brickwall {
namespace {

struct CloseFile
{
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

[[noreturn]] void fail(const std::string& path, std::string_view what, int error)
{
    throw Error(path, fmt::format("{}: {}", what, std::strerror(error)));
}

/// Unique per process and call: several threads may write the same path, the last rename wins.
std::string temporaryName(const std::string& path)
{
    static std::atomic<unsigned> count{0};
    return fmt::format("{}.{}-{}.part", path, ::getpid(), count++);
}

/// A device, a pipe or a link takes the bytes itself: a file renamed to /dev/null or /dev/stdout would take its place.
bool takesBytesItself(const std::string& path)
{
    std::error_code none;
    const std::filesystem::file_status status = std::filesystem::symlink_status(path, none);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

} // namespace

std::string readWholeFile(const std::string& path)
{
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file)
        fail(path, "cannot open", errno);
    std::string bytes;
    char buffer[1 << 16];
    for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, file.get())) > 0;)
        bytes.append(buffer, n);
    if (std::ferror(file.get()))
        fail(path, "cannot read", errno);
    return bytes;
}

void writeWholeFile(const std::string& path, std::string_view bytes)
{
    const bool direct = takesBytesItself(path);
    const std::string temporary = direct ? path : temporaryName(path);
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (!file)
        fail(path, "cannot write", errno);
    int error = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() ? 0 : errno;
    if (std::fclose(file) != 0 && error == 0)
        error = errno;
    if (error == 0 && !direct && std::rename(temporary.c_str(), path.c_str()) != 0)
        error = errno;
    if (error != 0) {
        if (!direct)
            std::remove(temporary.c_str());
        fail(path, "cannot write", error);
    }
}

} // namespace brickwall
