// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <string>

/// What all examples take: [DATA] [--out FILE] [--frames N].
struct Arguments
{
    std::string data = "sample:wake:100k";
    std::string out;
    int frames = 0; ///< 0: until the window is closed
};

/// Runs an example; what it throws becomes one line and exit code 2.
inline int runExample(int argc, char** argv, const Arguments& defaults,
                      const std::function<void(const Arguments&)>& example)
{
    Arguments arguments = defaults;
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--out" && i + 1 < argc)
            arguments.out = argv[++i];
        else if (word == "--frames" && i + 1 < argc)
            arguments.frames = std::atoi(argv[++i]);
        else
            arguments.data = word;
    }
    try {
        example(arguments);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
        return 2;
    }
}
