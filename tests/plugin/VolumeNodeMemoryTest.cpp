// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "NodeViewer.h"
#include "TestDisplay.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include <unistd.h>

namespace brickwall::test {
namespace {

double residentMegabytes()
{
    std::ifstream statm("/proc/self/statm");
    long total = 0, resident = 0;
    statm >> total >> resident;
    return double(resident) * double(sysconf(_SC_PAGESIZE)) / 1e6;
}

TEST(VolumeNode, LongAHundredLoadsAndUnloadsKeepTheMemoryFlat)
{
    BRICKWALL_NEEDS_DISPLAY();
    SceneOptions options;
    options.data = "sample:wake:60k";
    Progress silent;
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    NodeViewer shown(scene);
    double before = 0.0;
    for (int round = 0; round < 100; ++round) {
        osg::ref_ptr<VolumeNode> node = new VolumeNode;
        node->load(options, silent);
        const osg::BoundingSphere bounds = node->getBound();
        node->setTransform(osg::Matrixd::translate(-bounds.center()) *
                           osg::Matrixd::scale(osg::Vec3d(1, 1, 1) * (3.0 / bounds.radius())));
        scene->addChild(node);
        shown.settle(*node);
        scene->removeChild(node);
        node = nullptr;
        shown.viewer.frame();
        if (round == 30) // caches of the driver, the allocator and the threads are full by now
            before = residentMegabytes();
    }
    const double after = residentMegabytes();
    RecordProperty("megabytes", fmt::format("{:.1f} after 31, {:.1f} after 100", before, after));
    EXPECT_LT(after, before + 10.0) << "one node with its data takes about 5 MB";
}

} // namespace
} // namespace brickwall::test
