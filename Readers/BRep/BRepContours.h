// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BRepContours.h
 * @brief The closed loops among lines that lie in a surface, for a boundary representation.
 *
 * Its tests are those of the writer (TestBRepPipeline.py), whose contours come from here.
 */
#ifndef recon_BRepContours_h
#define recon_BRepContours_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Mesh/BRep.h"

#include <vector>

namespace recon
{
/// Closed loops as they are, then what loose pieces chain to. Vertices alone are no contours, and
/// what stays open is left out.
std::vector<SpaceLoop> ClosedSpaceLoops(LoopSoup soup, Monitor& monitor);
}

#endif
