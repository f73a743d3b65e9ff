// SPDX-License-Identifier: GPL-3.0-or-later
// The surface from the tetrahedra at its boundary is that from all, and they are few.
#include "BoundaryOracle.h"
#include "DegenerateStacks.h"

#include "Polyhedral/BoundaryVoronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// What lies between two outlines that are not one above the other is not enumerated either.
TEST(BoundaryVoronoi, TakesTetrahedraInProportionToTheSampling)
{
  std::size_t before = 0;
  for (const int points : { 2000, 4000, 8000 })
  {
    const auto levels = TriangulateLevels(BlobStack(points, 2), true);
    const JointCells cells(levels[0], levels[1]);
    const std::size_t count = BuildBoundaryVoronoi(cells, {}).Tetrahedra.size();
    EXPECT_TRUE(before == 0 || 10 * count < 22 * before) << count << " after " << before;
    before = count;
  }
}

// Where a hole of the one lies between the outlines of both, what is beyond it comes loose (thesis 6.4).
TEST(BoundaryVoronoi, GivesTheSameSurfaceWithHolesBetweenOutlines)
{
  const auto hole = [](double angle, double radius)
  {
    Ring ring = RegularPolygon(40, radius, 0.1, { 1.55 * std::cos(angle), 1.55 * std::sin(angle) });
    std::reverse(ring.begin(), ring.end());
    return ring;
  };
  for (const int points : { 300, 900 })
  {
    const Ring outer = RegularPolygon(points, 2, 0.003);
    const Ring inner = RegularPolygon(points, 1, 0, { 0.05, 0.02 });
    ExpectSameFromBoundary(
      BuildStack({ { outer, hole(0.3, 0.1), hole(2, 0.3) }, { inner }, { outer } }));
    ExpectSameFromBoundary(
      BuildStack({ { inner }, { outer, hole(0, 0.2), hole(0.4, 0.05) }, { inner, hole(1, 0.2) } }));
    // A notch, and a second region beyond it.
    Ring notched = outer;
    for (std::size_t i = 0; i < notched.size() / 40; ++i)
    {
      notched[i] = { 0.6 * notched[i][0], 0.6 * notched[i][1] };
    }
    ExpectSameFromBoundary(BuildStack(
      { { notched, RegularPolygon(points / 4, 0.4, 0, { 3, 0 }) }, { inner }, { notched } }));
  }
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
