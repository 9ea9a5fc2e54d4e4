// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/WriteAmrex.h"

#include "brickwall/tests/oracles/WriteExa.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <limits>

namespace brickwall::oracles {
namespace {

std::string text(const vec3i& v)
{
    return fmt::format("({},{},{})", v.x, v.y, v.z);
}

std::string text(const Box3i& b)
{
    return fmt::format("({} {} (0,0,0))", text(b.lower), text(b.upper - 1));
}

std::string text(const vec3d& v)
{
    return fmt::format("{} {} {}\n", v.x, v.y, v.z);
}

int refinement(const Plotfile3& p, std::size_t level)
{
    int r = 1;
    for (std::size_t i = 0; i < level; ++i)
        r *= p.ratios[i];
    return r;
}

std::string header(const Plotfile3& p)
{
    std::string s = fmt::format("{}\n{}\n{}\n3\n0.25\n{}\n", p.version, p.components.size(),
                                fmt::join(p.components, "\n"), p.boxes.size() - 1);
    s += text(p.lower) + text(p.lower + vec3d(p.domain.extent()) * p.cellSize);
    s += p.oneRatioForAll ? fmt::format("{} \n", p.ratios[0]) : fmt::format("{} \n", fmt::join(p.ratios, " "));
    for (std::size_t l = 0; l < p.boxes.size(); ++l)
        s += text(Box3i{p.domain.lower * refinement(p, l), p.domain.upper * refinement(p, l)}) + " ";
    s += "\n";
    for (std::size_t l = 0; l < p.boxes.size(); ++l)
        s += "7 ";
    s += "\n";
    for (std::size_t l = 0; l < p.boxes.size(); ++l)
        s += text(p.cellSize / double(refinement(p, l)));
    s += "0\n0\n";
    for (std::size_t l = 0; l < p.boxes.size(); ++l) {
        const vec3d dx = p.cellSize / double(refinement(p, l));
        s += fmt::format("{} {} 0.25\n7\n", l, p.boxes[l].size());
        for (const Box3i& b : p.boxes[l])
            for (int axis = 0; axis < 3; ++axis)
                s += fmt::format("{} {}\n", p.lower[axis] + b.lower[axis] * dx[axis],
                                 p.lower[axis] + b.upper[axis] * dx[axis]);
        s += fmt::format("Level_{}/Cell\n", l);
    }
    return s;
}

template <class T>
void append(std::string& bytes, T number, bool bigEndian)
{
    auto raw = std::bit_cast<std::array<char, sizeof(T)>>(number);
    if (bigEndian != (std::endian::native == std::endian::big))
        std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

std::string fab(const Plotfile3& p, int level, const Box3i& box)
{
    const Box3i grown{box.lower - p.ghosts, box.upper + p.ghosts};
    const std::string bits = p.floats ? "(8, (32 8 23 0 1 9 0 127))" : "(8, (64 11 52 0 1 12 0 1023))";
    const std::string order = p.floats ? (p.bigEndian ? "(4, (1 2 3 4))" : "(4, (4 3 2 1))")
                                       : (p.bigEndian ? "(8, (1 2 3 4 5 6 7 8))" : "(8, (8 7 6 5 4 3 2 1))");
    std::string s = fmt::format("FAB ({},{}){} {}\n", bits, order, text(grown), p.components.size());
    for (int c = 0; c < static_cast<int>(p.components.size()); ++c)
        for (int z = grown.lower.z; z < grown.upper.z; ++z)
            for (int y = grown.lower.y; y < grown.upper.y; ++y)
                for (int x = grown.lower.x; x < grown.upper.x; ++x) {
                    const vec3i cell(x, y, z);
                    const double v =
                        box.contains(cell) ? p.value(level, c, cell) : std::numeric_limits<double>::quiet_NaN();
                    p.floats ? append(s, static_cast<float>(v), p.bigEndian) : append(s, v, p.bigEndian);
                }
    return s;
}

void writeLevel(const std::string& folder, const Plotfile3& p, int level)
{
    std::filesystem::create_directories(folder);
    const auto& boxes = p.boxes[static_cast<std::size_t>(level)];
    std::string head = fmt::format("1\n1\n{}\n{}\n({} 0\n", p.components.size(), p.ghosts, boxes.size());
    for (const Box3i& b : boxes)
        head += text(b) + "\n";
    head += fmt::format(")\n{}\n", boxes.size());
    std::vector<std::string> files;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (i % static_cast<std::size_t>(p.boxesPerFile) == 0)
            files.emplace_back();
        head += fmt::format("FabOnDisk: Cell_D_{:05} {}\n", files.size() - 1, files.back().size());
        files.back() += fab(p, level, boxes[i]);
    }
    writeText(folder + "/Cell_H", head + "\n");
    for (std::size_t f = 0; f < files.size(); ++f)
        writeText(fmt::format("{}/Cell_D_{:05}", folder, f), files[f]);
}

} // namespace

void writePlotfile(const std::string& folder, const Plotfile3& plotfile)
{
    std::filesystem::create_directories(folder);
    writeText(folder + "/Header", header(plotfile));
    for (std::size_t l = 0; l < plotfile.boxes.size(); ++l)
        writeLevel(fmt::format("{}/Level_{}", folder, l), plotfile, static_cast<int>(l));
}

} // namespace brickwall::oracles
