// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/WriteVtk.h"

#include "brickwall/tests/oracles/WriteExa.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>

namespace brickwall::oracles {
namespace {

template <class T>
std::string packed(T number, bool bigEndian)
{
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
    if (bigEndian != (std::endian::native == std::endian::big))
        std::reverse(raw.begin(), raw.end());
    return {raw.data(), raw.size()};
}

std::string number(const std::string& type, double v, bool bigEndian)
{
    if (type == "Int8" || type == "UInt8")
        return packed(static_cast<std::int8_t>(static_cast<int>(v)), bigEndian);
    if (type == "Int16" || type == "UInt16")
        return packed(static_cast<std::int16_t>(static_cast<int>(v)), bigEndian);
    if (type == "Int32" || type == "UInt32")
        return packed(static_cast<std::int32_t>(v), bigEndian);
    if (type == "Int64" || type == "UInt64")
        return packed(static_cast<std::int64_t>(v), bigEndian);
    return type == "Float32" ? packed(static_cast<float>(v), bigEndian) : packed(v, bigEndian);
}

std::string base64(const std::string& bytes)
{
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

std::string header(const VtkAmr3& amr, std::uint64_t value)
{
    return amr.header64 ? packed(value, amr.bigEndian) : packed(static_cast<std::uint32_t>(value), amr.bigEndian);
}

/// Headers and data, in base64 apart from each other where they are compressed, as VTK does.
std::string encoded(const VtkAmr3& amr, const std::string& data, bool asBase64)
{
    std::string head, body;
    if (amr.compressed) {
        const std::size_t full = static_cast<std::size_t>(amr.blockBytes), blocks = (data.size() + full - 1) / full;
        head = header(amr, blocks) + header(amr, full) + header(amr, data.size() % full);
        for (std::size_t i = 0; i < data.size(); i += full) {
            const std::string block = data.substr(i, full);
            uLongf size = compressBound(block.size());
            std::string out(size, '\0');
            compress(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(block.data()),
                     block.size());
            head += header(amr, size);
            body += out.substr(0, size);
        }
        return asBase64 ? base64(head) + base64(body) : head + body;
    }
    head = header(amr, data.size()) + data;
    return asBase64 ? base64(head) : head;
}

class Piece
{
public:
    Piece(const VtkAmr3& amr, int level, const Box3i& box) : amr_(amr), level_(level), box_(box) {}

    std::string text()
    {
        const vec3i n = box_.extent();
        vec3d spacing = amr_.spacing;
        for (int l = 0; l < level_; ++l)
            spacing /= double(amr_.ratios[static_cast<std::size_t>(l)]);
        const vec3d lower = amr_.origin + vec3d(box_.lower) * spacing;
        std::string s =
            fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"{}\" byte_order=\"{}\"{}{}>\n",
                        amr_.header64 ? "1.0" : "0.1", amr_.bigEndian ? "BigEndian" : "LittleEndian",
                        amr_.header64 ? " header_type=\"UInt64\"" : "",
                        amr_.compressed ? " compressor=\"vtkZLibDataCompressor\"" : "");
        const std::string extent = fmt::format("0 {} 0 {} 0 {}", n.x, n.y, n.z);
        s += fmt::format("<ImageData WholeExtent=\"{0}\" Origin=\"{1} {2} {3}\" Spacing=\"{4} {5} {6}\">\n<Piece "
                         "Extent=\"{0}\">\n<PointData>\n</PointData>\n<CellData>\n",
                         extent, lower.x, lower.y, lower.z, spacing.x, spacing.y, spacing.z);
        for (const VtkArray& array : amr_.arrays)
            s += element(array);
        s += "</CellData>\n</Piece>\n</ImageData>\n";
        if (!appended_.empty())
            s += fmt::format("<AppendedData encoding=\"{}\">\n_{}\n</AppendedData>\n",
                             amr_.format == VtkFormat::appendedRaw ? "raw" : "base64", appended_);
        return s + "</VTKFile>\n";
    }

private:
    std::vector<double> values(const VtkArray& array) const
    {
        std::vector<double> v;
        for (int z = box_.lower.z; z < box_.upper.z; ++z)
            for (int y = box_.lower.y; y < box_.upper.y; ++y)
                for (int x = box_.lower.x; x < box_.upper.x; ++x)
                    for (int c = 0; c < array.components; ++c)
                        v.push_back(amr_.value(level_, c, {x, y, z}));
        return v;
    }

    std::string element(const VtkArray& array)
    {
        const bool ascii = amr_.format == VtkFormat::ascii, inlined = amr_.format == VtkFormat::binary;
        std::string s = fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"{}\"",
                                    array.type, array.name, array.components,
                                    ascii     ? "ascii"
                                    : inlined ? "binary"
                                              : "appended");
        std::string data, text;
        for (const double v : values(array)) {
            data += number(array.type, v, amr_.bigEndian);
            text += fmt::format("{} {}", text.size() % 60 < 10 ? "\n" : "", v);
        }
        if (ascii)
            return s + ">" + text + "\n</DataArray>\n";
        if (inlined)
            return s + ">\n  " + encoded(amr_, data, true) + "\n</DataArray>\n";
        s += fmt::format(" offset=\"{}\"/>\n", appended_.size());
        appended_ += encoded(amr_, data, amr_.format == VtkFormat::appendedBase64);
        return s;
    }

    const VtkAmr3& amr_;
    int level_;
    Box3i box_;
    std::string appended_;
};

} // namespace

std::string writeVtkAmr(const std::string& folder, const std::string& name, const VtkAmr3& amr)
{
    std::filesystem::create_directories(folder + "/" + name);
    const bool old = amr.version == "1.0";
    const std::string type = old ? "vtkHierarchicalBoxDataSet" : "vtkOverlappingAMR";
    std::string s =
        fmt::format("<VTKFile type=\"{}\" version=\"{}\" byte_order=\"LittleEndian\">\n<{}", type, amr.version, type);
    if (!old)
        s += fmt::format(" origin=\"{} {} {}\" grid_description=\"XYZ\"", amr.origin.x, amr.origin.y, amr.origin.z);
    s += ">\n";
    vec3d spacing = amr.spacing;
    int piece = 0;
    for (std::size_t l = 0; l < amr.boxes.size(); ++l) {
        s += old ? fmt::format("<Block level=\"{}\" refinement_ratio=\"{}\">\n", l,
                               l < amr.ratios.size() ? amr.ratios[l] : 2)
                 : fmt::format("<Block level=\"{}\" spacing=\"{:.6g} {:.6g} {:.6g}\">\n", l, spacing.x, spacing.y,
                               spacing.z);
        for (std::size_t b = 0; b < amr.boxes[l].size(); ++b, ++piece) {
            const Box3i& box = amr.boxes[l][b];
            const std::string file = fmt::format("{0}/{0}_{1}.vti", name, piece);
            writeText(folder + "/" + file, Piece(amr, static_cast<int>(l), box).text());
            s += fmt::format("<DataSet index=\"{}\" amr_box=\"{} {} {} {} {} {}\" file=\"{}\">\n</DataSet>\n", b,
                             box.lower.x, box.upper.x - 1, box.lower.y, box.upper.y - 1, box.lower.z, box.upper.z - 1,
                             file);
        }
        s += "</Block>\n";
        if (l < amr.ratios.size())
            spacing /= double(amr.ratios[l]);
    }
    const std::string path = folder + "/" + name + ".vthb";
    writeText(path, s + fmt::format("</{}>\n</VTKFile>\n", type));
    return path;
}

} // namespace brickwall::oracles
