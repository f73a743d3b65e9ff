// SPDX-License-Identifier: GPL-3.0-or-later
// Crossings put in order by comparing them are in the order of the walks that find all.
#include "BoundaryOracle.h"

#include "Polyhedral/CrossingOrder.h"
#include "Polyhedral/JointVoronoi.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
std::vector<JointCrossing> CrossingsOf(const SlabTetrahedra& slab)
{
  std::vector<JointCrossing> crossings;
  for (const auto& t : slab.Tetrahedra)
  {
    if (t.Node == SlabTetrahedra::T12)
    {
      crossings.push_back({ t.Origin, t.Corners });
    }
  }
  return crossings;
}

void ExpectOrderOfWalks(const LevelTriangulation& lower, const LevelTriangulation& upper)
{
  const JointCells cells(lower, upper);
  const SlabTetrahedra slab = BuildJointVoronoi(lower, upper);
  const std::vector<JointCrossing> expected = CrossingsOf(slab);
  std::vector<JointCrossing> shuffled = expected;
  shuffled.insert(shuffled.end(), expected.begin(), expected.end());
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(7));
  const CrossingOrder order(cells, shuffled);

  ASSERT_EQ(order.Crossings().size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ASSERT_EQ(order.Crossings()[i].Edges, expected[i].Edges);
    ASSERT_EQ(order.Crossings()[i].Corners, expected[i].Corners);
  }
  const int firstT12 = slab.NumberOfT1 + slab.NumberOfT2;
  for (int edge = 0; edge < 3 * slab.NumberOfT2; ++edge)
  {
    for (const int* i = order.Begin(1, edge); i != order.End(1, edge); ++i)
    {
      const int before = order.Before(1, edge, expected[*i]);
      EXPECT_EQ(before, i == order.Begin(1, edge) ? -1 : *(i - 1));
      const auto& neighbours = slab.Tetrahedra[firstT12 + *i].Neighbours;
      const int expectedBefore = before < 0 ? slab.NumberOfT1 + edge / 3 : firstT12 + before;
      EXPECT_TRUE(neighbours[0] == expectedBefore || neighbours[1] == expectedBefore);
    }
  }
}
}

TEST(CrossingOrder, IsThatOfTheWalks)
{
  const auto blobs = TriangulateLevels(BlobStack(200, 2), true);
  ExpectOrderOfWalks(blobs[0], blobs[1]);
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto levels = TriangulateLevels(BuildStack(RandomStack(seed)), true);
    for (std::size_t l = 0; l + 1 < levels.size(); ++l)
    {
      ExpectOrderOfWalks(levels[l], levels[l + 1]);
    }
  }
}

TEST(CrossingOrder, HoldsWhereEverythingIsATie)
{
  const Ring disc = PixelDisc(5, 1);
  const auto levels =
    TriangulateLevels(BuildStack({ { disc }, { disc }, { PixelDisc(3, 1, { 1, 1 }) } }), true);
  ExpectOrderOfWalks(levels[0], levels[1]);
  ExpectOrderOfWalks(levels[1], levels[2]);
}
