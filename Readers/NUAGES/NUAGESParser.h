// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NUAGESParser.h
 * @brief Slices of the NUAGES reconstruction system (.cnt), without VTK.
 *
 * @code
 * S 23                 number of sections; 's' in the manual page of 1993, 'S' in files
 * v 17 z 0.2           vertices of this section, summed over its contours, and its z
 * {                    a contour begins
 * 143.00 13.72         x y of one vertex a line
 * }                    the contour ends; its first vertex is not repeated
 * @endcode
 *
 * Coordinates are handed on as they stand in the file, in its units. Sections come in any order of
 * z, contours in any orientation, and those with too few vertices are handed on as well: to judge
 * them is the contour set's task.
 */
#ifndef recon_NUAGESParser_h
#define recon_NUAGESParser_h

#include "Base/Monitor.h"
#include "Common/ContourFile.h"

#include <string>

namespace recon
{
/// Whether the file begins as a NUAGES file does ("S", a count, "v").
bool IsNUAGES(const std::string& fileName);

/// @throws Error with file, line and what was expected, where the file is not whole.
/// @throws Aborted where the user asked to stop.
ContourFile ReadNUAGES(const std::string& fileName, Monitor& monitor);
}

#endif
