// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourPreview.h
 * @brief So few points of a contour set that it is fitted while the user waits.
 */
#ifndef recon_ContourPreview_h
#define recon_ContourPreview_h

#include "Contours/ContourSet.h"

namespace recon
{
/**
 * The contours that show in cells of `cellSize`, thinned out to about `mostPoints` points.
 *
 * Left out are levels nearer than a cell to the one before of about the same direction (the first
 * and the last stay), and contours of an area below a quarter of a cell's face, unless fewer than
 * two levels were left; where too many points remain, the same for cells up to five times as large.
 * Points never move; contours keep those that their shape needs, so a set of very many contours may
 * keep more than `mostPoints`.
 */
ContourSet PreviewOf(const ContourSet& contours, double cellSize, std::size_t mostPoints);
}

#endif
