// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace brickwall {

/// How many rays one instruction handles on this machine, and the name of the instruction set, as chosen at run time.
int laneCount();
std::string laneTarget();

/// All instruction sets that were compiled and that this machine has, best first.
std::vector<std::string> laneTargets();

/// From now on uses this one of laneTargets(), or the best if empty: for tests and benchmarks, while nothing else runs.
/// Throws Error for a name that is not among them.
void chooseLaneTarget(const std::string& name);

} // namespace brickwall
