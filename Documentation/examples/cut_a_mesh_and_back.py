# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh, cut into contours, and made again from them: how much is lost."""
from paraview.simple import *

mesh = Superquadric(ThetaResolution=48, PhiResolution=48, Toroidal=1, Thickness=0.4)
whole = SurfaceCertificate(Input=Clean(Input=Triangulate(Input=mesh)))
slices = Slice(Input=mesh)
slices.SliceType.Normal = [0.0, 0.0, 1.0]
slices.SliceOffsetValues = [-0.45 + 0.05 * i for i in range(19)]
again = SurfaceCertificate(Input=PolyhedralSurface(Input=slices), Contours=slices)
volumes = []
for node in (whole, again):
    node.UpdatePipeline()
    volumes.append(node.FieldData["Volume"].GetRange()[0])
print(f"volume of the mesh {volumes[0]:.5f}, of the surface from its contours {volumes[1]:.5f}")
SaveData("again.ply", again)
