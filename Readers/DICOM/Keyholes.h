// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Keyholes.h
 * @brief Contours with holes as single closed walks, for systems that know no holes (DICOM PS3.3
 * C.8.8.6.3, "inner and outer contours joined by a channel").
 *
 * Notation: a region is the outer contour of even depth with the holes in it, each with the region
 * on its left. A bridge is an edge of the region's constrained Delaunay triangulation between two
 * of its contours; as many as it takes to connect them (a shortest spanning tree) are walked in
 * both directions. Such edges cross neither contours nor one another, so the walk never crosses
 * itself. The bridges need a triangulation of their own, as the labelled faces of EdgeSweep.h tell nothing
 * of distances: Delaunay edges hold the shortest ways between contours. BorderWalks.h walks.
 */
#ifndef recon_Keyholes_h
#define recon_Keyholes_h

#include "Contours/ContourSet.h"

#include <vector>

namespace recon
{
struct KeyholeContour
{
  std::vector<Point3> Points; ///< first not repeated; the ends of a bridge come twice
  int Source = -1;            ///< the chain's of the outer contour
};

/// Every region of the set as one walk, or several where its holes touch the rest in more than one
/// point. Points are those of the set, to the last bit.
std::vector<KeyholeContour> JoinHoles(const ContourSet& set);
}

#endif
