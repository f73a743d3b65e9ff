// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file NUAGESFormatter.h
 * @brief Writes loops on planes perpendicular to z as NUAGES slices (.cnt), without VTK.
 */
#ifndef recon_NUAGESFormatter_h
#define recon_NUAGESFormatter_h

#include "Base/Monitor.h"
#include "Common/ContourFile.h"

#include <string>
#include <vector>

namespace recon
{
/**
 * Sections by increasing z, contours within a section in the order given.
 *
 * Numbers are written with the fewest digits that give the same double again. Loops within
 * 1e-6 of the bounding box's diagonal of one height are one section, at the height of the first.
 *
 * @param loops closed chains; a repeated closing point is not written, whether by index or by
 * coordinates
 * @return sentences for loops whose z had to be moved to their section's
 * @throws Error where a chain is open, a loop is not perpendicular to z, a coordinate is no finite
 * number, or the file cannot be written (no partial file is left behind).
 */
std::vector<std::string> WriteNUAGES(
  const std::string& fileName, const LoopSoup& loops, Monitor& monitor);

/**
 * The format's convention, seen from +z: outer contours clockwise, holes counterclockwise.
 *
 * @param depths of every cell of the input (Chain::Source) in the tree of nesting; empty leaves all
 * loops as they are
 */
void OrientByDepth(const std::vector<int>& depths, LoopSoup& loops);
}

#endif
