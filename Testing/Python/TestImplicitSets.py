# SPDX-License-Identifier: GPL-3.0-or-later
"""Implicit Surface on real sets of contours on planes of any orientation: sound, and through its contours.

    TestImplicitSets.py [NAME ...]

The armadillo (three directions), the vertebrae (near-parallel and orthogonal planes), the skull (nested) and the heart
(planes of any orientation). Each surface must be closed, manifold, oriented and free of self-intersections, and every drawn
contour must lie within a cell of it; the armadillo is measured against the surface it was cut from.

Settings: contours resampled to about 2 500 points, as the direct solver's work grows with the third power of their number,
and cells of the same size as the resampled edges.
"""
import sys

import contourtesting as ct

simple = ct.load_plugin()

# File: spacing of points on contours, and of cells, as a part of the diagonal of the bounding box.
SETS = {
    "armadillo": ("csl/armadillo_simplified_from_mesh.csl", 0.008),
    "Vetebrae": ("csl/Vetebrae.csl", 0.008),
    "Skull": ("csl/Skull-20.csl", 0.008),
    "Heart": ("csl/Heart-25-even-better.csl", 0.008),
}
