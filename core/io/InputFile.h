// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace brickwall {

/// A regular file that is read at given offsets. Reading changes no state, so that any number of threads may read at
/// once. Every error is an Error that names the file.
class InputFile
{
public:
    explicit InputFile(const std::string& path);
    ~InputFile();
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&&) = delete;

    const std::string& path() const { return path_; }
    std::uint64_t size() const { return size_; } ///< in bytes, when it was opened

    /// Fills `bytes` from `offset`; `what` names them in the message if the file ends before.
    void readAt(std::uint64_t offset, std::span<std::byte> bytes, std::string_view what) const;

    template <class T>
    void readAt(std::uint64_t offset, std::span<T> values, std::string_view what) const
    {
        readAt(offset, std::as_writable_bytes(values), what);
    }

private:
    std::string path_;
    std::uint64_t size_ = 0;
    int descriptor_ = -1;
};

/// The first bytes of a file, fewer if it is shorter; nothing for what is no readable regular file.
std::string fileStart(const std::string& path, std::size_t bytes);

/// The whole of a text file; an Error for more than 1 GiB.
std::string readText(const std::string& path);

bool isRegularFile(const std::string& path);

/// Whether a name that a file gives leads out of the folder that it belongs to: it is absolute, or goes up too far.
/// A symbolic link on the way is the user's.
bool leadsOutside(const std::string& name);

/// ".bricks" for "a/b.c.bricks"; empty without a dot. In lower case.
std::string extensionOf(const std::string& path);

/// "b.c" for "a/b.c.bricks", and for a folder "a/b.c/" its name as it is.
std::string stemOf(const std::string& path);

} // namespace brickwall
