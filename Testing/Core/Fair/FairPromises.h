// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FairPromises.h
 * @brief What every fair surface keeps.
 */
#ifndef recon_Testing_FairPromises_h
#define recon_Testing_FairPromises_h

#include "Contours/ContourSet.h"
#include "Core/Mesh/MeshInvariants.h"
#include "Fair/FairSurface.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/TriangleTree.h"
#include "NodeDefaults.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace recon::testing
{
/// The farthest of the contour vertices that the polyhedral surface has, by a search of its own.
inline double FarthestDrawn(
  const ContourSet& contours, const TriangleMesh& polyhedral, const TriangleMesh& fair)
{
  std::vector<Point3> known = polyhedral.Points;
  std::sort(known.begin(), known.end());
  const TriangleTree tree(fair);
  double farthest = 0;
  for (const Contour& contour : contours.Contours)
  {
    for (const int p : contour.Points)
    {
      const Point3& place = contours.Points[p];
      if (std::binary_search(known.begin(), known.end(), place))
      {
        farthest = std::max(farthest, tree.DistanceTo(place, std::numeric_limits<double>::max()));
      }
    }
  }
  return farthest;
}

/// Sound, of the Euler number of the polyhedral surface, and every drawn vertex within the tolerance.
inline void ExpectPromises(const ContourSet& contours, const FairOptions& options)
{
  Monitor monitor;
  const FairSurface fair = BuildFairSurface(contours, options, monitor);
  ExpectSoundSurface(fair.Mesh);
  const PolyhedralSurface polyhedral =
    BuildPolyhedralSurface(contours, options.Polyhedral, monitor);
  EXPECT_EQ(CheckTopology(fair.Mesh).Total.Euler, CheckTopology(polyhedral.Mesh).Total.Euler);
  EXPECT_LE(FarthestDrawn(contours, polyhedral.Mesh, fair.Mesh), fair.Tolerance);
  EXPECT_EQ(fair.Beyond, 0u);
  EXPECT_LE(fair.Farthest, fair.Tolerance);
}
}

#endif
