# SPDX-License-Identifier: GPL-3.0-or-later
"""Traces of any program as a table of points: slice, object, x, y. IMOD, Reconstruct and ImageJ files have readers of their own."""
import math

from paraview.simple import *

# A dendrite that forks, traced on 12 sections of 50 nm; x and y in micrometres.
rows = ["object,slice,contour,x (um),y (um)"]
for section in range(12):
    apart = max(0.0, 0.08 * (section - 5))
    for branch in (-1, 1) if apart > 0.2 else (0,):
        for step in range(24):
            angle = 2 * math.pi * step / 24
            x = branch * apart + (0.28 + (0.4 * apart if branch == 0 else 0)) * math.cos(angle)
            rows.append(f"dendrite,{section},{branch},{x:.4f},{0.28 * math.sin(angle):.4f}")
with open("dendrite.csv", "w", encoding="ascii") as file:
    file.write("\n".join(rows) + "\n")

traces = ContourTableReader(FileName="dendrite.csv", SliceSpacing=0.05)
surface = PolyhedralSurface(Input=traces)
certificate = SurfaceCertificate(Input=surface, Contours=traces)
certificate.UpdatePipeline()
block = certificate.GetClientSideObject().GetOutputDataObject(0).GetPartition(0, 0)
volume = block.GetFieldData().GetArray("Volume").GetValue(0)
print(f"the dendrite has {volume:.4g} um3 and {block.GetNumberOfCells()} triangles")
SaveData("dendrite.vtpc", surface)
