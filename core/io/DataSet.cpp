// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/DataSet.h"

#include "brickwall/core/io/DataName.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/OpenIfKnown.h"
#include "brickwall/core/io/Sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

namespace brickwall {
namespace {

void checkExists(const std::string& data)
{
    std::error_code error;
    const auto status = std::filesystem::status(data, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw Error(data, "there is no such file or folder");
    if (status.type() == std::filesystem::file_type::none)
        throw Error(data, fmt::format("cannot be opened: {}", error.message()));
    if (std::filesystem::is_directory(status)) {
        if (std::filesystem::is_empty(data, error) && !error)
            throw Error(data, "the folder is empty");
        return;
    }
    if (!std::filesystem::is_regular_file(status))
        throw Error(data, "expected a file or a folder");
    if (std::filesystem::file_size(data, error) == 0 && !error)
        throw Error(data, "the file is empty");
}

} // namespace

std::vector<std::string> filesBelow(const std::string& folder)
{
    std::vector<std::string> files;
    std::error_code error;
    std::filesystem::recursive_directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::recursive_directory_iterator(); entry.increment(error))
        if (entry->is_regular_file(error))
            files.push_back(entry->path().string());
    if (error)
        files.clear();
    std::ranges::sort(files);
    return files;
}

std::span<const Format> formats()
{
    static const std::array all{
        Format{"sample", "sample:NAME[:SIZE], made and not read", openSample},
        Format{"AMReX plotfile", "a folder with a file Header that starts like HyperCLaw-V1.1", openPlotfile},
        Format{"Brickwall cache", "a file .brickwall", openCache},
        Format{"ExaBrick", "a text file .exa", openExa},
        Format{"ExaBrick bricks", "a file .bricks, with .scalars beside it", openBricks},
        Format{"ExaBrick cells", "a file .cells, with .scalars beside it", openCells},
        Format{"FLASH", "HDF5 with node type, bounding box and unknown names", openFlash},
        Format{"Chombo", "HDF5 with Chombo_global and level_0", openChombo},
        Format{"VTKHDF overlapping AMR", "HDF5 with VTKHDF of the type OverlappingAMR", openVtkHdf, true},
        Format{"VTK overlapping AMR", "a file .vthb or .vth, with the .vti files that it names", openVtkAmr},
        Format{"OpenVDB", "a file .vdb, with grids of numbers or vectors", openVdb, true},
        Format{"NRRD", "a file that starts with NRRD000, of three dimensions", openNrrd, true},
        Format{"raw volume", "NAME_WxHxD_TYPE.raw, or FILE:WxHxD:TYPE", openRaw, true},
        Format{"ExaBrick parts", ".scalars and .tris, through the file that names them", openExaPart},
    };
    return all;
}

std::unique_ptr<DataSet> openIfKnown(const std::string& data)
{
    const DataName name = splitDataName(data);
    if (!data.starts_with("sample:"))
        checkExists(name.file);
    for (const Format& format : formats())
        if (name.options.empty() || format.takesOptions)
            if (auto set = format.open(data))
                return set;
    return nullptr;
}

std::unique_ptr<DataSet> openDataSet(const std::string& data)
{
    if (auto set = openIfKnown(data))
        return set;
    std::string known;
    for (const Format& format : formats())
        known += fmt::format("{}{} ({})", known.empty() ? "" : "; ", format.name, format.looksLike);
    if (!splitDataName(data).options.empty())
        throw Error(data,
                    "expected a file of a format that takes options after a colon (raw volume, NRRD, OpenVDB, VTKHDF)");
    throw Error(data, fmt::format("is of no format that can be read; expected one of: {}", known));
}

} // namespace brickwall
