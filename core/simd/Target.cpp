// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/simd/Target.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/simd/Lanes.h"
#include "brickwall/core/simd/Target.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

int countLanes()
{
    return laneCount;
}

const char* nameTarget()
{
    return hwy::TargetName(HWY_TARGET);
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "brickwall/core/base/Error.h"

#include <algorithm>

namespace brickwall {

HWY_EXPORT(countLanes);
HWY_EXPORT(nameTarget);

int laneCount()
{
    return HWY_DYNAMIC_DISPATCH(countLanes)();
}

std::string laneTarget()
{
    return HWY_DYNAMIC_DISPATCH(nameTarget)();
}

std::vector<std::string> laneTargets()
{
    std::vector<std::string> names;
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
        names.emplace_back(hwy::TargetName(target));
    return names;
}

void chooseLaneTarget(const std::string& name)
{
    hwy::SetSupportedTargetsForTest(0); // back to what the machine has
    std::int64_t chosen = hwy::SupportedTargets();
    if (!name.empty()) {
        const std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
        const auto found = std::find_if(targets.begin(), targets.end(),
                                        [&](std::int64_t target) { return name == hwy::TargetName(target); });
        if (found == targets.end())
            throw Error("instruction set", "'" + name + "' was not compiled, or this machine does not have it");
        chosen = *found;
    }
    hwy::GetChosenTarget().Update(chosen);
}

} // namespace brickwall
#endif
