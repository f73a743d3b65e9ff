// SPDX-License-Identifier: GPL-3.0-or-later
// The surface from the tetrahedra at its boundary is that from all, and they are few.
#include "BoundaryOracle.h"
#include "DegenerateStacks.h"

#include "Polyhedral/BoundaryVoronoi.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

TEST(BoundaryVoronoi, GivesTheSameSurfaceOfDenseBlobs)
{
  ExpectSameFromBoundary(BlobStack(900, 3));
  ExpectSameFromBoundary(BuildStack({ { Blob(600, 0) }, { Blob(400, 1), Blob(300, 2, { 3, 0 }) },
    { Blob(500, 3, { 0.7, 0.1 }) }, { Blob(300, 4, { 5, 0 }) } }));
}

TEST(BoundaryVoronoi, GivesTheSameSurfaceWhereEverythingIsATie)
{
  const Ring disc = PixelDisc(6, 1);
  const Ring small = PixelDisc(3, 1, { 2, 1 });
  ExpectSameFromBoundary(BuildStack({ { disc }, { disc }, { small }, { disc } }));
  const Ring circle = RegularPolygon(64, 1);
  ExpectSameFromBoundary(BuildStack({ { circle }, { circle }, { RegularPolygon(64, 1.5) } }));
}

TEST(BoundaryVoronoi, GivesTheSameSurfaceOfNestedStacks)
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ContourSet contours = BuildStack(RandomStack(seed));
    if (contours.Levels.size() >= 2)
    {
      ExpectSameFromBoundary(contours);
    }
  }
}

TEST(BoundaryVoronoi, GivesTheSameSurfaceWithEveryOption)
{
  for (const PolyhedralOptions& options : EveryCombination())
  {
    SCOPED_TRACE("mapping " + std::to_string(options.Mapping) + ", ends " +
      std::to_string(options.EndCaps) + ", isolated " + std::to_string(options.IsolatedContours));
    ExpectSameFromBoundary(BuildStack(RandomStack(5)), options);
    ExpectSameFromBoundary(
      BuildStack({ { Blob(120, 0) }, { Blob(90, 1), Blob(60, 2, { 3, 0 }) }, { Blob(80, 3) } }),
      options);
  }
}

TEST(BoundaryVoronoi, TakesAFewTetrahedraOfMany)
{
  const auto levels = TriangulateLevels(BlobStack(3000, 2), true);
  const JointCells cells(levels[0], levels[1]);
  const SlabTetrahedra all = BuildJointVoronoi(levels[0], levels[1]);
  const SlabTetrahedra few = BuildBoundaryVoronoi(cells, {});
  EXPECT_TRUE(few.HasGaps);
  EXPECT_LT(10 * few.Tetrahedra.size(), all.Tetrahedra.size());
}

TEST(BoundaryVoronoi, DrawnContoursHaveAllTheirTetrahedra)
{
  Monitor monitor;
  const PolyhedralStages stages =
    BuildPolyhedralStages(BlobStack(40, 3), {}, monitor, 1, TetrahedraWanted::ForSurface);
  for (const SlabState& slab : stages.Slabs)
  {
    EXPECT_FALSE(slab.Diagram.HasGaps);
  }
}
