// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file OpenLines.h
 * @brief Isolines that leave their window, closed along its border.
 */
#ifndef recon_OpenLines_h
#define recon_OpenLines_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"

#include <string>
#include <vector>

namespace recon
{
struct LinesAlongBorder
{
  LoopSoup Soup;                   ///< chained; the points of the input, then those of the border
  std::vector<std::string> Report; ///< what was closed, and what chaining repaired or left out
};

/**
 * Closes open lines along the border of the rectangle that is around all contours of parallel
 * planes.
 *
 * The ends of a plane's lines cut the border into pieces, which are in turn inside and outside.
 * Which of the two ways it is, is decided by the neighbouring plane: the regions should differ by as
 * little area as possible. Planes of which all contours are closed need no decision and come first;
 * where there is none, the smallest region of all does. Lines with an end farther from the border
 * than their points are from one another stay open.
 *
 * @param endTolerance as for ChainRings
 */
LinesAlongBorder CloseAlongBorder(const LoopSoup& soup, double endTolerance, Monitor& monitor);
}

#endif
