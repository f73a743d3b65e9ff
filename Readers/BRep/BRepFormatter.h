// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BRepFormatter.h
 * @brief Writes the boundary representation of the thesis's appendix (.brep), without VTK.
 *
 * Its tests are among TestBRepParser's: what is written is right where it is read back.
 */
#ifndef recon_BRepFormatter_h
#define recon_BRepFormatter_h

#include "Base/Monitor.h"
#include "Mesh/BRep.h"

#include <string>

namespace recon
{
/**
 * A vertex, a face's half-edges, a face's partners or a contour a line.
 *
 * A number has as many digits as it takes to give the same double again, 17 at most: reading the
 * file gives back every coordinate to the last bit and every number of the topology.
 *
 * @throws Error where there is no shell set, a shell set has no shells, a shell has a defect
 * (FindShellDefect), a coordinate is no finite number, or the file cannot be written; no partial
 * file is left behind. Aborted, before the file is touched.
 */
void WriteBRep(const std::string& fileName, const BRep& brep, Monitor& monitor);
}

#endif
