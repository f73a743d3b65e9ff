// SPDX-License-Identifier: GPL-3.0-or-later
// The tetrahedra of every slab of real sets: filling their hull exactly, Delaunay, and CGAL's own
// wherever no five points are cospherical.
#include "PolyhedralShapes.h"
#include "PolyhedralSweep.h"
#include "SlabInvariants.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
const Case DataCases[] = {
  { "cnt/manytomany.cnt", 1 },
  { "cnt/frog_label3.cnt", 1 },
  { "csl/eight_15.csl", 1 },
  { "csl/hand_ok.csl", 1 },
  { "csl/SideBishop.csl", 1 },
  { "rtstruct/rtutils_keyholes.dcm", 4 },
};

void ExpectSoundSlabs(const ContourSet& contours)
{
  const auto levels = TriangulateLevels(contours, true);
  int tied = 0, count = 0;
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    SCOPED_TRACE("level " + std::to_string(l));
    ExpectSoundLevel(levels[l], contours, static_cast<int>(l));
    if (l + 1 < levels.size())
    {
      const SlabTetrahedra slab = BuildJointVoronoi(levels[l], levels[l + 1]);
      const SlabView view{ levels[l], levels[l + 1], slab };
      ExpectSoundSlab(view);
      tied += ExpectSameAsCGAL(view, contours.Levels[l].Offset, contours.Levels[l + 1].Offset);
      count += view.Count();
    }
  }
  std::printf("[ FIGURE   ] %d tetrahedra, %d of them with a tie\n", count, tied);
}
}

TEST_P(PolyhedralSweep, SlabsAreDelaunay)
{
  EXPECT_EQ(ForEachSolid(this->Path, ExpectSoundSlabs), GetParam().Solids);
}

INSTANTIATE_TEST_SUITE_P(Data, PolyhedralSweep, ::testing::ValuesIn(DataCases), NameOf);
