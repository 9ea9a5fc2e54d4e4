// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace brickwall::oracles {

/// The data sets in the folder of real data beside the sources, relative to it: written by the codes that the folders
/// are named after. Tests skip what is absent and what no reader answers for.
inline const std::vector<std::string> realFiles{"amrex/sphere_laminar_3lev_plt00360",
                                                "amrex/blast_small_plt00050",
                                                "exabrick/sphere_laminar.exa",
                                                "exabrick/flash_sedov.exa",
                                                "vdb/sphere_laminar_full_3lev.vdb",
                                                "vdb/sphere_small_full_3lev.vdb",
                                                "vdb/smoke.vdb",
                                                "flash/sedov_hdf5_plt_cnt_0001",
                                                "vtk/HierarchicalBoxDataset.v1.0.vthb",
                                                "vtk/HierarchicalBoxDataset.v1.1.vthb",
                                                "chombo/chk000100.3d.hdf5"};

} // namespace brickwall::oracles
