// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// What a user names as data: a file, and after it, separated by colons, what the file does not say itself:
/// `cloud.raw:256x256x128:uint8:threshold=0.02`.
struct DataName
{
    std::string file;
    std::vector<std::string> options;

    /// "0.02" for the key "threshold" if there is an option threshold=0.02; empty if there is none.
    std::string valueOf(std::string_view key) const;
};

/// A file or folder that exists by the whole name has no options; otherwise the name ends at the last colon before
/// which there is a file. Without such a file the whole is the name.
DataName splitDataName(const std::string& data);

} // namespace brickwall
