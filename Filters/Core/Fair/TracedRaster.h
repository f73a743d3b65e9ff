// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TracedRaster.h
 * @brief The raster of an image along which contours were traced, and how unsteady they are on it.
 */
#ifndef recon_TracedRaster_h
#define recon_TracedRaster_h

#include "Contours/ContourSet.h"

namespace recon
{
struct TracedRaster
{
  double Pitch = 0; ///< distance of its lines, in the units of the input; 0: there is none
  /// How far vertices are off smooth curves through those beside them, in three of four cases at
  /// most; what an isoline of a nearly binary image is off the shape in it.
  double Unsteadiness = 0;
};

/**
 * Isolines of an image have their vertices where they cross the lines between its pixels: most often an
 * edge goes from one line to the next, so that one length comes up again and again in both
 * directions of the frame, and none goes farther. Where it is not so there is no raster.
 */
TracedRaster FindTracedRaster(const ContourSet& contours);
}

#endif
