# SPDX-License-Identifier: GPL-3.0-or-later
# Contours of a file in (.cnt, .csl, .contour, or a DICOM RT structure set), a closed surface out (.stl).
import sys

import contour_reconstruction as cr

contours = cr.read(sys.argv[1])
if isinstance(contours, cr.Regions):  # several regions of interest: take the one that is named
    contours = contours[sys.argv[3]]
surface = cr.polyhedral_surface(contours, EndCaps="Flat")
print("\n".join(surface.report + cr.certificate(surface, contours).text))
cr.write_stl(sys.argv[2], surface)
