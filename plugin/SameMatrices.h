// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Matrixd>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace brickwall {

/// Whether two matrices are the same but for the rounding of a host that computes them anew for each frame.
inline bool same(const osg::Matrixd& a, const osg::Matrixd& b, std::initializer_list<int> columns = {0, 1, 2, 3})
{
    constexpr double rounding = 1e-9;
    double largest = 0.0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(b.ptr()[i]));
    for (int row = 0; row < 4; ++row) {
        for (const int column : columns) {
            const double x = a(row, column), y = b(row, column);
            if (!(std::abs(x - y) <= rounding * std::max(std::abs(y), 1e-3 * largest)))
                return false;
        }
    }
    return true;
}

/// The same for projections, whatever near and far are: these are not known before the end of a cull traversal.
inline bool sameButForDepth(const osg::Matrixd& a, const osg::Matrixd& b)
{
    return same(a, b, {0, 1, 3});
}

} // namespace brickwall
