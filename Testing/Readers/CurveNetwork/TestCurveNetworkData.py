# SPDX-License-Identifier: GPL-3.0-or-later
"""Every real cross-section set and curve network opens by itself and has the contours of its table."""
import contourtesting as ct
import readertesting as rt

simple = ct.load_plugin()
# Materials, contours, points (of all materials: a common boundary counts for each).
TABLE = {"csl/eight_15.csl": (1, 21, 2028), "csl/hand_ok.csl": (1, 29, 4082), "csl/balloondog.csl": (1, 27, 4579),
         "csl/armadillo.csl": (1, 62, 11039), "csl/armadillo_simplified_from_mesh.csl": (1, 62, 5685),
         "csl/Vetebrae.csl": (1, 186, 14815), "csl/Skull-20.csl": (1, 43, 8821),
         "csl/Heart-25-even-better.csl": (1, 33, 4534), "csl/SideBishop.csl": (1, 22, 1376),
         "csl/rose.csl": (1, 15, 9000), "contour/ctrmapping.contour": (1, 9, 1789),
         "contour/eight_15.contour": (1, 21, 2028), "contour/inconsistent_Bermano.contour": (1, 5, 349),
         "contour/inconsistent_ferretbrain.contour": (1, 10, 1346),
         "contour/inconsistent_mousebrain.contour": (6, 32, 3581),
         "contour/inconsistent_newliver.contour": (3, 13, 969), "contour/liver.contour": (5, 23, 1592),
         "contour/mousebrain.contour": (6, 25, 2887), "contour/mug.contour": (1, 9, 1083),
         "contour/ringc.contour": (2, 8, 290)}
for name, expected in TABLE.items():
    reader = simple.OpenDataFile(ct.shared(name))
    ct.check(reader.GetXMLName() == "CurveNetworkReader", f"{name}: opened by {reader.GetXMLName()}")
    output = ct.data(reader)
    parts = [output] if output.IsA("vtkPolyData") else [block for _, block in rt.blocks(output)]
    found = (len(parts), sum(p.GetNumberOfLines() for p in parts), sum(p.GetNumberOfPoints() for p in parts))
    ct.check(found == expected, f"{name}: {found} instead of {expected}")
    ct.check(all(rt.loops_are_closed(p) for p in parts), f"{name}: loops are not closed")
ct.finish()
