# SPDX-License-Identifier: GPL-3.0-or-later
"""From a few contours to as many as wanted: an implicit function is fitted, and cut in other planes."""
import pathlib

from paraview.simple import *

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"

# Eleven contours of a femur's head, in planes of several directions.
drawn = CurveNetworkReader(FileName=str(DATA / "femur_head.csl"))
function = ImplicitFunction(Input=ImplicitConstraints(Input=drawn))
contours = ImplicitContours(Input=function, Spacing=2.0)
contours.UpdatePipeline()
count = contours.GetDataInformation().GetNumberOfCells()
print(f"{drawn.GetDataInformation().GetNumberOfCells()} contours became {count}")
SaveData("femur_head.cnt", contours)
