// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Error.h"

#include <gtest/gtest.h>

#include <string>

namespace brickwall::test {

/// What the Error says that `work` throws; a failure of the test if it throws none.
template <class Work>
std::string errorOf(const Work& work)
{
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    ADD_FAILURE() << "expected an Error";
    return {};
}

} // namespace brickwall::test
