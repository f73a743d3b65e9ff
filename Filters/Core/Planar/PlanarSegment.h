// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PlanarSegment.h
 * @brief Edges of a plane by their coordinates; by numbers of points they are PlanarEdge.
 */
#ifndef recon_PlanarSegment_h
#define recon_PlanarSegment_h

#include "Base/Geometry.h"

namespace recon
{
struct PlanarSegment
{
  Point2 A;
  Point2 B;
};
}

#endif
