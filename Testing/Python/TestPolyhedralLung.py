# SPDX-License-Identifier: GPL-3.0-or-later
"""The mediastinal side of a left lung, close up: where other tools draw spikes and vertical sheets.

165 contours on 80 slices, 77 nested holes, 14 one-to-many and 31 many-to-many branchings. The picture is
the test of what no number shows; the numbers are asked as well.
"""
import contourtesting as ct

simple = ct.load_plugin()

reader = simple.DICOMRTStructureSetReader(FileName=ct.shared("rtstruct/dicompyler_rtss.dcm"))
reader.ROIs = ["Lt Lung"]
lung = simple.MergeBlocks(Input=reader, OutputDataSetType="Polygonal Mesh")
surface = simple.PolyhedralSurface(Input=lung)
certificate = simple.SurfaceCertificate(Input=surface)

mesh = ct.data(surface)
report = mesh.GetFieldData().GetAbstractArray("Report")
ct.check(mesh.GetNumberOfPolys() > 40000, f"{mesh.GetNumberOfPolys()} triangles are too few for the lung")
lines = [report.GetValue(i) for i in range(report.GetNumberOfValues())] if report else []
ct.check(all("drawn apart" in line for line in lines), f"no contour of the lung is repaired or left out: {lines}")
figures = ct.data(certificate).GetFieldData()
for name, wanted in (("Sound", 1), ("CrossingPairs", 0), ("OverlappingPairs", 0)):
    array = figures.GetAbstractArray(name)
    ct.check(array is not None and array.GetTuple1(0) == wanted, f"{name} of the lung is {wanted}")

view = simple.CreateView("RenderView")
view.UseColorPaletteForBackground = 0
view.BackgroundColorMode = "Single Color"
view.Background = [1.0, 1.0, 1.0]
view.CameraParallelProjection = 1
view.CameraFocalPoint = [0, 0, 0]
view.CameraPosition = [-5, 0.6, 0.9]  # from the midline: the left lung lies at positive x
view.CameraViewUp = [0, 0, 1]
shown = simple.Show(surface, view)
shown.Representation = "Surface"
shown.ColorArrayName = ["POINTS", ""]
shown.AmbientColor = shown.DiffuseColor = [0.85, 0.75, 0.65]
simple.ResetCamera(view)
simple.Render(view)
view.CameraParallelScale = 0.55 * view.CameraParallelScale
simple.Render(view)
ct.compare_image(view, "PolyhedralSurfaceLung")
simple.Delete(view)
ct.finish()
