// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Renderer.h"

#include <nlohmann/json.hpp>

namespace brickwall {

/// The keys "light", "specular" and "ambient_occlusion" of the files that tell how something was rendered; those of
/// what is off are not there.
inline nlohmann::json lightJson(const RenderSettings& settings)
{
    nlohmann::json result = nlohmann::json::object();
    if (const auto& light = settings.light)
        result["light"] = {{"towards", {light->towards.x, light->towards.y, light->towards.z}},
                           {"ambient", light->ambient},
                           {"tolerance", light->tolerance}};
    if (settings.specular.strength > 0.0f)
        result["specular"] = {{"strength", settings.specular.strength}, {"shininess", settings.specular.shininess}};
    if (const auto& occlusion = settings.ambientOcclusion)
        result["ambient_occlusion"] = {{"distance", occlusion->distance}, {"rays", occlusion->rays}};
    return result;
}

} // namespace brickwall
