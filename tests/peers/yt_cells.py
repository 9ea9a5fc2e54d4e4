#!/usr/bin/env python3
# Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
"""Values at points as yt reads them from a file, against `brickwall sample`.

yt_cells.py BRICKWALL DATA FIELD

Points are centres of leaf cells whose neighbours are of the same level: there the reconstruction is the cell's value.
Exits with 77, which is "skipped", where yt or the data are absent.
"""
import os
import subprocess
import sys
import tempfile

try:
    import numpy
    import yt
except ImportError as missing:
    print("skipped:", missing)
    sys.exit(77)


def inner_cells(dataset, name, count=2000):
    """Centres and values of cells that have only cells of their own grid around them; always the same ones."""
    points, values = [], []
    for grid in dataset.index.grids:
        leaf = numpy.asarray(grid.child_mask, dtype=bool)
        around = numpy.zeros_like(leaf)
        around[1:-1, 1:-1, 1:-1] = True
        for axis in range(3):
            for shift in (-1, 1):
                around &= numpy.roll(leaf, shift, axis)
        chosen = leaf & around
        points.append(numpy.stack([numpy.asarray(grid["index", a].in_units("code_length"))[chosen] for a in "xyz"], 1))
        values.append(numpy.asarray(grid[name])[chosen])
    points, values = numpy.concatenate(points), numpy.concatenate(values)
    some = numpy.random.default_rng(1).permutation(len(points))[:count]
    return points[some], values[some]


def sampled(brickwall, data, field, points):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "points.csv")
        numpy.savetxt(path, points, delimiter=",", fmt="%.17g")
        lines = subprocess.run([brickwall, "sample", data, "--field", field, "--points", path], check=True,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout.splitlines()
    column = lines[0].split(",").index("value")
    return numpy.array([float(line.split(",")[column]) for line in lines[1:]])


def main():
    brickwall, data, field = sys.argv[1:]
    if not os.path.exists(data):
        print("skipped: no", data)
        sys.exit(77)
    yt.set_log_level("error")
    dataset = yt.load(data)
    points, values = inner_cells(dataset, next(name for name in dataset.field_list if name[1] == field))
    ours = sampled(brickwall, data, field, points)
    scale = numpy.abs(values).max()
    error = numpy.abs(ours - values).max() / scale
    print(f"{len(points)} points of {field}: largest difference {error:.2e} of the largest value {scale:g}")
    sys.exit(0 if len(points) > 100 and error < 1e-5 else 1)


main()
