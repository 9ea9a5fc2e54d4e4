// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/scene/SceneSetup.h"

#include <string>
#include <vector>

namespace brickwall {

/// Of one call of `render`: every repetition of every view.
struct RenderStatistics
{
    std::vector<double> totalMilliseconds;                ///< one per repetition
    std::vector<std::vector<ViewStatistics>> repetitions; ///< [repetition][view]
};

/// The JSON of `--stats` (docs/command.md describes its keys). Written to a temporary name and renamed when whole.
void writeStatistics(const std::string& path, const RenderStatistics& statistics, const std::string& data,
                     const RenderSettings& settings, const PreparedScene& prepared, const std::vector<Frame>& frames,
                     int threads);

/// A few lines for people: what was rendered, how, in which time, and what the bounded method achieved.
void printSummary(const RenderStatistics& statistics, const RenderSettings& settings, const PreparedScene& prepared,
                  const std::string& folder);

} // namespace brickwall
