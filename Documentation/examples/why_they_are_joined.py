# SPDX-License-Identifier: GPL-3.0-or-later
"""Which contour is joined to which, and why, as a table; and a join that is forbidden."""
import pathlib

from paraview.simple import *

DATA = pathlib.Path(__file__).resolve().parents[2] / "Data"

contours = NUAGESContourReader(FileName=str(DATA / "branching_pipe.cnt"))
mapping = ContourMapping(Input=contours)
mapping.UpdatePipeline()
table = mapping.GetClientSideObject().GetOutputDataObject(1)
words, joined = table.GetColumnByName("Words"), table.GetColumnByName("Joined")
joins = [row for row in range(table.GetNumberOfRows()) if joined.GetValue(row)]
for row in joins[:3]:
    print(words.GetValue(row))
first = joins[0]
pair = [table.GetColumnByName(name).GetValue(first) for name in ("LowerContour", "UpperContour")]
components = []
for forbidden in ([], pair):
    surface = PolyhedralSurface(Input=contours, ForbiddenJoins=forbidden)
    certificate = SurfaceCertificate(Input=surface)
    certificate.UpdatePipeline()
    components.append(int(certificate.FieldData["Components"].GetRange()[0]))
print(f"without the join of contours {pair[0]} and {pair[1]} there are {components[1]} solids, and not {components[0]}")
