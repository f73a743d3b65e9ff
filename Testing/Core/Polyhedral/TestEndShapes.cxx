// SPDX-License-Identifier: GPL-3.0-or-later
// Extrapolated ends: as high and as round as the sections before tell, no higher than a slice, and tapered
// where nothing is behind.
#include "Mesh/MassProperties.h"
#include "Polyhedral/EndShapes.h"
#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace recon;
using namespace recon::testing;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Of the area of a circle.
Ring Disk(double radius)
{
  constexpr int Corners = 64;
  return RegularPolygon(Corners, radius * std::sqrt(2 * Pi / Corners / std::sin(2 * Pi / Corners)));
}

/// Slices one apart from there on; stacks begin at 0.
ContourSet Ball(double radius, double first)
{
  std::vector<std::vector<Ring>> levels;
  for (double z = first; z < radius; z += 1)
  {
    levels.push_back({ Disk(std::sqrt(radius * radius - z * z)) });
  }
  return BuildStack(levels);
}

PolyhedralSurface Surface(const ContourSet& contours, PolyhedralOptions::EndCapsType ends)
{
  PolyhedralOptions options;
  options.EndCaps = ends;
  options.Mapping = PolyhedralOptions::Overlap;
  const PolyhedralSurface surface = BuildSurface(contours, options);
  ExpectKeepsPromises(surface, contours);
  return surface;
}

double VolumeOf(const PolyhedralSurface& surface)
{
  const TopologyFigures total = CheckTopology(surface.Mesh).Total;
  EXPECT_TRUE(total.Closed);
  const std::vector<int> one(surface.Mesh.Triangles.size(), 0);
  return *ComputeMassProperties(surface.Mesh, one, { true }).back().Volume;
}

double HighestOf(const PolyhedralSurface& surface)
{
  double highest = 0;
  for (const Point3& p : surface.Mesh.Points)
  {
    highest = std::max(highest, p[2]);
  }
  return highest;
}
}

TEST(EndShape, OfADiskIsTheBallThatItWasCutFrom)
{
  // Distances from the rim of points spread evenly over a disk of radius 3, of a ball of radius 5.
  std::vector<double> rooms;
  constexpr int Count = 4000;
  for (int i = 0; i < Count; ++i)
  {
    rooms.push_back(3 - 3 * std::sqrt((i + 0.5) / Count));
  }
  const EndShape shape({ 9 * Pi, -8 * Pi, -Pi }, 1, rooms);
  for (double r = 0; r < 3; r += 0.25)
  {
    EXPECT_NEAR(shape.HeightAt(3 - r), std::sqrt(25 - r * r) - 4, 1e-3) << r;
  }
  EXPECT_EQ(EndShape({ 9 * Pi, -8 * Pi, -Pi }, 0.5, rooms).HeightAt(3), 0.5) << "cut off";
}

TEST(ExtrapolatedEnds, ReachThePolesOfABall)
{
  for (const double first : { -4.9, -4.6, -4.3, -4.0 })
  {
    const ContourSet contours = Ball(5, first);
    const PolyhedralSurface surface = Surface(contours, PolyhedralOptions::Extrapolated);
    EXPECT_NEAR(HighestOf(surface), 5 - first, 0.03) << first;
    EXPECT_EQ(CheckTopology(surface.Mesh).Total.Euler, 2);
    const double truth = 4 * Pi / 3 * 125;
    const double tapered = VolumeOf(Surface(contours, PolyhedralOptions::Tapered));
    const double error = truth - VolumeOf(surface);
    EXPECT_GT(error, 0) << "straight between the slices";
    EXPECT_LT(error, 0.75 * (truth - tapered)) << first;
    EXPECT_LT(error, 0.02 * truth) << first;
  }
}

TEST(ExtrapolatedEnds, OfColumnsAreNoHigherThanTaperedOnes)
{
  const ContourSet column = BuildStack({ { Disk(3) }, { Disk(3) }, { Disk(3) } });
  EXPECT_NEAR(HighestOf(Surface(column, PolyhedralOptions::Extrapolated)), 2.25, 1e-9);
}

TEST(ExtrapolatedEnds, OfTinesAreTapered)
{
  Ring left = RegularPolygon(24, 1);
  Ring right = left;
  for (std::size_t i = 0; i < left.size(); ++i)
  {
    left[i][0] -= 4;
    right[i][0] += 4;
  }
  const ContourSet fork = BuildStack(
    { { Rectangle(-6, -1.5, 6, 1.5) }, { Rectangle(-6, -1.5, 6, 1.5) }, { left, right } });
  EXPECT_EQ(HighestOf(Surface(fork, PolyhedralOptions::Extrapolated)),
    HighestOf(Surface(fork, PolyhedralOptions::Tapered)));
}

TEST(ExtrapolatedEnds, AreTheSameWithAnyNumberOfThreadsAndByProximity)
{
  const ContourSet contours = Ball(4, -3.7);
  PolyhedralOptions options;
  options.EndCaps = PolyhedralOptions::Extrapolated;
  options.Threads = 1;
  const PolyhedralSurface one = BuildSurface(contours, options);
  options.Threads = 3;
  const PolyhedralSurface three = BuildSurface(contours, options);
  EXPECT_TRUE(one.Mesh.Points == three.Mesh.Points);
  EXPECT_TRUE(one.Mesh.Triangles == three.Mesh.Triangles);
  EXPECT_NEAR(HighestOf(one), 4 + 3.7, 0.03) << "which has no mapping of its own";
}
