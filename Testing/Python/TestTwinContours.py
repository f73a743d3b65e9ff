# SPDX-License-Identifier: GPL-3.0-or-later
"""Outlines that are there twice, by decimals or traced again, are one contour of the surface, with a line in Report."""
import sys

import contourtesting as ct

simple = ct.load_plugin()
sys.path.insert(0, ct.SOURCE + "/Plugin/commandline")
import contourcli as cli


def surface(path):
    """(certificate's figures, Report) of the one region of a file, ends flat."""
    blocks, _ = cli.read_contours(ct.shared(path))
    solids = [block for block in blocks if not block.empty]
    ct.check(len(solids) == 1, f"{path} has one region")
    node = simple.PolyhedralSurface(Input=cli.as_source(solids[0].data))
    node.EndCaps = "Flat"
    lines = ct.data(node).GetFieldData().GetAbstractArray("Report")
    figures = ct.data(simple.SurfaceCertificate(Input=node)).GetFieldData()
    named = {name: figures.GetAbstractArray(name).GetTuple1(0) for name in ("Volume", "Sound", "CrossingPairs")}
    return named, [lines.GetValue(i) for i in range(lines.GetNumberOfValues())]


def check_surface(path, volume, tolerance, twins, how):
    figures, report = surface(path)
    ct.check(abs(figures["Volume"] - volume) <= tolerance, f"{path}: volume {figures['Volume']} instead of {volume}")
    ct.check(figures["Sound"] == 1 and figures["CrossingPairs"] == 0, f"{path}: {figures}")
    named = [line for line in report if "is the same as that of cell" in line and how in line and "left out" in line]
    counted = twins == 1 or named[0].startswith(f"{twins} contours, the first of cell")
    ct.check(len(named) == 1 and len(report) == 1 and counted, f"{path}: {report}")


# Prisms over a polygon of 12 corners of radius 10, 300 in area; and over one of 48 corners of radius 2.
check_surface("faults/rt/twin_12_points.dcm", 1800, 0.01, 1, "within rounding")
check_surface("faults/rt/twin_11_slices.dcm", 9000, 0.05, 1, "within rounding")
check_surface("faults/other/retraced.vtp", 62.653, 0.01, 6, "traced again")
ct.finish()
