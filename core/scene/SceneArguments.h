// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/scene/SceneOptions.h"

#include <string>

namespace CLI {
class App;
}

namespace brickwall {

// The scene's options by their names on the command line, without a check of their limits (checkSceneOptions).

/// Adds DATA, a required argument, and --derive.
void addDataOption(CLI::App& command, SceneOptions& options);
void addDeriveOption(CLI::App& command, SceneOptions& options);
/// Adds what is shown and --threads.
void addSceneOptions(CLI::App& command, SceneOptions& options);
void addNonFiniteOption(CLI::App& command, SceneOptions& options);
void addBackgroundOption(CLI::App& command, SceneOptions& options);
/// Adds --method, --tolerance, --dt and --lod.
void addMethodOptions(CLI::App& command, SceneOptions& options);
/// Adds --lod, which is one of the above.
void addLodOption(CLI::App& command, SceneOptions& options);
/// Adds --write-tf.
void addWriteTfOption(CLI::App& command, std::string& file);
void addThreadsOption(CLI::App& command, int& threads);

} // namespace brickwall
