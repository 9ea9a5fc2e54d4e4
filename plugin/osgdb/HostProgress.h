// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"

#include <osg/Notify>

#include <string>

namespace brickwall {

/// What is worth telling goes where the host's own notes go (OSG_NOTIFY_LEVEL).
class HostProgress : public Progress
{
public:
    void note(std::string_view line) override { OSG_NOTICE << "brickwall: " << std::string(line) << std::endl; }
};

} // namespace brickwall
