// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "FindData.h"

#include "brickwall/core/io/DataName.h"

#include <osgDB/FileUtils>

namespace brickwall {

std::string findData(const std::string& name, const osgDB::Options* options)
{
    if (name.rfind("sample:", 0) == 0 || osgDB::fileExists(splitDataName(name).file))
        return name;
    for (std::size_t end = name.size(); end != std::string::npos && end > 0; end = name.rfind(':', end - 1)) {
        const std::string found = osgDB::findDataFile(name.substr(0, end), options);
        if (!found.empty())
            return found + name.substr(end);
    }
    return {};
}

} // namespace brickwall
