// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Folder.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <filesystem>

namespace brickwall {

void makeOutputFolder(const std::string& folder)
{
    if (folder.empty())
        throw Error("--out", "expected a folder, found nothing");
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error)
        throw Error(folder, fmt::format("cannot be made: {}", error.message()));
}

} // namespace brickwall
