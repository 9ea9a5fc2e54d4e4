// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/PosedViews.h"

#include <utility>

namespace brickwall {

RigViews PosedViews::of(Rig& rig, const RigNavigation& navigation)
{
    const std::vector<mat4d>& heads = navigation.roomFromHeads();
    for (std::size_t i = 0; i < heads.size(); ++i)
        rig.viewers[i].roomFromHead = heads[i];
    RigViews views = viewsOfRig(rig, navigation.worldFromRoom());
    std::set<std::string> names;
    for (const RefusedView& view : views.refused) {
        names.insert(view.name);
        if (!refused_.contains(view.name))
            progress_.note(view.name + " stays black: " + view.reason);
    }
    refused_ = std::move(names);
    return views;
}

} // namespace brickwall
