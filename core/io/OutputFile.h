// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace brickwall {

/// A file that is written, under a temporary name while it grows. Every error (a full disk) is an Error that names the
/// file as it will be called, with the system's reason.
class OutputFile
{
public:
    enum class Open { create, append };

    /// Writes to `path`; messages say `name`.
    OutputFile(const std::string& path, const std::string& name, Open how = Open::create);
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// At the end, from one thread at a time.
    void append(std::span<const std::byte> bytes);
    std::uint64_t size() const { return size_; } ///< where `append` continues

    /// Anywhere, from any thread.
    void writeAt(std::uint64_t offset, std::span<const std::byte> bytes);

    /// Some file systems say only now that there was no room. A file that is not closed is not whole.
    void close();

private:
    [[noreturn]] void fail(int error) const;

    std::string path_, name_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;
};

template <class T, std::size_t count>
std::span<const std::byte> bytesOf(std::span<T, count> values)
{
    return std::as_bytes(values);
}
inline std::span<const std::byte> bytesOf(const std::string& text)
{
    return std::as_bytes(std::span(text));
}

} // namespace brickwall
