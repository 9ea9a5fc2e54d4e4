// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/tests/render/RenderScenes.h"

#include <string>
#include <vector>

namespace brickwall::test {

/// A small scene in which some way to integrate a volume breaks.
struct Exhibit
{
    std::string name; ///< a row of the table
    Scene scene;
    std::vector<View> views;
    Shading shading = Shading::off;
    float dt = 0.5f;   ///< of the methods that take steps
    bool keeps = true; ///< false: not even floats could keep the tolerance, so that only finite numbers are expected
};

/// The largest errors of any component of any pixel against Method::reference.
struct Errors
{
    double fixed = 0.0, midpoint = 0.0, bracket = 0.0, preintegrated = 0.0;
    double bounded = 0.0, boundedFine = 0.0;   ///< with the tolerances 1/255 and 1e-3
    double samples = 0.0, samplesOfFine = 0.0; ///< of bounded, per pixel
    double most = 0.0;                         ///< the largest component of the reference
};

/// Renders an exhibit by every method, expects of bounded and of surfaces what they promise (no exception, nothing that
/// is not finite, the tolerance kept, with every instruction set of this machine), and makes it a row of the table,
/// which is written as Markdown to the file that the environment variable BRICKWALL_STABILITY_TABLE names, when all
/// tests of the program are done.
Errors show(const Exhibit& exhibit);

/// The settings in which the exhibits are shown: no early end of rays but where nothing can be seen.
RenderSettings exhibitSettings(Method method, float dtOrTolerance, Shading shading);

/// Extinction `peak` per cell at `value`, falling linearly to nothing at half a width to either side.
TransferFunction spike(Range range, float value, float width, float peak);

} // namespace brickwall::test
