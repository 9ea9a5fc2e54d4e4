// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/scene/SceneOptions.h"

#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// The scene's options in one line, as hosts hand them to readers: words KEY=VALUE with spaces between them, names and
/// values as on the command line (`field=dens tolerance=1/500 iso=0.5,0.9 shading=off`). A value with spaces is quoted:
/// `colormap="Cool Warm"`. `_` in a key is taken for `-`.
///
/// Takes what it knows into `options` and returns the other words: a host's line may speak to several readers. Throws
/// Error, naming the option, for values that cannot be read or are out of their limits; `options` is unchanged then.
std::vector<std::string> readSceneText(std::string_view text, SceneOptions& options);

/// The line for what differs from the defaults, without the data's name; readSceneText gives it back, all of it.
std::string sceneText(const SceneOptions& options);

} // namespace brickwall
