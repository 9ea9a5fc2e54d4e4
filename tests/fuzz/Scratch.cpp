// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Scratch.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <unistd.h>

namespace brickwall::fuzz {
namespace {

namespace fs = std::filesystem;

struct Folder
{
    Folder()
    {
        path = (fs::temp_directory_path() / ("brickwall_fuzz_" + std::to_string(::getpid()))).string();
        fs::remove_all(path);
        fs::create_directories(path);
    }
    ~Folder()
    {
        std::error_code ignored;
        fs::remove_all(path, ignored);
    }

    std::string path;
};

} // namespace

const std::string& scratchFolder()
{
    static const Folder folder;
    return folder.path;
}

void emptyScratchFolder()
{
    for (const auto& entry : fs::directory_iterator(scratchFolder()))
        fs::remove_all(entry);
}

std::string writeScratch(const std::string& name, std::string_view bytes)
{
    const fs::path path = fs::path(scratchFolder()) / name;
    fs::create_directories(path.parent_path());
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (!file || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fclose(file) != 0) {
        std::perror(path.c_str());
        std::abort();
    }
    return path.string();
}

} // namespace brickwall::fuzz
