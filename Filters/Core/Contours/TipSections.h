// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TipSections.h
 * @brief End sections of one point or one line: the apex of a cone, the ridge of a roof.
 *
 * A section without area is no contour, but where it is the end of a stack it says where the shape
 * ends, and leaving it out loses the last slab. So it is drawn as a narrow triangle that has the
 * point (or the ends of the line) for corners: these are then vertices of the surface, exactly, and
 * what the triangle adds is of the order of its width.
 */
#ifndef recon_TipSections_h
#define recon_TipSections_h

#include "Contours/ContourSet.h"

#include <string>
#include <vector>

namespace recon
{
struct TipSections
{
  LoopSoup Soup;                   ///< with triangles instead of tips
  std::vector<std::string> Report; ///< a sentence a tip
};

/**
 * Replace tips in a stack of parallel rings.
 *
 * A tip is all that lies on one plane beyond the first or the last ring: points that are one, or in
 * line, at most MostSpacings beyond that ring where there are two or more levels, and within the
 * rings of that level when seen along the normal. Whatever else there is stays as it is.
 *
 * @param size diagonal of the box around all points; what is nearer than a millionth of it is one
 */
TipSections DrawTips(const LoopSoup& soup, double size);
}

#endif
