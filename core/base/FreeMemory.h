// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace brickwall {

/// Gives the system what this process has freed but keeps for later: after work that has taken and freed many small
/// things, before other things that are large.
void releaseFreeMemory();

} // namespace brickwall
