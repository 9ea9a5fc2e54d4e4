// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// VolumeNode in .osgt, .osgb and .osgx: the name of the data and the properties, not the cells. OSG finds this by the
/// class's name, brickwall::VolumeNode, in osgdb_brickwall.
#include "FindData.h"
#include "HostProgress.h"

#include "brickwall/core/scene/SceneText.h"
#include "brickwall/core/shade/TransferFunctionFile.h"
#include "brickwall/plugin/VolumeNode.h"

#include <osgDB/InputStream>
#include <osgDB/ObjectWrapper>
#include <osgDB/OutputStream>

namespace brickwall {
namespace {

/// A stream's reader may not throw; what is wrong becomes a notice, and the rest of the file is read.
template <class Work>
bool noticing(const Work& work)
{
    try {
        work();
    } catch (const std::exception& error) {
        OSG_WARN << "brickwall: " << error.what() << std::endl;
    }
    return true;
}

bool checkData(const VolumeNode& node)
{
    return !node.options().data.empty();
}

bool readData(osgDB::InputStream& in, VolumeNode& node)
{
    SceneOptions options = node.options();
    in.readWrappedString(options.data);
    return noticing([&] { node.setOptions(options); });
}

bool writeData(osgDB::OutputStream& out, const VolumeNode& node)
{
    out.writeWrappedString(node.options().data);
    out << std::endl;
    return true;
}

bool checkOptions(const VolumeNode& node)
{
    return !sceneText(node.options()).empty();
}

bool readOptions(osgDB::InputStream& in, VolumeNode& node)
{
    std::string text;
    in.readWrappedString(text);
    return noticing([&] {
        SceneOptions options = node.options();
        for (const std::string& word : readSceneText(text, options))
            OSG_WARN << "brickwall: unknown option in the file: " << word << std::endl;
        node.setOptions(options);
    });
}

bool writeOptions(osgDB::OutputStream& out, const VolumeNode& node)
{
    out.writeWrappedString(sceneText(node.options()));
    out << std::endl;
    return true;
}

bool checkOwnFunction(const VolumeNode& node)
{
    return node.transferFunction().has_value();
}

bool readOwnFunction(osgDB::InputStream& in, VolumeNode& node)
{
    std::string text;
    in.readWrappedString(text);
    return noticing([&] { node.setTransferFunction(transferFunctionOf(text, "TransferFunction")); });
}

bool writeOwnFunction(osgDB::OutputStream& out, const VolumeNode& node)
{
    out.writeWrappedString(toJson(*node.transferFunction()));
    out << std::endl;
    return true;
}

bool checkFps(const VolumeNode& node)
{
    return node.fps().has_value();
}

bool readFps(osgDB::InputStream& in, VolumeNode& node)
{
    double fps = 0.0;
    in >> fps;
    node.setFps(fps);
    return true;
}

bool writeFps(osgDB::OutputStream& out, const VolumeNode& node)
{
    out << *node.fps() << std::endl;
    return true;
}

bool checkTransform(const VolumeNode& node)
{
    return !node.transform().isIdentity();
}

bool readTransform(osgDB::InputStream& in, VolumeNode& node)
{
    osg::Matrixd transform;
    in >> transform;
    node.setTransform(transform);
    return true;
}

bool writeTransform(osgDB::OutputStream& out, const VolumeNode& node)
{
    out << node.transform() << std::endl;
    return true;
}

/// Once all properties are there. Data that cannot be read leave a node that shows nothing, but keeps its properties.
struct ReadData : osgDB::FinishedObjectReadCallback
{
    void objectRead(osgDB::InputStream& in, osg::Object& object) override
    {
        VolumeNode& node = static_cast<VolumeNode&>(object);
        if (node.options().data.empty())
            return;
        noticing([&] {
            SceneOptions options = node.options();
            const std::string found = findData(options.data, in.getOptions());
            options.data = found.empty() ? options.data : found;
            HostProgress progress;
            node.load(options, progress);
        });
    }
};

} // namespace
} // namespace brickwall

REGISTER_OBJECT_WRAPPER(brickwall_VolumeNode, new brickwall::VolumeNode, brickwall::VolumeNode,
                        "osg::Object osg::Node brickwall::VolumeNode")
{
    using namespace brickwall;
    wrapper->addSerializer(new osgDB::UserSerializer<MyClass>("Data", &checkData, &readData, &writeData),
                           osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(new osgDB::UserSerializer<MyClass>("Options", &checkOptions, &readOptions, &writeOptions),
                           osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(
        new osgDB::UserSerializer<MyClass>("TransferFunction", &checkOwnFunction, &readOwnFunction, &writeOwnFunction),
        osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(
        new osgDB::UserSerializer<MyClass>("Transform", &checkTransform, &readTransform, &writeTransform),
        osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(new osgDB::UserSerializer<MyClass>("Fps", &checkFps, &readFps, &writeFps),
                           osgDB::BaseSerializer::RW_USER);
    wrapper->addSerializer(new osgDB::PropByValSerializer<MyClass, bool>("SceneDepth", true, &MyClass::sceneDepth,
                                                                         &MyClass::setSceneDepth),
                           osgDB::BaseSerializer::RW_BOOL);
    wrapper->addFinishedObjectReadCallback(new ReadData);
}
