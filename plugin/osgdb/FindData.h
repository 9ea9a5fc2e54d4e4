// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgDB/Options>

#include <string>

namespace brickwall {

/// The data that a host means by a name: itself if there is such a file or folder, or else what is found in the host's
/// paths for data (OSG_FILE_PATH, the folder of the file that names it). `sample:` names stay as they are, and so does
/// what follows a colon (core/io/DataName.h). Empty if there is nothing.
std::string findData(const std::string& name, const osgDB::Options* options);

} // namespace brickwall
