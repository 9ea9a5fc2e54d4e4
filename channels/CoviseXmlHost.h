// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/CoviseXmlConfig.h"

namespace brickwall {

/// What one host shows; no channels if it shows none. Windows and their displays are named as the host sees them.
/// Channels are named after their screens, so that channels of one screen have one name.
Rig rigOfCoviseHost(const CoviseConfig& config);

} // namespace brickwall
