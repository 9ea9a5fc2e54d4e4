// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/render/ImageFiles.h"

#include <fmt/format.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStdIO.h>

#include <algorithm>
#include <sstream>

namespace brickwall {
namespace {

/// EXR's rows start at the top, a frame's at the bottom.
template <class T>
std::vector<T> upsideDown(const std::vector<T>& rows, int width, int height)
{
    std::vector<T> turned(rows.size());
    for (int y = 0; y < height; ++y)
        std::copy_n(rows.begin() + std::ptrdiff_t(y) * width, width,
                    turned.begin() + std::ptrdiff_t(height - 1 - y) * width);
    return turned;
}

/// The library's view of our buffers. `lower` is the data window's first pixel, which need not be (0, 0).
Imf::FrameBuffer bufferOf(std::vector<vec4f>& color, std::vector<float>& depth, int width, const Imath::V2i& lower)
{
    Imf::FrameBuffer buffer;
    const auto insert = [&](const char* name, float* first, std::size_t pixel, double fill) {
        const std::ptrdiff_t offset = (std::ptrdiff_t(lower.y) * width + lower.x) * std::ptrdiff_t(pixel);
        char* base = reinterpret_cast<char*>(reinterpret_cast<std::intptr_t>(first) - offset);
        buffer.insert(name, Imf::Slice(Imf::FLOAT, base, pixel, pixel * std::size_t(width), 1, 1, fill));
    };
    const char* names[] = {"R", "G", "B", "A"};
    for (int c = 0; c < 4; ++c)
        insert(names[c], &color[0][c], sizeof(vec4f), c == 3 ? 1.0 : 0.0);
    insert("Z", depth.data(), sizeof(float), 1.0);
    return buffer;
}

Frame readFrom(Imf::InputFile& file, const std::string& path)
{
    const Imf::Header& header = file.header();
    for (const char* name : {"R", "G", "B"})
        if (!header.channels().findChannel(name))
            throw Error(path, fmt::format("expected a channel '{}'", name));
    const Imath::Box2i window = header.dataWindow();
    const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
    const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
    constexpr std::int64_t maxSide = 1 << 16;
    constexpr std::int64_t maxPixels = std::int64_t(1) << 28;
    if (width < 1 || height < 1 || width > maxSide || height > maxSide || width * height > maxPixels)
        throw Error(path, fmt::format("expected at most {} pixels, found {} x {}", maxPixels, width, height));

    std::vector<vec4f> color(std::size_t(width * height));
    std::vector<float> depth(color.size());
    file.setFrameBuffer(bufferOf(color, depth, int(width), window.min));
    file.readPixels(window.min.y, window.max.y);
    Frame frame;
    frame.width = int(width);
    frame.height = int(height);
    frame.color = upsideDown(color, frame.width, frame.height);
    frame.depth = upsideDown(depth, frame.width, frame.height);
    return frame;
}

} // namespace

void writeExr(const Frame& frame, const std::string& path)
{
    const std::size_t pixels = std::size_t(std::max(frame.width, 0)) * std::size_t(std::max(frame.height, 0));
    if (pixels == 0 || frame.color.size() != pixels || frame.depth.size() != pixels)
        throw Error(path, fmt::format("a frame of {} x {} pixels with {} colours and {} depths cannot be written",
                                      frame.width, frame.height, frame.color.size(), frame.depth.size()));
    std::vector<vec4f> color = upsideDown(frame.color, frame.width, frame.height);
    std::vector<float> depth = upsideDown(frame.depth, frame.width, frame.height);
    Imf::Header header(frame.width, frame.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* name : {"R", "G", "B", "A", "Z"})
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    Imf::addComments(header, "linear, premultiplied RGBA; Z is window depth, 1 where nothing was hit");
    try {
        Imf::StdOSStream stream;
        {
            Imf::OutputFile file(stream, header);
            file.setFrameBuffer(bufferOf(color, depth, frame.width, {0, 0}));
            file.writePixels(frame.height);
        }
        writeWholeFile(path, stream.str());
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        throw Error(path, fmt::format("cannot encode as EXR: {}", e.what()));
    }
}

Frame readExr(const std::string& path)
{
    const std::string bytes = readWholeFile(path);
    try {
        Imf::StdISStream stream;
        stream.str(bytes);
        Imf::InputFile file(stream);
        return readFrom(file, path);
    } catch (const Error&) {
        throw;
    } catch (const std::exception& e) {
        throw Error(path, fmt::format("expected an EXR file: {}", e.what()));
    }
}

} // namespace brickwall
