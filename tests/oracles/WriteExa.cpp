// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/WriteExa.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <fstream>

namespace brickwall::oracles {
namespace {

template <class T>
void append(std::vector<std::byte>& bytes, std::span<const T> values)
{
    const auto more = std::as_bytes(values);
    bytes.insert(bytes.end(), more.begin(), more.end());
}

std::string remap(const mat4d& worldFromVoxel)
{
    const vec3d a = transformPoint(worldFromVoxel, vec3d(0)), b = transformPoint(worldFromVoxel, vec3d(1));
    return fmt::format("remap_from 0 0 0 1 1 1\nremap_to {} {} {} {} {} {}\n", a.x, a.y, a.z, b.x, b.y, b.z);
}

} // namespace

void writeBytes(const std::string& path, std::span<const std::byte> bytes)
{
    std::ofstream out(path, std::ios::binary);
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    if (!out.flush())
        throw Error(path, "cannot be written");
}

void writeText(const std::string& path, const std::string& text)
{
    writeBytes(path, std::as_bytes(std::span(text)));
}

void writeBricks(const std::string& path, std::span<const BrickRecord> records)
{
    std::vector<std::byte> bytes;
    for (const BrickRecord& r : records) {
        const std::int32_t header[] = {r.size.x, r.size.y, r.size.z, r.lower.x, r.lower.y, r.lower.z, r.level};
        append(bytes, std::span<const std::int32_t>(header));
        append(bytes, std::span<const std::int32_t>(r.ids));
    }
    writeBytes(path, bytes);
}

void writeScalars(const std::string& path, std::span<const float> values)
{
    writeBytes(path, std::as_bytes(values));
}

void writeCells(const std::string& path, std::span<const Cell> cells)
{
    writeBytes(path, std::as_bytes(cells));
}

void writeTriangles(const std::string& path, std::span<const TriangleMesh> meshes)
{
    std::vector<std::byte> bytes;
    for (const TriangleMesh& mesh : meshes) {
        const std::int32_t counts[] = {static_cast<std::int32_t>(mesh.vertices.size()),
                                       static_cast<std::int32_t>(mesh.triangles.size())};
        append(bytes, std::span<const std::int32_t>(counts, 1));
        append(bytes, std::span<const vec3f>(mesh.vertices));
        append(bytes, std::span<const std::int32_t>(counts + 1, 1));
        append(bytes, std::span<const vec3i>(mesh.triangles));
    }
    writeBytes(path, bytes);
}

std::string writeExa(const std::string& folder, const std::string& name, const Model& model)
{
    const auto idOf = [&](std::uint64_t slot) { return static_cast<std::int32_t>(model.cellCount - 1 - slot); };
    std::vector<BrickRecord> records;
    for (const Brick& b : model.bricks) {
        records.push_back({b.size, b.lower, b.level, {}});
        for (std::uint64_t i = 0; i < b.cellCount(); ++i)
            records.back().ids.push_back(idOf(b.begin + i));
    }
    const std::string base = folder + "/" + name;
    writeBricks(base + ".bricks", records);
    std::string exa = "# written by a test\n" + remap(model.worldFromVoxel);
    for (const Field& field : model.fields) {
        writeScalars(fmt::format("{}.{}.scalars", base, field.name),
                     std::vector<float>(field.values.rbegin(), field.values.rend()));
        exa += fmt::format("scalar {} {}.{}.scalars\n", field.name, name, field.name);
    }
    writeText(base + ".exa", exa + fmt::format("bricks {}.bricks\n", name));
    return base + ".exa";
}

} // namespace brickwall::oracles
