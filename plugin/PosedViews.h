// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/plugin/RigNavigation.h"

#include <set>
#include <string>

namespace brickwall {

/// The views of a rig whose heads and data the user moves. A view that is refused is noted once, until it comes back.
class PosedViews
{
public:
    explicit PosedViews(Progress& progress) : progress_(progress) {}

    /// Those of the present pose. The rig's viewers are moved to the heads; viewers that layoutOf has appended belong to
    /// channels without head tracking and stay.
    RigViews of(Rig& rig, const RigNavigation& navigation);

private:
    Progress& progress_;
    std::set<std::string> refused_;
};

} // namespace brickwall
