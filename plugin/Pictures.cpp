// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/Pictures.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/plugin/GraphicsWindows.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace brickwall {
namespace {

namespace fs = std::filesystem;

void write(const osg::Image* image, const fs::path& file)
{
    if (!image)
        throw Error(file.string(), "the window was not drawn, so there is no picture of it");
    Image picture;
    picture.width = image->s();
    picture.height = image->t();
    for (int y = picture.height - 1; y >= 0; --y) { // top row first
        for (int x = 0; x < picture.width; ++x) {
            const unsigned char* rgb = image->data(x, y);
            picture.rgba.insert(picture.rgba.end(), {rgb[0], rgb[1], rgb[2], 255});
        }
    }
    writePng(picture, file.string());
}

} // namespace

void writePictures(const std::string& folder, const Rig& rig, const std::vector<WindowCapture::Picture>& pictures)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw Error(folder, "this folder cannot be made: " + error.message());
    std::set<std::string> names;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        std::string name = nameOf(rig, int(i));
        std::replace(name.begin(), name.end(), '/', '_');
        if (!names.insert(name).second)
            names.insert(name = fmt::format("{}-{}", name, i));
        write(pictures[i].left, fs::path(folder) / (name + ".png"));
        if (pictures[i].right)
            write(pictures[i].right, fs::path(folder) / (name + "-right.png"));
    }
}

} // namespace brickwall
