# SPDX-License-Identifier: GPL-3.0-or-later
"""What TestWheel.py compares, as the package makes it: runs in an environment with the wheel and numpy, nothing else.

    wheelcases.py RESULT.npz SOURCE SHARED [pyvista]

Writes every array of every case under the name "case/kind/array". With `pyvista` contours and surfaces go through
PyVista's accessor, which nothing here imports.
"""
import os
import sys

import numpy as np

RESULT, SOURCE, SHARED = sys.argv[1:4]
WITH_PYVISTA = "pyvista" in sys.argv[4:]
arrays = {}


def keep(case, kind, values):
    for name, value in values.items():
        arrays[f"{case}/{kind}/{name}"] = np.atleast_1d(np.asarray(value))


def keep_surface(case, surface):
    keep(case, "mesh", {"points": surface.points, "triangles": surface.triangles})
    keep(case, "points", surface.point_data)
    keep(case, "cells", surface.cell_data)
    keep(case, "field", surface.field_data)
    keep(case, "field", {"Report": surface.report})


def keep_contours(case, contours):
    keep(case, "mesh", {"points": contours.points, "connectivity": contours.connectivity, "offsets": contours.offsets})
    keep(case, "cells", contours.cell_data)
    keep(case, "field", contours.field_data)


def own(name):
    return os.path.join(SOURCE, "Data", name)


def shared(name):
    path = os.path.join(SHARED, name)
    return path if os.path.exists(path) else None


def through_the_package():
    import contour_reconstruction as cr
    assert "vtk" not in sys.modules and "vtkmodules" not in sys.modules, "the package has imported VTK"
    for name in ("brain.cnt", "branching_pipe.cnt", "tamarind.csl"):
        contours = cr.read(own(name))
        keep_contours(f"{name} as read", contours)
        keep_contours(f"{name} hierarchy", cr.contour_hierarchy(contours))
    contours = cr.read(own("brain.cnt"))
    keep_surface("brain.cnt polyhedral", cr.polyhedral_surface(contours))
    keep_surface("brain.cnt flat", cr.polyhedral_surface(contours, EndCaps="Flat", Mapping="Proximity", PinchGap=0))
    pipe = cr.read(own("branching_pipe.cnt"))
    keep_surface("branching_pipe.cnt told", cr.polyhedral_surface(pipe, ExpectedPieces=1, ExpectedHandles=0))
    mapping = cr.contour_mapping(pipe, OverlapThreshold=0.3)
    keep_contours("branching_pipe.cnt mapping", mapping.contours)
    keep("branching_pipe.cnt joins", "rows", mapping.joins)
    keep_surface("branching_pipe.cnt mapped", cr.polyhedral_surface(mapping.contours))
    keep_surface("branching_pipe.cnt fair", cr.fair_surface(pipe, EndCaps="Flat"))
    keep_surface("branching_pipe.cnt implicit", cr.implicit_surface(pipe))
    keep_surface("tamarind.csl implicit", cr.implicit_surface(cr.read(own("tamarind.csl")), Detail="Medium"))
    keep_contours("branching_pipe.cnt traced", cr.contours_on_planes(pipe, Spacing=0.7))
    surface = cr.polyhedral_surface(pipe)
    judged = cr.certificate(surface, pipe)
    keep("branching_pipe.cnt certificate", "field", {"CertificateJSON": judged.json})
    keep("branching_pipe.cnt certificate", "cells", {"Defect": judged.defect, "ComponentId": judged.component_id})
    rtss = shared("rtstruct/dicompyler_rtss.dcm")
    if rtss:
        for name, region in cr.read(rtss, progress=lambda fraction, stage: None).items():
            keep_contours(f"rtss {name} as read", region)
        lung = cr.read_structure_set(rtss, ["Lt Lung"])["Lt Lung"]
        keep_surface("rtss lung", cr.polyhedral_surface(lung))


def through_pyvista():
    import pyvista as pv
    assert "contour_reconstruction" not in sys.modules
    sphere = pv.Sphere(theta_resolution=40, phi_resolution=40)
    slices = sphere.slice_along_axis(12, "z").combine().extract_surface(algorithm=None)
    surface = slices.contours.polyhedral_surface(EndCaps="Flat")
    assert surface.n_open_edges == 0, "the surface of the slices is open"
    assert surface.contours.certificate(slices).sound
    assert abs(surface.volume / sphere.volume - 1) < 0.1, (surface.volume, sphere.volume)
    blocks = pv.MultiBlock({"a": slices, "b": slices.translate((2, 0, 0))}).contours.polyhedral_surface()
    assert list(blocks.keys()) == ["a", "b"]
    try:
        sphere.contours.polyhedral_surface()
        raise AssertionError("a surface was taken for contours")
    except ValueError as error:
        assert "is a surface, not contours" in str(error), error
    import contour_reconstruction as cr
    mesh = cr.read(own("brain.cnt")).to_pyvista()
    made = mesh.contours.polyhedral_surface()
    keep("brain.cnt polyhedral", "mesh", {"points": made.points, "triangles": made.regular_faces})
    keep("brain.cnt polyhedral", "cells", {name: made.cell_data[name] for name in made.cell_data})


if WITH_PYVISTA:
    through_pyvista()
else:
    through_the_package()
np.savez(RESULT, **arrays)
print(len(arrays), "arrays")
