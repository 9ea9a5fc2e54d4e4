// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/RigFiles.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <string>

namespace brickwall::testing_rigs {

inline const std::filesystem::path displays = BRICKWALL_SOURCE_DIR "/../shared/displays";

/// A file of this test alone, with this text.
inline std::string fileOf(const std::string& text, const std::string& suffix)
{
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    const std::string path = test::scratchFile(std::string(info->test_suite_name()) + "." + info->name() + suffix);
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

inline Rig rigOf(const std::string& text, const RigScope& scope = {}, const std::string& suffix = ".rig")
{
    return loadRig(fileOf(text, suffix), scope);
}

/// The message that loading the text gives, without the folder.
inline std::string errorOf(const std::string& text, const RigScope& scope = {}, const std::string& suffix = ".rig")
{
    const std::string path = fileOf(text, suffix);
    try {
        loadRig(path, scope);
    } catch (const Error& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.rfind(path, 0), 0u) << message;
        return message.substr(path.size());
    }
    return "no error";
}

inline bool anyContains(const std::vector<std::string>& lines, const std::string& part)
{
    for (const std::string& line : lines)
        if (line.find(part) != std::string::npos)
            return true;
    return false;
}

inline void expectNear(const vec3d& found, const vec3d& expected, double tolerance = 1e-12)
{
    EXPECT_LE(glm::distance(found, expected), tolerance)
        << "found (" << found.x << ", " << found.y << ", " << found.z << "), expected (" << expected.x << ", "
        << expected.y << ", " << expected.z << ")";
}

inline const Screen& screenNamed(const Rig& rig, const std::string& name)
{
    for (const Screen& screen : rig.screens)
        if (screen.name == name)
            return screen;
    ADD_FAILURE() << "no screen " << name;
    return rig.screens.at(0);
}

} // namespace brickwall::testing_rigs
