// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFilesRecord.h"

namespace brickwall {

/// Our JSON file as a record. Throws Error with the line of the first mistake in the JSON.
RigRecord recordOfJson(const RigText& source);

} // namespace brickwall
