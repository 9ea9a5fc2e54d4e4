// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

/// Compiles the including source once per instruction set. The source defines HWY_TARGET_INCLUDE as its own include
/// path before it includes this, puts its code between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE into namespace
/// brickwall::HWY_NAMESPACE, and inside `#if HWY_ONCE` exports and dispatches what others call. See simd/Target.cpp,
/// the smallest such source.
#include <hwy/foreach_target.h>
