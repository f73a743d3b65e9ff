// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Specks.h
 * @brief Computed contours that are too small to be meant.
 */
#ifndef recon_Specks_h
#define recon_Specks_h

#include "Contours/ContourSet.h"

#include <string>

namespace recon
{
/**
 * Takes away the closed chains that enclose less than that, in square units.
 *
 * @return a line for Report; empty where there are none.
 */
std::string LeaveOutSpecks(double smallest, LoopSoup& soup);

/**
 * The area below which a computed contour is a speck: it is smaller than a pixel of the images that
 * it is to lie on, and than half of any contour that somebody drew. 0, so that none is, where the
 * pixel's area is unknown (0).
 */
double SpeckArea(double pixel, double smallestDrawn);

/// The smallest area of any contour of a set; 0 of none.
double SmallestArea(const ContourSet& contours);
}

#endif
