// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include <brickwall/channels/RigFiles.h>
#include <brickwall/core/io/DataSet.h>
#include <brickwall/core/render/Renderer.h>
#include <brickwall/core/shade/ColorMaps.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

using namespace brickwall;

/// The whole way in one page: data, regions, a rig's views, frames. Exits with 0 if something was seen.
int main()
{
    const Executor executor;
    Progress silent;
    const Model model = openDataSet("sample:wake:100k")->load(std::vector<std::string>{"speed"}, executor, silent);

    Scene scene;
    scene.regions = std::make_shared<RegionTree>(buildRegions(model.bricks, executor, silent));
    scene.field =
        std::make_shared<PaddedField>(padField(model.fields[0], model.bricks, *scene.regions, executor, silent));
    scene.worldFromVoxel = model.worldFromVoxel;
    scene.transferFunction.range = model.fields[0].range;
    scene.transferFunction.colors = colorMap("viridis");
    scene.transferFunction.opacity = {{0.0f, 0.1f}, {1.0f, 0.0f}};

    const Rig rig = loadRig("desktop");
    const Box3d bounds = worldBounds(model);
    std::vector<View> views;
    for (const ChannelView& view : viewsOfRig(rig, worldFromRoom(rig, bounds.lower, bounds.upper)).views)
        views.push_back(view.view);
    const Renderer renderer(scene, executor);
    double opacity = 0.0;
    for (const Frame& frame : renderer.render(views, {}, silent))
        for (const vec4f& color : frame.color)
            opacity += color.a;
    std::printf("%zu views, mean opacity %g\n", views.size(), opacity);
    return opacity > 0.0 ? 0 : 1;
}
