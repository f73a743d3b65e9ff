# SPDX-License-Identifier: GPL-3.0-or-later
"""Both methods on one set of contours: exact and flat-faced, or smooth."""
import pathlib

from paraview.simple import *

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"

contours = NUAGESContourReader(FileName=str(DATA / "branching_pipe.cnt"))
volumes = {}
for name, node in (("polyhedral", PolyhedralSurface(Input=contours)), ("implicit", ImplicitSurface(Input=contours))):
    certificate = SurfaceCertificate(Input=node, Contours=contours)
    certificate.UpdatePipeline()
    volumes[name] = certificate.FieldData["Volume"].GetRange()[0]
    off = certificate.FieldData["FarthestContourVertex"].GetRange()[0]
    print(f"{name}: volume {volumes[name]:.5g}, at most {off:.3g} from the contours' points")
    SaveData(f"pipe_{name}.vtp", certificate, DataMode="Binary")
