// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/RandomLayout.h"

#include <utility>

namespace brickwall::oracles {
namespace {

class LayoutMaker
{
public:
    explicit LayoutMaker(const RandomLayoutConfig& config) : config_(config), random_(config.seed) {}

    std::vector<Brick> make()
    {
        const int width = config_.blockWidth << config_.coarsestLevel;
        for (int z = 0; z < config_.rootBlocks.z; ++z)
            for (int y = 0; y < config_.rootBlocks.y; ++y)
                for (int x = 0; x < config_.rootBlocks.x; ++x)
                    block(config_.lower + vec3i(x, y, z) * width, config_.coarsestLevel);
        if (bricks_.empty())
            bricks_.push_back({config_.lower, vec3i(config_.blockWidth), config_.coarsestLevel, 0});
        numberCells(bricks_);
        return std::move(bricks_);
    }

private:
    void block(const vec3i& lower, int level)
    {
        if (random_.real() < config_.hole)
            return;
        if (level == 0 || random_.real() >= config_.refined)
            return leaf({lower, vec3i(config_.blockWidth), level, 0});
        const int step = level >= 2 && random_.real() < config_.jump ? 2 : 1;
        const int width = config_.blockWidth << (level - step);
        for (int z = 0; z < 1 << step; ++z)
            for (int y = 0; y < 1 << step; ++y)
                for (int x = 0; x < 1 << step; ++x)
                    block(lower + vec3i(x, y, z) * width, level - step);
    }

    void leaf(const Brick& brick)
    {
        const int axis = random_.below(3);
        if (brick.size[axis] < 2 || random_.real() >= config_.cut) {
            bricks_.push_back(brick);
            return;
        }
        Brick a = brick, b = brick;
        a.size[axis] = 1 + random_.below(brick.size[axis] - 1);
        b.size[axis] = brick.size[axis] - a.size[axis];
        b.lower[axis] += a.size[axis] * brick.cellWidth();
        leaf(a);
        leaf(b);
    }

    const RandomLayoutConfig& config_;
    Random random_;
    std::vector<Brick> bricks_;
};

} // namespace

std::uint64_t Random::bits()
{
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

double Random::real()
{
    return double(bits() >> 11) * 0x1p-53;
}

std::vector<Brick> randomLayout(const RandomLayoutConfig& config)
{
    return LayoutMaker(config).make();
}

std::vector<Brick> uniformBlocks(const vec3i& blocks, int width, int level, const vec3i& lower)
{
    std::vector<Brick> bricks;
    for (int z = 0; z < blocks.z; ++z)
        for (int y = 0; y < blocks.y; ++y)
            for (int x = 0; x < blocks.x; ++x)
                bricks.push_back({lower + vec3i(x, y, z) * (width << level), vec3i(width), level, 0});
    numberCells(bricks);
    return bricks;
}

std::vector<Brick> nestedLevels(int levels, int blocks, int width)
{
    std::vector<Brick> bricks;
    vec3i lower(0);
    for (int level = levels - 1; level >= 0; --level) {
        const int blockWidth = width << level;
        const Box3i inner{lower + blocks / 4 * blockWidth, lower + blocks * 3 / 4 * blockWidth};
        for (const Brick& b : uniformBlocks(vec3i(blocks), width, level, lower))
            if (level == 0 || !inner.overlaps(b.box()))
                bricks.push_back(b);
        lower = inner.lower;
    }
    numberCells(bricks);
    return bricks;
}

std::uint64_t numberCells(std::vector<Brick>& bricks)
{
    std::uint64_t cells = 0;
    for (Brick& b : bricks) {
        b.begin = cells;
        cells += b.cellCount();
    }
    return cells;
}

std::vector<Cell> cellsOfBricks(std::span<const Brick> bricks)
{
    std::vector<Cell> cells;
    for (const Brick& b : bricks)
        for (int z = 0; z < b.size.z; ++z)
            for (int y = 0; y < b.size.y; ++y)
                for (int x = 0; x < b.size.x; ++x)
                    cells.push_back({b.lower + vec3i(x, y, z) * b.cellWidth(), b.level});
    return cells;
}

Field randomField(std::span<const Brick> bricks, std::uint64_t seed)
{
    Random random(seed);
    Field field{"random", "", {}, {}, {}};
    for (const Brick& b : bricks)
        for (std::uint64_t i = 0; i < b.cellCount(); ++i)
            field.values.push_back(float(2.0 * random.real() - 1.0));
    field.range = rangeOf(field.values);
    return field;
}

} // namespace brickwall::oracles
