// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// Three fields that are the components of one vector, by their names.
struct VectorFields
{
    std::string name;                      ///< "velocity" for x_velocity, "vel" for velx
    std::array<std::string, 3> components; ///< x, y, z

    /// What its length is called where fields are named: "velocity_magnitude".
    std::string magnitude() const { return name + "_magnitude"; }
};

/// Recognises NAME_x NAME_y NAME_z, x_NAME y_NAME z_NAME (with _ - . a blank or nothing between; x y z may be capitals,
/// or 0 1 2 behind a separator), and u v w, which is "velocity". In the order of their x components. All three have to
/// be there.
std::vector<VectorFields> findVectors(std::span<const std::string> fields);

} // namespace brickwall
