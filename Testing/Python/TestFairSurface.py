# SPDX-License-Identifier: GPL-3.0-or-later
"""Fair Surface: sound, of the polyhedral topology, within its tolerance, and bad input."""
import contourtesting as ct

simple = ct.load_plugin()


def figure(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    return ct.check(array is not None, f"there is field data {name}") and array.GetTuple1(0)


def report(data):
    lines = data.GetFieldData().GetAbstractArray("Report")
    return [lines.GetValue(i) for i in range(lines.GetNumberOfValues())] if lines else []


pipe = simple.NUAGESContourReader(FileName=ct.own("branching_pipe.cnt"))
node = simple.FairSurface(Input=pipe)
fair = ct.data(node)
triangles = fair.GetNumberOfPolys()
euler = {}
for name, surface in (("fair", node), ("polyhedral", simple.PolyhedralSurface(Input=pipe))):
    certificate = ct.data(simple.SurfaceCertificate(Input=surface, Contours=pipe))
    ct.check(figure(certificate, "Sound") == 1, f"the {name} surface is sound")
    euler[name] = figure(certificate, "Euler")
ct.check(euler["fair"] == euler["polyhedral"], f"one topology: {euler}")
ct.check(figure(fair, "FarthestVertex") <= figure(fair, "Tolerance"), "contour vertices are within the tolerance")
ct.check(figure(fair, "BeyondTolerance") == 0, "and none is beyond it")
ct.check(0.03 < figure(fair, "Tension") < 0.9, "the automatic tension is between that of smooth and that of sharp places")
ct.check(any("a tolerance of" in line for line in report(fair)), f"Report says what was chosen: {report(fair)}")

node.Tolerance = 3 * figure(fair, "Tolerance")
node.EdgeLength = 1.5 * figure(fair, "EdgeLength")
node.Tension = 0.5
coarser = ct.data(node)
ct.check(coarser.GetNumberOfPolys() < triangles, "longer edges are fewer triangles")
ct.check(figure(coarser, "Tension") == 0.5, "a tension that is set is taken")

empty = simple.PVTrivialProducer()
empty.GetClientSideObject().SetOutput(ct.closed_polylines([]))
ct.check(ct.data(simple.FairSurface(Input=empty)).GetNumberOfPolys() == 0, "nothing comes of nothing")
one = simple.PVTrivialProducer()
one.GetClientSideObject().SetOutput(ct.closed_polylines([[(0, 0, 0), (1, 0, 0), (0, 1, 0)]]))
said = ct.errors_of(lambda: ct.data(simple.FairSurface(Input=one)))
ct.check(bool(said), "one slice is an error")
ct.finish()
