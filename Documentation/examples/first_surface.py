# SPDX-License-Identifier: GPL-3.0-or-later
"""Contours to a closed surface, and what it is worth: the shortest way."""
import pathlib

from paraview.simple import *

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"

contours = NUAGESContourReader(FileName=str(DATA / "brain.cnt"))
surface = PolyhedralSurface(Input=contours)
certificate = SurfaceCertificate(Input=surface, Contours=contours)
certificate.UpdatePipeline()

figures = certificate.FieldData  # an array a figure, see "?" of Surface Certificate
closed = bool(figures["Closed"].GetRange()[0])
volume = figures["Volume"].GetRange()[0]
print(f"closed: {closed}, volume: {volume:.6g}")
SaveData("brain.vtp", certificate, DataMode="Binary")
