// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"

#include <memory>
#include <string>

namespace brickwall {

// The readers' doors, one per format, as OpenFunction in DataSet.h says: null for "not mine", Error for "mine, and
// broken".

std::unique_ptr<DataSet> openPlotfile(const std::string& data); ///< AMReX and BoxLib, a folder or its Header
std::unique_ptr<DataSet> openCache(const std::string& data);    ///< .brickwall, which `convert` writes
std::unique_ptr<DataSet> openExa(const std::string& data);      ///< ExaBrick's .exa, which names the other files
std::unique_ptr<DataSet> openBricks(const std::string& data);   ///< .bricks with the .scalars beside it
std::unique_ptr<DataSet> openCells(const std::string& data);    ///< .cells with the .scalars beside it
std::unique_ptr<DataSet> openFlash(const std::string& data);    ///< FLASH 3 and 4, Flash-X: plot files, checkpoints
std::unique_ptr<DataSet> openChombo(const std::string& data);   ///< Chombo's HDF5: plot files, checkpoints
std::unique_ptr<DataSet> openVtkHdf(const std::string& data);   ///< .vtkhdf of overlapping AMR, FILE[:step=N]
std::unique_ptr<DataSet> openVtkAmr(const std::string& data);   ///< overlapping AMR, .vthb or .vth, with .vti pieces
std::unique_ptr<DataSet> openVdb(const std::string& data);      ///< OpenVDB, FILE[:background]
std::unique_ptr<DataSet> openNrrd(const std::string& data);     ///< FILE[:threshold=T]
std::unique_ptr<DataSet> openRaw(const std::string& data);      ///< NAME_WxHxD_TYPE.raw or FILE:WxHxD:TYPE[:...]
/// .scalars and .tris say nothing alone: always null or an Error that names the file to open instead.
std::unique_ptr<DataSet> openExaPart(const std::string& data);

} // namespace brickwall
