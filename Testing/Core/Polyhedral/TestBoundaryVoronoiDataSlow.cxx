// SPDX-License-Identifier: GPL-3.0-or-later
// The surface from the tetrahedra at its boundary is that from all, on every set at hand.
#include "BoundaryOracle.h"
#include "PolyhedralSweep.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

TEST_P(PolyhedralSweep, BoundaryGivesTheSameSurface)
{
  ForEachSolid(this->Path, [](const ContourSet& contours) { ExpectSameFromBoundary(contours); });
}

INSTANTIATE_TEST_SUITE_P(All, PolyhedralSweep, ::testing::ValuesIn(AllCases), NameOf);
INSTANTIATE_TEST_SUITE_P(Networks, PolyhedralSweep, ::testing::ValuesIn(NetworkCases), NameOf);

TEST(BoundaryVoronoiSlow, GivesTheSameSurfaceOfManyStacks)
{
  for (unsigned seed = 41; seed <= 600; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const ContourSet contours = BuildStack(RandomStack(seed));
    if (contours.Levels.size() >= 2)
    {
      ExpectSameFromBoundary(contours);
    }
  }
}
