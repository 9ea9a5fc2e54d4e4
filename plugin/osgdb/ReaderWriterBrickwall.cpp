// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "FindData.h"
#include "HostProgress.h"

#include "brickwall/channels/FrameRate.h"
#include "brickwall/core/io/OpenIfKnown.h"
#include "brickwall/core/scene/SceneText.h"
#include "brickwall/plugin/VolumeNode.h"

#include <osg/Notify>
#include <osgDB/FileNameUtils>
#include <osgDB/FileUtils>
#include <osgDB/Registry>

#include <optional>
#include <sstream>

namespace brickwall {
namespace {

const std::string pseudoExtension = "brickwall";

/// A file may really be called so (our own format); otherwise the extension only says who is to read it.
std::string withoutPseudoExtension(const std::string& file, const osgDB::Options* options)
{
    const bool isSample = file.rfind("sample:", 0) == 0;
    if (osgDB::getLowerCaseFileExtension(file) != pseudoExtension || (!isSample && !findData(file, options).empty()))
        return file;
    return file.substr(0, file.size() - pseudoExtension.size() - 1);
}

/// What the host's options say of a node.
struct NodeOptions
{
    SceneOptions scene;
    std::optional<double> fps = usualFps;
};

NodeOptions optionsFor(const std::string& data, const osgDB::Options* options)
{
    NodeOptions node;
    SceneOptions& scene = node.scene;
    if (options) {
        for (const std::string& word : readSceneText(options->getOptionString(), scene)) {
            if (word.rfind("fps=", 0) == 0)
                node.fps = parseFps(word.substr(4), "fps");
            else if (word.find('=') != std::string::npos)
                OSG_NOTICE << "brickwall: the option " << word << " is none of ours" << std::endl;
        }
        if (!scene.transferFunction.empty()) {
            const std::string found = osgDB::findDataFile(scene.transferFunction, options);
            scene.transferFunction = found.empty() ? scene.transferFunction : found;
        }
    }
    scene.data = data;
    return node;
}

} // namespace

/// Makes a VolumeNode of everything that core/io reads. Which of it is ours, the content says, not the extension.
class ReaderWriterBrickwall : public osgDB::ReaderWriter
{
public:
    ReaderWriterBrickwall()
    {
        supportsExtension(pseudoExtension, "Brickwall: NAME.brickwall for any data that it reads");
        std::istringstream extensions(BRICKWALL_EXTENSIONS);
        for (std::string extension; extensions >> extension;)
            supportsExtension(extension, "Brickwall: adaptive-mesh-refinement data");
        supportsOption("KEY=VALUE", "the scene's options, named as on the command line of brickwall: field, tf, "
                                    "colormap, range, iso, tolerance, shading, ...; and fps");
    }

    const char* className() const override { return "Brickwall volume reader"; }

    bool acceptsExtension(const std::string& extension) const override
    {
        // `cloud.raw:64x64x64:uint8` has the extension of its name's file.
        return osgDB::ReaderWriter::acceptsExtension(extension.substr(0, extension.find(':')));
    }

    ReadResult readNode(const std::string& file, const osgDB::Options* options) const override
    {
        if (!acceptsExtension(osgDB::getLowerCaseFileExtension(file)))
            return ReadResult::FILE_NOT_HANDLED;
        const std::string data = findData(withoutPseudoExtension(file, options), options);
        if (data.empty())
            return ReadResult::FILE_NOT_FOUND;
        try {
            if (!openIfKnown(data))
                return ReadResult::FILE_NOT_HANDLED;
            HostProgress progress;
            osg::ref_ptr<VolumeNode> node = new VolumeNode;
            node->setName(osgDB::getSimpleFileName(data));
            const NodeOptions wanted = optionsFor(data, options);
            node->load(wanted.scene, progress);
            node->setFps(wanted.fps);
            return node.get();
        } catch (const std::exception& error) {
            return ReadResult(std::string(error.what()));
        }
    }

    ReadResult readObject(const std::string& file, const osgDB::Options* options) const override
    {
        return readNode(file, options);
    }
};

REGISTER_OSGPLUGIN(brickwall, ReaderWriterBrickwall)

} // namespace brickwall
