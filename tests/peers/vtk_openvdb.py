#!/usr/bin/env python3
# Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
"""What brickwall reads against what VTK and OpenVDB read, and files that VTK writes.

    vtk_openvdb.py BRICKWALL DATA

BRICKWALL is the command, DATA the folder of real data. Compares the number of leaf cells of overlapping AMR files with
those that VTK does not blank, in the files in DATA and in one that VTK writes here, and the active voxels of OpenVDB
grids of one level. Parts without their Python module (Debian: python3-vtk9, python3-openvdb) are skipped and say so.
Exits with 1 if anything differs, with 77 (ctest: skipped) if nothing could be compared.
"""
import json
import os
import subprocess
import sys
import tempfile

failures = 0
compared = 0


def check(what, ours, theirs):
    global failures, compared
    compared += 1
    same = ours == theirs
    failures += not same
    print(f"{'same' if same else 'DIFFERENT'}: {what}: {ours} here, {theirs} there")


def cells(brickwall, data):
    """Cells per level, from fine to coarse, as `info --json` says."""
    out = subprocess.run([brickwall, "info", data, "--json"], capture_output=True, text=True, check=True).stdout
    return [level["cells"] for level in json.loads(out)["levels"] if level["cells"] > 0]


def unblanked(amr):
    from vtkmodules.util.numpy_support import vtk_to_numpy
    refined = 8  # vtkDataSetAttributes::REFINEDCELL
    counts = []
    for level in range(amr.GetNumberOfLevels()):
        count = 0
        for i in range(amr.GetNumberOfDataSets(level)):
            grid = amr.GetDataSet(level, i)
            ghosts = grid.GetCellData().GetArray("vtkGhostType") if grid else None
            count += int(((vtk_to_numpy(ghosts) & refined) == 0).sum()) if ghosts else grid.GetNumberOfCells()
        counts.append(count)
    return [n for n in reversed(counts) if n > 0]


def read_by_vtk(path):
    from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRReader
    reader = vtkXMLUniformGridAMRReader()
    reader.SetFileName(path)
    reader.SetMaximumLevelsToReadByDefault(0)
    reader.Update()
    return reader, reader.GetOutputDataObject(0)


def write_by_vtk(path, mode, compressor):
    """VTK's wavelet, as levels of which the finest has all cells."""
    from vtkmodules.vtkFiltersAMR import vtkImageToAMR
    from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
    from vtkmodules.vtkIOXML import vtkXMLUniformGridAMRWriter
    from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
    image = vtkRTAnalyticSource()
    image.SetWholeExtent(0, 32, 0, 32, 0, 32)
    values = vtkPointDataToCellData()
    values.SetInputConnection(image.GetOutputPort())
    amr = vtkImageToAMR()
    amr.SetInputConnection(values.GetOutputPort())
    amr.SetNumberOfLevels(3)
    writer = vtkXMLUniformGridAMRWriter()
    writer.SetInputConnection(amr.GetOutputPort())
    writer.SetFileName(path)
    getattr(writer, "SetDataModeTo" + mode)()
    if not compressor:
        writer.SetCompressorTypeToNone()
    writer.Write()


def with_vtk(brickwall, data):
    # VTK 9.1 itself crashes on lists of version 1.0.
    path = os.path.join(data, "vtk", "HierarchicalBoxDataset.v1.1.vthb")
    if os.path.exists(path):
        reader, amr = read_by_vtk(path)
        check(path, cells(brickwall, path), unblanked(amr))
    with tempfile.TemporaryDirectory() as folder:
        for mode in ("Ascii", "Binary", "Appended"):
            for compressor in (False, True):
                path = os.path.join(folder, f"{mode}{int(compressor)}.vth")
                write_by_vtk(path, mode, compressor)
                reader, amr = read_by_vtk(path)
                check(path, cells(brickwall, path), unblanked(amr))


def with_openvdb(brickwall, data, openvdb):
    path = os.path.join(data, "vdb", "smoke.vdb")
    if os.path.exists(path):
        check(path, cells(brickwall, path), [openvdb.read(path, "density").activeVoxelCount()])


def main():
    brickwall, data = sys.argv[1:3]
    try:
        import vtkmodules  # noqa: F401
        with_vtk(brickwall, data)
    except ImportError as error:
        print(f"skipped: no VTK in this Python ({error})")
    try:
        import pyopenvdb
        with_openvdb(brickwall, data, pyopenvdb)
    except ImportError as error:
        print(f"skipped: no OpenVDB in this Python ({error})")
    sys.exit(1 if failures else 0 if compared else 77)


main()
