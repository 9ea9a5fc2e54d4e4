// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"
#include "brickwall/core/render/View.h"
#include "brickwall/core/scene/SceneOptions.h"

#include <optional>
#include <string>
#include <vector>

namespace brickwall {

/// What a script says must be seen at a pixel (x to the right, y upwards from the lower-left one).
struct ExpectedHit
{
    int x = 0;
    int y = 0;
    double depth = 1.0; ///< window depth; 1: nothing is hit
    double tolerance = 1e-4;
};

/// What a script expects of a view's frame; what is absent is not checked.
struct Expectation
{
    std::string image; ///< an EXR; empty: none
    std::optional<double> meanDifference, maxDifference, psnr;
    std::optional<double> alphaSum;
    double alphaTolerance = 1e-3; ///< relative
    std::vector<ExpectedHit> hits;
};

struct ScriptedView
{
    View view;
    Expectation expect;
};

/// A script of camera matrices (docs/verify.md): the views, and for `verify` the data and how they are shown.
struct ViewFile
{
    std::string path;
    SceneOptions scene; ///< `data` empty if the file names none
    std::vector<ScriptedView> views;
};

/// Paths in the file are relative to it. Throws Error naming the file and the view.
ViewFile readViewFile(const std::string& path);

/// What differs from the expectation, one line each; empty: all as expected.
std::vector<std::string> failuresOf(const Expectation& expectation, const Frame& frame);

} // namespace brickwall
