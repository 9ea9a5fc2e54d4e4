// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/FreeMemory.h"

#include <malloc.h>

namespace brickwall {

void releaseFreeMemory()
{
#ifdef __GLIBC__
    static_cast<void>(::malloc_trim(0));
#endif
}

} // namespace brickwall
