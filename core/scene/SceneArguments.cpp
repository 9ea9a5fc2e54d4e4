// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/scene/SceneArguments.h"

#include <CLI/CLI.hpp>

namespace brickwall {
namespace {

/// A list takes what its commas join, and not the argument after that.
void addList(CLI::App& command, const char* name, std::vector<double>& list, const char* description)
{
    command.add_option(name, list, description)->delimiter(',')->allow_extra_args(false);
}

} // namespace

void addDataOption(CLI::App& command, SceneOptions& options)
{
    command.add_option("DATA", options.data, "a file, a folder, or sample:NAME[:SIZE]")->required();
    addDeriveOption(command, options);
}

void addDeriveOption(CLI::App& command, SceneOptions& options)
{
    command.add_option("--derive", options.derive, "a field more: \"NAME = EXPRESSION of fields\" (may be repeated)")
        ->allow_extra_args(false);
}

void addThreadsOption(CLI::App& command, int& threads)
{
    constexpr int mostThreads = 1024; // the system refuses far larger numbers in the middle of the work
    command.add_option("--threads", threads, "0 (default): one per core")->check(CLI::Range(0, mostThreads));
}

void addNonFiniteOption(CLI::App& command, SceneOptions& options)
{
    command.add_option("--non-finite", options.nonFinite,
                       "cells with a NaN or an infinite value: error (default), or empty to leave them out");
}

void addSceneOptions(CLI::App& command, SceneOptions& options)
{
    command.add_option("--field", options.field, "the field to show (default: the data set's choice)");
    addNonFiniteOption(command, options);
    command.add_option("--tf", options.transferFunction,
                       "transfer function: .xf or JSON (default: chosen from the data)");
    command.add_option("--colormap", options.colorMap, "colour map by name");
    addList(command, "--range", options.range, "LO,HI: the values that the transfer function covers");
    command.add_option("--color-field", options.colorField,
                       "the field whose values say in which colour volume, surfaces and planes are (default: --field)");
    addList(command, "--color-range", options.colorRange,
            "LO,HI: the values of that field that the colour map covers (default: chosen from the data)");
    command.add_option("--opacity-scale", options.opacityScale, "multiplies all opacities (default 1)");
    command.add_option("--shading", options.shading, "headlight (default) or off");
    addList(command, "--iso", options.iso, "VALUE[,VALUE...]: show the surfaces where the field has these values");
    addList(command, "--iso-color", options.isoColors,
            "R,G,B in [0, 1] as displayed, for all surfaces or once per value (default: of the transfer function)");
    addList(command, "--iso-opacity", options.isoOpacity,
            "A, for all surfaces or A[,A...] per value, in (0, 1] (default 1)");
    command.add_option("--mesh", options.meshes, "opaque triangles: .obj, .ply, .stl or .tris (may be repeated)")
        ->allow_extra_args(false);
    command.add_option("--mesh-scale", options.meshScale, "multiplies the coordinates of meshes (default 1)");
    addList(command, "--mesh-offset", options.meshOffset, "X,Y,Z: moves meshes after that, in the data's coordinates");
    addList(command, "--mesh-color", options.meshColor, "R,G,B as displayed (default: the file's materials, or grey)");
    addList(command, "--light", options.light,
            "X,Y,Z: where a light comes from that casts shadows, in the data's coordinates (default: none)");
    command.add_option("--ambient", options.ambient, "of the light, what comes from everywhere (default 0.2)");
    command.add_option_function<std::string>(
        "--light-tolerance",
        [&options](const std::string& text) { options.lightTolerance = parseNumber(text, "--light-tolerance"); },
        "how wrong shadows in the volume may make a component (default 1/64)");
    command.add_option("--specular", options.specular,
                       "of surfaces and meshes: how bright their white spots are, in [0, 1] (default 0)");
    command.add_option("--shininess", options.shininess, "of these spots: Phong's exponent, 1 to 1000 (default 32)");
    command.add_option("--ambient-occlusion", options.ambientOcclusion,
                       "DISTANCE: surfaces and meshes are darker where others are nearer than this (default 0: off)");
    command.add_option("--ambient-occlusion-rays", options.ambientOcclusionRays,
                       "per point, 1 to 1024: fewer are faster and noisier (default 16)");
    addList(command, "--plane", options.planes,
            "X,Y,Z,OFFSET: show the field's values where (X,Y,Z).p = OFFSET (may be repeated)");
    command.add_option("--plane-opacity", options.planeOpacity, "of these planes, in (0, 1] (default 1)");
    command
        .add_option("--streamlines", options.streamlines,
                    "COUNT or NXxNYxNZ seeds in the data, or in a box: COUNT:x0,y0,z0,x1,y1,z1 (may be repeated)")
        ->allow_extra_args(false);
    command.add_option("--streamline-vector", options.streamlineVector,
                       "whose lines (default: the first vector of the data)");
    command.add_option("--streamline-length", options.streamlineLength,
                       "to either side of a seed, in the data's units (default: twice their diagonal)");
    command.add_option("--streamline-radius", options.streamlineRadius,
                       "of the tubes, in the same units (default: their diagonal / 1000)");
    addList(command, "--clip-plane", options.clipPlanes,
            "X,Y,Z,OFFSET: show only where (X,Y,Z).p >= OFFSET (may be repeated)");
    addList(command, "--clip-box", options.clipBox, "X0,Y0,Z0,X1,Y1,Z1: show only what is inside");
    addList(command, "--clip-sphere", options.clipSphere, "X,Y,Z,RADIUS: show only what is inside");
    command.add_option("--volume", options.volume, "on (default), or off to show nothing but surfaces");
    addThreadsOption(command, options.threads);
}

void addBackgroundOption(CLI::App& command, SceneOptions& options)
{
    addList(command, "--background", options.background, "R,G,B in [0, 1] as displayed (default black)");
}

void addMethodOptions(CLI::App& command, SceneOptions& options)
{
    command.add_option("--method", options.method,
                       "bounded (default), fixed, midpoint, bracket, preintegrated or reference");
    command.add_option_function<std::string>(
        "--tolerance", [&options](const std::string& text) { options.tolerance = parseNumber(text, "--tolerance"); },
        "of bounded: the largest error of a linear premultiplied component (default 1/255)");
    command.add_option_function<double>(
        "--dt", [&options](double dt) { options.dt = dt; },
        "of fixed, midpoint, bracket, preintegrated: step in finest cell widths of the region (default 0.5)");
    addLodOption(command, options);
}

void addLodOption(CLI::App& command, SceneOptions& options)
{
    command.add_option("--lod", options.lod,
                       "PIXELS: far away, data averaged into cells about so many pixels wide (default 0: never)");
}

void addWriteTfOption(CLI::App& command, std::string& file)
{
    command.add_option("--write-tf", file, "write the transfer function that is used, colours and all, to this JSON");
}

} // namespace brickwall
