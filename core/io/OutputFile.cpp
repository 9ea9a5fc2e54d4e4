// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/OutputFile.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace brickwall {

OutputFile::OutputFile(const std::string& path, const std::string& name, Open how) : path_(path), name_(name)
{
    const int flags = how == Open::create ? O_CREAT | O_EXCL : 0;
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666);
    if (descriptor_ < 0)
        fail(errno);
    struct stat info = {};
    if (how == Open::append && ::fstat(descriptor_, &info) == 0)
        size_ = static_cast<std::uint64_t>(info.st_size);
}

OutputFile::~OutputFile()
{
    if (descriptor_ >= 0)
        ::close(descriptor_);
}

void OutputFile::append(std::span<const std::byte> bytes)
{
    writeAt(size_, bytes);
    size_ += bytes.size();
}

void OutputFile::writeAt(std::uint64_t offset, std::span<const std::byte> bytes)
{
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t n =
            ::pwrite(descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
        if (n < 0 && errno == EINTR)
            continue;
        if (n <= 0)
            fail(n < 0 ? errno : ENOSPC);
        done += static_cast<std::size_t>(n);
    }
}

void OutputFile::close()
{
    if (::close(std::exchange(descriptor_, -1)) != 0)
        fail(errno);
}

void OutputFile::fail(int error) const
{
    throw Error(name_, fmt::format("cannot be written: {}", std::strerror(error)));
}

} // namespace brickwall
