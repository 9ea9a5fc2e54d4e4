// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Compare.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brickwall {

FrameDifference compareFrames(const Frame& a, const Frame& b)
{
    if (a.width != b.width || a.height != b.height || a.color.size() != b.color.size())
        throw Error("comparing frames", fmt::format("expected equal sizes, found {} x {} and {} x {}", a.width,
                                                    a.height, b.width, b.height));
    FrameDifference result;
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            const double d = std::abs(double(a.color[i][c]) - double(b.color[i][c]));
            if (!std::isfinite(d)) {
                ++result.nonFinite;
                continue;
            }
            sum += d;
            squares += d * d;
            result.max = std::max(result.max, d);
        }
    const double count = std::max<double>(1.0, 4.0 * double(a.color.size()));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (result.nonFinite > 0) {
        result.mean = result.max = result.rms = infinity;
        result.psnr = -infinity;
        return result;
    }
    result.mean = sum / count;
    result.rms = std::sqrt(squares / count);
    result.psnr = squares > 0.0 ? -10.0 * std::log10(squares / count) : infinity;
    return result;
}

} // namespace brickwall
