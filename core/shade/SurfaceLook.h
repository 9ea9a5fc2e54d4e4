// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace brickwall {

/// The white spot on isosurfaces and triangles where they mirror the light, or the headlight where there is no light:
/// strength V max(0, r.e)^shininess is added to their colour, where e points to the eye, r where the normal mirrors the
/// direction of the light to, and V is as in Light (Phong, Illumination for computer generated pictures, 1975).
/// Components of the sum end at 1.
struct Specular
{
    float strength = 0.0f;   ///< in [0, 1]; 0: none
    float shininess = 32.0f; ///< in [1, 1000]

    bool operator==(const Specular&) const = default;
};

/// Of what comes from everywhere, less reaches isosurfaces and triangles where others are near: the part of the
/// directions above the surface, weighted with their cosine, in which nothing lies within a distance (Zhukov, Iones,
/// Kronin: An ambient light illumination model, 1998). A translucent isosurface takes its opacity away; the volume is
/// not asked. It multiplies the ambient part of the light, or the whole colour where there is no light.
struct AmbientOcclusion
{
    double distance = 0.0; ///< world space; above 0, may be infinite
    int rays = 16;         ///< per point, in [1, 1024]: the error falls a little faster than with their root

    bool operator==(const AmbientOcclusion&) const = default;
};

} // namespace brickwall
