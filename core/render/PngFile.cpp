// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/render/ImageFiles.h"

#include <fmt/format.h>

#include <png.h>

namespace brickwall {
namespace {

/// libpng's description of an image; frees what it holds whatever happens.
struct Png
{
    png_image image{};

    Png() { image.version = PNG_IMAGE_VERSION; }
    ~Png() { png_image_free(&image); }
    Png(const Png&) = delete;
    Png& operator=(const Png&) = delete;
};

bool isOpaque(const Image& image)
{
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        if (image.rgba[i] != 255)
            return false;
    return true;
}

std::vector<std::uint8_t> withoutAlpha(const Image& image)
{
    std::vector<std::uint8_t> rgb;
    rgb.reserve(image.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        rgb.insert(rgb.end(), {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    return rgb;
}

} // namespace

void writePng(const Image& image, const std::string& path)
{
    if (image.width <= 0 || image.height <= 0)
        throw Error(path, fmt::format("an image of {} x {} pixels cannot be written", image.width, image.height));
    const bool opaque = isOpaque(image);
    const std::vector<std::uint8_t> pixels = opaque ? withoutAlpha(image) : image.rgba;
    Png png;
    png.image.width = png_uint_32(image.width);
    png.image.height = png_uint_32(image.height);
    png.image.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;

    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png.image);
    std::string bytes(size, '\0');
    if (!png_image_write_to_memory(&png.image, bytes.data(), &size, 0, pixels.data(), 0, nullptr))
        throw Error(path, fmt::format("cannot encode as PNG: {}", png.image.message));
    writeWholeFile(path, std::string_view(bytes.data(), size));
}

Image readPng(const std::string& path)
{
    constexpr std::uint64_t maxPixels = std::uint64_t(1) << 28;
    const std::string bytes = readWholeFile(path);
    Png png;
    if (!png_image_begin_read_from_memory(&png.image, bytes.data(), bytes.size()))
        throw Error(path, fmt::format("expected a PNG file: {}", png.image.message));
    if (std::uint64_t(png.image.width) * png.image.height > maxPixels)
        throw Error(path, fmt::format("{} x {} pixels are more than the {} allowed", png.image.width, png.image.height,
                                      maxPixels));
    png.image.format = PNG_FORMAT_RGBA;
    Image image{int(png.image.width), int(png.image.height), {}};
    image.rgba.resize(PNG_IMAGE_SIZE(png.image));
    if (!png_image_finish_read(&png.image, nullptr, image.rgba.data(), 0, nullptr))
        throw Error(path, fmt::format("broken PNG file: {}", png.image.message));
    return image;
}

} // namespace brickwall
