// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/InputFile.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace brickwall {

InputFile::InputFile(const std::string& path) : path_(path)
{
    // O_NONBLOCK: opening a named pipe must not wait for a writer; it is refused below.
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor_ < 0)
        throw Error(path, fmt::format("cannot be opened: {}", std::strerror(errno)));
    struct stat info = {};
    const bool known = ::fstat(descriptor_, &info) == 0;
    if (!known || !S_ISREG(info.st_mode)) {
        ::close(descriptor_);
        throw Error(path, "expected a regular file");
    }
    size_ = static_cast<std::uint64_t>(info.st_size);
}

InputFile::~InputFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)), size_(other.size_), descriptor_(std::exchange(other.descriptor_, -1))
{
}

void InputFile::readAt(std::uint64_t offset, std::span<std::byte> bytes, std::string_view what) const
{
    if (offset > size_ || bytes.size() > size_ - offset)
        throw Error(path_, fmt::format("truncated: {} needs bytes {} to {}, but the file ends at byte {}", what, offset,
                                       offset + bytes.size(), size_));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n =
            ::pread(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
        if (n < 0 && errno == EINTR)
            continue;
        if (n < 0)
            throw Error(path_, fmt::format("cannot read {} at byte {}: {}", what, offset + done, std::strerror(errno)));
        if (n == 0)
            throw Error(path_,
                        fmt::format("has become shorter while it was read, at byte {} of {}", offset + done, size_));
        done += static_cast<std::size_t>(n);
    }
}

std::string fileStart(const std::string& path, std::size_t bytes)
{
    if (!isRegularFile(path))
        return {};
    const InputFile file(path);
    std::string start(std::min<std::uint64_t>(bytes, file.size()), '\0');
    file.readAt(0, std::span<char>(start), "its beginning");
    return start;
}

std::string readText(const std::string& path)
{
    constexpr std::uint64_t limit = std::uint64_t(1) << 30;
    const InputFile file(path);
    if (file.size() > limit)
        throw Error(path, fmt::format("expected a text of at most {} bytes, found {}", limit, file.size()));
    std::string text(file.size(), '\0');
    file.readAt(0, std::span<char>(text), "its text");
    return text;
}

bool isRegularFile(const std::string& path)
{
    std::error_code ignored;
    return std::filesystem::is_regular_file(path, ignored);
}

bool leadsOutside(const std::string& name)
{
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    return path.is_absolute() || (!path.empty() && *path.begin() == "..");
}

std::string extensionOf(const std::string& path)
{
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c; });
    return extension;
}

std::string stemOf(const std::string& path)
{
    std::error_code ignored;
    std::filesystem::path p(path);
    if (!p.has_filename())
        p = p.parent_path();
    return std::filesystem::is_directory(p, ignored) ? p.filename().string() : p.stem().string();
}

} // namespace brickwall
