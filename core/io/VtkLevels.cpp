// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VtkLevels.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/VtkPiece.h"

#include <glm/common.hpp>

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string_view>

namespace brickwall {
namespace {

/// Some 130 000 pieces, which are files each. Parsed XML takes four times its text.
constexpr std::uint64_t listLimit = std::uint64_t(8) << 20;

/// Reading stays below the folder of the data set: what is outside is none of its pieces.
std::string pieceFile(const std::string& list, const std::string& name)
{
    if (leadsOutside(name))
        throw Error(list, fmt::format("expected pieces within the folder of the data set, found '{}'", name));
    return (std::filesystem::path(list).parent_path() / std::filesystem::path(name).lexically_normal()).string();
}

Box3i blockBox(const VtkXml& xml, const pugi::xml_node& node, std::size_t level, std::size_t index)
{
    Box3i box = vtkExtent(xml, node, "amr_box");
    for (int axis = 0; axis < 3; ++axis)
        if (box.lower[axis] > box.upper[axis])
            throw Error(xml.path(), fmt::format("level {}, box {}: expected cells, found {} to {} along {}", level,
                                                index, box.lower[axis], box.upper[axis], "xyz"[axis]));
    box.upper += 1; // amr_box names the last cell
    return box;
}

std::vector<pugi::xml_node> levelNodes(const VtkXml& xml)
{
    std::vector<pugi::xml_node> nodes;
    for (const pugi::xml_node& node : xml.content().children("Block")) {
        if (const int level = node.attribute("level").as_int(-1); level != static_cast<int>(nodes.size()))
            throw Error(xml.path(), fmt::format("expected level {} as the next, found '{}'", nodes.size(),
                                                node.attribute("level").as_string()));
        nodes.push_back(node);
    }
    if (nodes.empty())
        throw Error(xml.path(), "expected elements Block, one per level, found none");
    return nodes;
}

/// How many times finer `fine` is, by the spacings of both, which have few digits.
int ratioOf(const VtkXml& xml, const pugi::xml_node& coarse, const pugi::xml_node& fine)
{
    if (!coarse.attribute("spacing"))
        return coarse.attribute("refinement_ratio").as_int(0);
    const vec3d ratio = vtkVector(xml, coarse, "spacing") / vtkVector(xml, fine, "spacing");
    const double rounded = std::round(ratio.x);
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(ratio[axis] - rounded) <= 1e-3 * rounded) || !(rounded <= 1 << 24))
            throw Error(xml.path(),
                        fmt::format("expected one whole ratio of spacings between levels {} and {}, found {} "
                                    "{} {}",
                                    coarse.attribute("level").as_int(), fine.attribute("level").as_int(), ratio.x,
                                    ratio.y, ratio.z));
    return static_cast<int>(rounded);
}

void readBlocks(const VtkXml& xml, const std::vector<pugi::xml_node>& nodes, VtkLevels& levels)
{
    std::vector<int> ratios;
    for (std::size_t l = 0; l + 1 < nodes.size(); ++l)
        ratios.push_back(ratioOf(xml, nodes[l], nodes[l + 1]));
    const std::vector<int> numbers = levelNumbers(ratios, xml.path());
    for (std::size_t l = 0; l < nodes.size(); ++l) {
        levels.boxes.push_back({fmt::format("{}: level {}", xml.path(), l), numbers[l], {}});
        levels.files.emplace_back();
        for (const pugi::xml_node& node : nodes[l].children("DataSet")) {
            const std::string file = node.attribute("file").as_string();
            if (file.empty())
                continue;
            levels.boxes[l].boxes.push_back(blockBox(xml, node, l, levels.files[l].size()));
            levels.files[l].push_back(pieceFile(xml.path(), file));
        }
        checkLevel(levels.boxes[l]);
    }
}

/// A list of version 1.1 says where its level-0 index 0 is, and how wide cells are.
void checkPlace(const VtkXml& xml, const pugi::xml_node& level, const VtkPiece& piece, const Box3i& box)
{
    if (!level.attribute("spacing") || !xml.content().attribute("origin"))
        return;
    const vec3d spacing = vtkVector(xml, level, "spacing");
    const vec3d lower = vtkVector(xml, xml.content(), "origin") + vec3d(box.lower) * spacing;
    for (int axis = 0; axis < 3; ++axis) {
        // Indices multiply what rounding leaves of the spacing.
        const double allowed = (0.01 + 1e-4 * std::abs(box.lower[axis])) * std::abs(spacing[axis]);
        if (!(std::abs(piece.spacing()[axis] - spacing[axis]) <= 1e-3 * std::abs(spacing[axis])) ||
            !(std::abs(piece.lower()[axis] - lower[axis]) <= allowed))
            throw Error(
                piece.xml().path(),
                fmt::format("expected its cells to begin at {} along {} and to be {} wide, as {} says, found {} "
                            "and {}",
                            lower[axis], "xyz"[axis], spacing[axis], xml.path(), piece.lower()[axis],
                            piece.spacing()[axis]));
    }
}

} // namespace

VtkLevels readVtkLevels(const std::string& path)
{
    const VtkXml xml(path, listLimit);
    const std::string plane = xml.content().attribute("grid_description").as_string("XYZ");
    if (plane != "XYZ")
        throw Error(path, fmt::format("expected data of three dimensions (XYZ), found a grid_description '{}'", plane));
    VtkLevels levels;
    levels.place = path;
    const std::vector<pugi::xml_node> nodes = levelNodes(xml);
    readBlocks(xml, nodes, levels);
    for (std::size_t l = 0; l < nodes.size(); ++l) {
        if (levels.files[l].empty())
            continue;
        const VtkPiece piece(levels.files[l][0]);
        const Box3i& box = levels.boxes[l].boxes[0];
        const int width = 1 << levels.boxes[l].level;
        checkPlace(xml, nodes[l], piece, box);
        // Far indices are refused when the boxes are planned; here they only must not overflow.
        const vec3i index = glm::clamp(box.lower, vec3i(-coordinateLimit / width), vec3i(coordinateLimit / width));
        levels.worldFromVoxel = worldFromIndices(piece.lower(), index * width, piece.spacing() / double(width));
        levels.fields = piece.fields();
        return levels;
    }
    throw Error(path, "expected pieces with data, found no file");
}

} // namespace brickwall
