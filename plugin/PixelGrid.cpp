// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/PixelGrid.h"

#include "brickwall/plugin/FreshArray.h"

#include <algorithm>
#include <cstddef>

namespace brickwall {
namespace {

float placeOf(int index, int count)
{
    return std::clamp(float(index) - 0.5f, 0.0f, float(count));
}

/// Rows of vertices as one triangle strip; it goes from row to row through triangles without an area.
osg::ref_ptr<osg::DrawElementsUInt> stripOf(int columns, int rows)
{
    osg::ref_ptr<osg::DrawElementsUInt> strip = new osg::DrawElementsUInt(GL_TRIANGLE_STRIP);
    strip->reserve(std::size_t(rows - 1) * (2 * columns + 2));
    for (int row = 0; row + 1 < rows; ++row) {
        const unsigned lower = unsigned(row) * columns, upper = lower + columns;
        if (row > 0)
            strip->push_back(lower);
        for (int column = 0; column < columns; ++column) {
            strip->push_back(lower + column);
            strip->push_back(upper + column);
        }
        strip->push_back(upper + columns - 1);
    }
    return strip;
}

} // namespace

PixelGrid::PixelGrid(int width, int height, bool withMesh)
    : width_(width), height_(height), vertices_(makeFreshArray<osg::Vec2Array>())
{
    const int columns = width + 2, rows = height + 2;
    vertices_->reserve(std::size_t(columns) * rows);
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column)
            vertices_->push_back(osg::Vec2(placeOf(column, width), placeOf(row, height)));
    }
    points_ = new osg::DrawArrays(GL_POINTS, 0, int(vertices_->size()));
    if (withMesh)
        mesh_ = stripOf(columns, rows);
}

} // namespace brickwall
