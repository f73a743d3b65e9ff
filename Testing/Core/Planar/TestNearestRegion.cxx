// SPDX-License-Identifier: GPL-3.0-or-later
// The nearest solid region of another level, against a look at all pairs of edges.
#include "Core/Contours/ContourInvariants.h"
#include "Core/Contours/SoupMaker.h"
#include "Planar/EdgeTree.h"
#include "Planar/NearestRegion.h"

using namespace recon;
using namespace recon::testing;

namespace
{
std::vector<ContourRegion> RegionsOf(const ContourSet& set)
{
  std::vector<ContourRegion> regions(set.Contours.size());
  for (std::size_t c = 0; c < set.Contours.size(); ++c)
  {
    regions[c].Wall = static_cast<int>(c);
    regions[c].Solid = set.Contours[c].Depth % 2 == 0;
    if (set.Contours[c].Parent >= 0)
    {
      regions[At(set.Contours[c].Parent)].Holes.push_back(static_cast<int>(c));
    }
  }
  return regions;
}

std::vector<PlanarSegment> SegmentsOf(const ContourSet& set, const ContourRegion& region)
{
  std::vector<int> contours = region.Holes;
  contours.push_back(region.Wall);
  std::vector<PlanarSegment> segments;
  for (int c : contours)
  {
    const std::vector<int>& p = set.Contours[At(c)].Points;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      segments.push_back({ set.Planar[At(p[i])], set.Planar[At(p[(i + 1) % p.size()])] });
    }
  }
  return segments;
}

double PlainDistance(
  const std::vector<PlanarSegment>& all, const std::vector<PlanarSegment>& others)
{
  double nearest = HUGE_VAL;
  for (const PlanarSegment& s : all)
  {
    for (const PlanarSegment& t : others)
    {
      nearest = std::min({ nearest, DistanceToSegment(s.A, t), DistanceToSegment(s.B, t),
        DistanceToSegment(t.A, s), DistanceToSegment(t.B, s) });
    }
  }
  return nearest;
}

TEST(NearestRegion, IsThatOfAPlainLook)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int trial = 0; trial < 30; ++trial)
  {
    SoupMaker maker;
    maker.Loop(Circle(uniform(random), uniform(random), 0.3, 12), 0);
    for (int i = 0; i < 12; ++i)
    {
      // In cells of a grid, so that they do not meet; some with a hole.
      const double x = 3 + 2 * (i % 4) + uniform(random);
      const double y = 2 * (i / 4) + uniform(random);
      maker.Loop(Circle(x, y, 0.4, 3 + i), 1);
      if (i % 3 == 0)
      {
        maker.Loop(Circle(x, y, 0.1, 5), 1);
      }
    }
    const ContourSet set = maker.Build();
    const std::vector<ContourRegion> regions = RegionsOf(set);
    int expected = -1;
    double least = HUGE_VAL;
    for (int wall : set.Levels[1].Contours)
    {
      const double distance = regions[At(wall)].Solid
        ? PlainDistance(SegmentsOf(set, regions[0]), SegmentsOf(set, regions[At(wall)]))
        : HUGE_VAL;
      if (distance < least)
      {
        least = distance;
        expected = wall;
      }
    }
    const auto found = FindNearestRegion(set, regions[0], regions, set.Levels[1], HUGE_VAL);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->Wall, expected);
    EXPECT_NEAR(found->Distance, least, 1e-15);
    EXPECT_FALSE(FindNearestRegion(set, regions[0], regions, set.Levels[1], 0.99 * least));
  }
}
}
