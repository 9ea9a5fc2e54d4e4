// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall::oracles {

/// How numbers are stored.
enum class Hdf5Number { float32, float64, int32, int64, float32BigEndian };

/// An HDF5 file that is written, for tests: parents of what is made have to be there, `object` "" is the root. Throws
/// Error when the library fails. Not for several threads.
class Hdf5Writer
{
public:
    enum class Mode { create, edit };

    explicit Hdf5Writer(const std::string& path, Mode mode = Mode::create);
    ~Hdf5Writer();
    Hdf5Writer(const Hdf5Writer&) = delete;
    Hdf5Writer& operator=(const Hdf5Writer&) = delete;

    void group(const std::string& path);
    /// `chunk`, if not empty, makes it chunked and compressed by zlib.
    void numbers(const std::string& path, const std::vector<std::uint64_t>& shape, const std::vector<double>& values,
                 Hdf5Number type = Hdf5Number::float64, const std::vector<std::uint64_t>& chunk = {});
    /// A dataset whose values are never written.
    void unwritten(const std::string& path, const std::vector<std::uint64_t>& shape);
    /// A dataset that says that its values are in another file.
    void elsewhere(const std::string& path, const std::vector<std::uint64_t>& shape, const std::string& file);
    /// Compounds of 32-bit integers, element after element.
    void records(const std::string& path, const std::vector<std::string>& members,
                 const std::vector<std::int64_t>& values);
    void texts(const std::string& path, const std::vector<std::uint64_t>& shape, const std::vector<std::string>& values,
               std::size_t length);
    /// Compounds of the texts "name" and "value", 80 characters each, as FLASH has them.
    void pairs(const std::string& path, const std::vector<std::pair<std::string, std::string>>& values);
    /// An object, or an attribute of it, to be made anew or to be missed.
    void remove(const std::string& path);
    void removeAttribute(const std::string& object, const std::string& name);
    /// Another name for something in the file; a circle, if that holds the new name.
    void hardLink(const std::string& path, const std::string& target);
    void softLink(const std::string& path, const std::string& target);
    void externalLink(const std::string& path, const std::string& file, const std::string& target);

    void attribute(const std::string& object, const std::string& name, const std::vector<double>& values,
                   Hdf5Number type = Hdf5Number::float64);
    void textAttribute(const std::string& object, const std::string& name, const std::string& text);
    void variableText(const std::string& object, const std::string& name, const std::string& text);
    void recordAttribute(const std::string& object, const std::string& name, const std::vector<std::string>& members,
                         const std::vector<std::int64_t>& values);

private:
    std::int64_t file_ = -1;
};

} // namespace brickwall::oracles
