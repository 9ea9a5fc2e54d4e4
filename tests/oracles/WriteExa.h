// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace brickwall::oracles {

/// A record of a `.bricks` file, written as it is, right or wrong.
struct BrickRecord
{
    vec3i size;
    vec3i lower;
    int level = 0;
    std::vector<std::int32_t> ids;
};

// All overwrite `path` and throw Error if they cannot.
void writeText(const std::string& path, const std::string& text);
void writeBytes(const std::string& path, std::span<const std::byte> bytes);
void writeBricks(const std::string& path, std::span<const BrickRecord> records);
void writeScalars(const std::string& path, std::span<const float> values);
void writeCells(const std::string& path, std::span<const Cell> cells);
void writeTriangles(const std::string& path, std::span<const TriangleMesh> meshes);

/// Writes a model as FOLDER/NAME.exa with its .bricks and one .scalars per field; cell IDs count down, so that a reader
/// which ignores them fails. A diagonal worldFromVoxel goes into the remap keywords. Returns the path of the .exa file.
std::string writeExa(const std::string& folder, const std::string& name, const Model& model);

} // namespace brickwall::oracles
