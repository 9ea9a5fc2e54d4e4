// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace brickwall {

/// A name beside `path` that no other thread or process has: NAME.PID-N.part.
std::string temporaryName(const std::string& path);

/// The files of one conversion: they are written under temporary names in their own folder and
/// renamed together when all are whole. What was there before stays until then. Without `commit` nothing remains; after
/// a `kill -9` names that end in .part may.
class OutputFiles
{
public:
    /// Without `overwrite`, what exists already is an Error.
    explicit OutputFiles(bool overwrite) : overwrite_(overwrite) {}
    ~OutputFiles();
    OutputFiles(const OutputFiles&) = delete;
    OutputFiles& operator=(const OutputFiles&) = delete;

    /// Throws Error if `path` exists and may not be replaced.
    void checkReplaceable(const std::string& path, bool folderWanted) const;

    /// The temporary name for a file. Files appear in the order of these calls: the one that a user opens is the last.
    std::string file(const std::string& path);
    /// The same for a folder, which is made. One that exists is replaced if all files in it are called PREFIX...SUFFIX
    /// with a number in between, and never otherwise.
    std::string folder(const std::string& path, const std::string& prefix, const std::string& suffix);

    /// Renames; older files go first, the one that a user opens before its parts, so that at no time old and new ones
    /// look like one data set.
    void commit();

private:
    struct Entry
    {
        std::string temporary, path;
        std::string retired; ///< where an older folder waits for its end
        bool isFolder = false;
        bool renamed = false;
    };

    static void retire(Entry& entry);

    bool overwrite_;
    bool committed_ = false;
    std::vector<Entry> entries_;
};

} // namespace brickwall
