// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/Keyholes.h"

#include "Base/Monitor.h"
#include "Contours/ContourSetBuilder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

namespace
{
using Loop = std::vector<recon::Point3>;

recon::LoopSoup SoupOf(const std::vector<Loop>& loops)
{
  recon::LoopSoup soup;
  for (const Loop& loop : loops)
  {
    recon::LoopSoup::Chain chain;
    chain.Closed = true;
    chain.Source = static_cast<int>(soup.Chains.size());
    for (const recon::Point3& p : loop)
    {
      chain.Points.push_back(static_cast<int>(soup.Points.size()));
      soup.Points.push_back(p);
    }
    soup.Chains.push_back(chain);
  }
  return soup;
}

recon::ContourSet SetOf(const recon::LoopSoup& soup)
{
  recon::Monitor monitor;
  recon::ContourSetOptions options;
  options.Parallel = false;
  return recon::BuildContourSet(soup, options, monitor);
}

Loop Square(double x, double y, double size)
{
  return { { x, y, 0 }, { x + size, y, 0 }, { x + size, y + size, 0 }, { x, y + size, 0 } };
}

/// A star with as many spikes as fit; every corner is a reflex or a sharp one.
Loop Star(double x, double y, double radius, int corners, double turn)
{
  Loop loop;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = turn + 6.283185307179586 * i / corners;
    const double r = i % 2 ? radius : radius / 3;
    loop.push_back({ x + r * std::cos(angle), y + r * std::sin(angle), 0 });
  }
  return loop;
}

/// Area in the plane z = 0; every point and every edge but the bridges once.
double SignedArea(const Loop& loop)
{
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const recon::Point3& a = loop[i];
    const recon::Point3& b = loop[(i + 1) % loop.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return twice / 2;
}

/// The walks are the region's border, each contour's edge once in its direction, and bridges in
/// pairs; read back they are the same contours.
void ExpectBorder(const recon::ContourSet& set, const std::vector<recon::KeyholeContour>& walks)
{
  using Edge = std::pair<recon::Point3, recon::Point3>;
  std::map<Edge, int> edges;
  std::vector<Loop> loops;
  for (const recon::KeyholeContour& walk : walks)
  {
    for (std::size_t i = 0; i < walk.Points.size(); ++i)
    {
      ++edges[{ walk.Points[i], walk.Points[(i + 1) % walk.Points.size()] }];
    }
    EXPECT_GT(SignedArea(walk.Points), 0);
    loops.push_back(walk.Points);
  }
  double area = 0;
  for (const recon::Contour& contour : set.Contours)
  {
    area += contour.SignedArea;
    for (std::size_t i = 0; i < contour.Points.size(); ++i)
    {
      const Edge edge(
        set.Points[contour.Points[i]], set.Points[contour.Points[(i + 1) % contour.Points.size()]]);
      ASSERT_EQ(edges[edge], 1);
      edges.erase(edge);
    }
  }
  for (const auto& [edge, count] : edges)
  {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({ edge.second, edge.first }), 1u);
  }
  const double walked = std::accumulate(walks.begin(), walks.end(), 0.0,
    [](double sum, const recon::KeyholeContour& walk) { return sum + SignedArea(walk.Points); });
  EXPECT_NEAR(walked, area, 1e-9 * (1 + area));
  const recon::ContourSet again = SetOf(SoupOf(loops));
  EXPECT_EQ(again.Contours.size(), set.Contours.size());
}
}

TEST(Keyholes, ContoursWithoutHolesStayAsTheyAre)
{
  const recon::ContourSet set = SetOf(SoupOf({ Square(0, 0, 1), Square(3, 0, 1) }));
  const std::vector<recon::KeyholeContour> walks = recon::JoinHoles(set);
  ASSERT_EQ(walks.size(), 2u);
  EXPECT_EQ(walks[0].Points.size(), 4u);
  EXPECT_EQ(walks[1].Source, 1);
  ExpectBorder(set, walks);
}

TEST(Keyholes, OneHoleTakesOneBridgeOfTheShortestLength)
{
  const recon::ContourSet set = SetOf(SoupOf({ Square(0, 0, 10), Square(7, 4, 2) }));
  const std::vector<recon::KeyholeContour> walks = recon::JoinHoles(set);
  ASSERT_EQ(walks.size(), 1u);
  EXPECT_EQ(walks[0].Points.size(), 4u + 4 + 2);
  ExpectBorder(set, walks);
}

TEST(Keyholes, HoleThatTouchesTheOutlineTakesNone)
{
  const recon::ContourSet set =
    SetOf(SoupOf({ Square(0, 0, 10), { { 0, 0, 0 }, { 3, 1, 0 }, { 1, 3, 0 } } }));
  ASSERT_EQ(set.Contours.size(), 2u);
  const std::vector<recon::KeyholeContour> walks = recon::JoinHoles(set);
  ASSERT_EQ(walks.size(), 1u);
  EXPECT_EQ(walks[0].Points.size(), 7u);
}

TEST(Keyholes, ManySpikyHolesAndIslands)
{
  for (unsigned int seed = 0; seed < 40; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Loop> loops{ Square(0, 0, 60) };
    for (int cell = 0; cell < 36; ++cell)
    {
      if (unit(random) < 0.2)
      {
        continue;
      }
      const double x = 5 + 10.0 * (cell % 6);
      const double y = 5 + 10.0 * (cell / 6);
      loops.push_back(Star(
        x, y, 2 + 2.8 * unit(random), 4 + 2 * static_cast<int>(6 * unit(random)), unit(random)));
      if (unit(random) < 0.5)
      {
        loops.push_back(Star(x, y, 0.4, 6, unit(random)));
      }
    }
    const recon::ContourSet set = SetOf(SoupOf(loops));
    ASSERT_EQ(set.Contours.size(), loops.size());
    ExpectBorder(set, recon::JoinHoles(set));
  }
}

TEST(Keyholes, HolesOnAGridOfPixels)
{
  // Everything is cocircular, collinear and at equal distances.
  std::vector<Loop> loops{ Square(0, 0, 13) };
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < 6; ++j)
    {
      loops.push_back(Square(1 + 2 * i, 1 + 2 * j, 1));
    }
  }
  const recon::ContourSet set = SetOf(SoupOf(loops));
  ASSERT_EQ(set.Contours.size(), loops.size());
  const std::vector<recon::KeyholeContour> walks = recon::JoinHoles(set);
  EXPECT_EQ(walks.size(), 1u);
  EXPECT_EQ(walks[0].Points.size(), 37u * 4 + 36 * 2);
  ExpectBorder(set, walks);
}

TEST(Keyholes, TiltedPlanes)
{
  std::vector<Loop> loops{ Square(0, 0, 10), Square(2, 2, 3), Square(6, 2, 3) };
  for (Loop& loop : loops)
  {
    for (recon::Point3& p : loop)
    {
      p[2] = 0.5 * p[0] + 0.25 * p[1];
    }
  }
  const recon::ContourSet set = SetOf(SoupOf(loops));
  const std::vector<recon::KeyholeContour> walks = recon::JoinHoles(set);
  ASSERT_EQ(walks.size(), 1u);
  EXPECT_EQ(walks[0].Points.size(), 12u + 4);
}
