// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourTableFormatter.h
 * @brief Writes closed contours as a table of points (.csv) that ContourTableParser.h reads, without VTK.
 */
#ifndef recon_ContourTableFormatter_h
#define recon_ContourTableFormatter_h

#include "Base/Monitor.h"
#include "Common/TracedFile.h"

#include <string>
#include <vector>

namespace recon
{
/**
 * Columns object, slice (where all objects tell it), contour, x, y and z, separated by commas; the unit
 * stands behind the names of the coordinates. Contours are numbered from 0 in each object, and their first
 * point is not repeated.
 *
 * Numbers are written with the fewest digits that give the same double again. A contour may begin at
 * another of its points than it did, where it would be taken for one at each of several z otherwise. In
 * names, quotes become apostrophes, and what separates lines or columns becomes a space; a name that is there
 * already gets a number, as objects are known by their names. Colours are not written.
 *
 * @return sentences for what is no closed contour (left out), and for names that were changed
 * @throws Error where there is no closed contour, a coordinate is no finite number, or the file cannot be
 * written (no partial file is left behind); Aborted.
 */
std::vector<std::string> WriteContourTable(
  const std::string& fileName, const TracedFile& file, Monitor& monitor);
}

#endif
