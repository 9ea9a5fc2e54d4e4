// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// To be preloaded: no library is unloaded, so that the leak sanitizer, which looks at the end, can name the driver of
/// OpenGL (lsan.supp), which is gone by then.
extern "C" int dlclose(void*) noexcept
{
    return 0;
}
