// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VtiPieces.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/Writers.h"

#include <zlib.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

namespace brickwall {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr int offsetDigits = 20;
constexpr const char* ending = "\n  </AppendedData>\n</VTKFile>\n";

std::span<const std::byte> bytesOfNumber(const std::uint64_t& number)
{
    return std::as_bytes(std::span(&number, 1));
}

} // namespace

VtiPiece::VtiPiece(std::string path, std::string name, const vec3i& size, const vec3d& lower, const vec3d& cellSize,
                   const std::vector<std::string>& fieldNames, bool compress)
    : path_(std::move(path)),
      name_(std::move(name)),
      cellCount_(std::uint64_t(size.x) * size.y * size.z),
      compress_(compress)
{
    const std::string extent = fmt::format("0 {} 0 {} 0 {}", size.x, size.y, size.z);
    header_ = fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" "
                          "byte_order=\"LittleEndian\" header_type=\"UInt64\"{}>\n"
                          "  <ImageData WholeExtent=\"{}\" Origin=\"{} {} {}\" Spacing=\"{} {} {}\">\n"
                          "    <Piece Extent=\"{}\">\n      <PointData>\n      </PointData>\n      <CellData>\n",
                          compress ? " compressor=\"vtkZLibDataCompressor\"" : "", extent, lower.x, lower.y, lower.z,
                          cellSize.x, cellSize.y, cellSize.z, extent);
    for (const std::string& field : fieldNames) {
        header_ += fmt::format("        <DataArray type=\"Float32\" Name=\"{}\" format=\"appended\" offset=\"",
                               xmlAttribute(field));
        offsetPlaces_.push_back(header_.size());
        header_ += fmt::format("{:0{}}\"/>\n", 0, offsetDigits);
    }
    header_ += "      </CellData>\n    </Piece>\n  </ImageData>\n  <AppendedData encoding=\"raw\">\n   _";
}

void VtiPiece::create() const
{
    OutputFile file(path_, name_);
    file.append(bytesOf(header_));
    file.close();
}

void VtiPiece::append(std::size_t field, const SelectedValues& values, std::size_t brick, Progress& progress) const
{
    OutputFile file(path_, name_, OutputFile::Open::append);
    file.writeAt(offsetPlaces_[field], bytesOf(fmt::format("{:0{}}", file.size() - header_.size(), offsetDigits)));
    if (compress_)
        appendCompressed(file, values, brick, progress);
    else
        appendRaw(file, values, brick, progress);
    file.close();
}

/// The number of bytes, then the bytes.
void VtiPiece::appendRaw(OutputFile& file, const SelectedValues& values, std::size_t brick, Progress& progress) const
{
    const std::uint64_t bytes = cellCount_ * sizeof(float);
    file.append(bytesOfNumber(bytes));
    std::vector<float> block;
    for (std::uint64_t first = 0; first < cellCount_; first += block.size()) {
        progress.check();
        block.resize(std::min<std::uint64_t>(cellsAtOnce, cellCount_ - first));
        values.read(brick, first, block);
        file.append(bytesOf(std::span(block)));
        progress.advance(block.size());
    }
}

/// The number of blocks, the bytes of a block and of the last one if it is shorter (0: it is not), the compressed bytes
/// of each, then the blocks.
void VtiPiece::appendCompressed(OutputFile& file, const SelectedValues& values, std::size_t brick,
                                Progress& progress) const
{
    const std::uint64_t blocks = (cellCount_ + cellsAtOnce - 1) / cellsAtOnce;
    std::vector<std::uint64_t> head{blocks, cellsAtOnce * sizeof(float), cellCount_ % cellsAtOnce * sizeof(float)};
    head.resize(3 + blocks);
    const std::uint64_t headPlace = file.size();
    file.append(bytesOf(std::span(head)));
    std::vector<float> block;
    std::vector<Bytef> packed;
    for (std::uint64_t b = 0; b < blocks; ++b) {
        progress.check();
        const std::uint64_t first = b * cellsAtOnce;
        block.resize(std::min<std::uint64_t>(cellsAtOnce, cellCount_ - first));
        values.read(brick, first, block);
        const uLong bytes = block.size() * sizeof(float);
        uLongf size = compressBound(bytes);
        packed.resize(size);
        if (compress(packed.data(), &size, reinterpret_cast<const Bytef*>(block.data()), bytes) != Z_OK)
            throw Error(name_, "zlib could not compress a block");
        head[3 + b] = size;
        file.append(std::as_bytes(std::span(packed).first(size)));
        progress.advance(block.size());
    }
    file.writeAt(headPlace, bytesOf(std::span(head)));
}

void VtiPiece::finish() const
{
    OutputFile file(path_, name_, OutputFile::Open::append);
    file.append(bytesOf(std::string(ending)));
    file.close();
}

std::string xmlAttribute(const std::string& text)
{
    std::string escaped;
    for (const char c : text)
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        default:
            escaped += c;
        }
    return escaped;
}

} // namespace brickwall
