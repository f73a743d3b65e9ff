// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairSurface.h"

#include "Core/Mesh/MeshInvariants.h"
#include "Core/Polyhedral/PolyhedralShapes.h"
#include "Fair/TracedRaster.h"
#include "FairPromises.h"
#include "Mesh/MassProperties.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/TriangleComponents.h"
#include "TracedShapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace recon;
using namespace recon::testing;

namespace
{
FairSurface Build(const ContourSet& contours, const FairOptions& options)
{
  Monitor monitor;
  return BuildFairSurface(contours, options, monitor);
}

double AreaOf(const TriangleMesh& mesh)
{
  double area = 0;
  for (const auto& t : mesh.Triangles)
  {
    const Vector3 u = mesh.Points[t[1]] - mesh.Points[t[0]];
    area += 0.5 * Norm(Cross(u, mesh.Points[t[2]] - mesh.Points[t[0]]));
  }
  return area;
}

/// Sections of a ball, the outermost half a slice from the poles.
ContourSet Ball(double radius, int slices)
{
  RingStack levels;
  for (int l = 0; l < slices; ++l)
  {
    const double z = radius * (2 * (l + 0.5) / slices - 1);
    levels.push_back({ RegularPolygon(120, std::sqrt(radius * radius - z * z)) });
  }
  return BuildStack(levels, 2 * radius / slices);
}
}

TEST(FairSurface, KeepsTopologyAndTolerance)
{
  ExpectPromises(Ball(10, 12), NodeFairOptions());
  // One that becomes two, and a ring.
  ExpectPromises(
    BuildStack({ { RegularPolygon(60, 6) }, { RegularPolygon(60, 6) },
      { RegularPolygon(40, 2.5, 0, { -3, 0 }), RegularPolygon(40, 2.5, 0, { 3, 0 }) },
      { RegularPolygon(40, 2.5, 0, { -3, 0 }), RegularPolygon(40, 2.5, 0, { 3, 0 }) } }),
    NodeFairOptions());
  ExpectPromises(BuildStack({ { RegularPolygon(60, 6), RegularPolygon(40, 3) },
                   { RegularPolygon(60, 6), RegularPolygon(40, 3) },
                   { RegularPolygon(60, 5.5), RegularPolygon(40, 3.5) } }),
    NodeFairOptions());
}

TEST(FairSurface, IsNearerToABallThanThePolyhedralOne)
{
  Monitor monitor;
  const ContourSet ball = Ball(10, 12);
  const auto meanMiss = [](const TriangleMesh& mesh)
  {
    double miss = 0;
    double all = 0;
    for (const auto& t : mesh.Triangles)
    {
      const Point3 middle =
        (1.0 / 3) * (mesh.Points[t[0]] + (mesh.Points[t[1]] + mesh.Points[t[2]]));
      const double area =
        Norm(Cross(mesh.Points[t[1]] - mesh.Points[t[0]], mesh.Points[t[2]] - mesh.Points[t[0]]));
      const double fromMiddle = Norm(middle - Point3{ 0, 0, 55.0 / 6 });
      miss += area * std::abs(fromMiddle - 10);
      all += area;
    }
    return miss / all;
  };
  const double fair = meanMiss(Build(ball, NodeFairOptions()).Mesh);
  const double polyhedral =
    meanMiss(BuildPolyhedralSurface(ball, NodeFairOptions().Polyhedral, monitor).Mesh);
  EXPECT_LT(fair, 0.5 * polyhedral);
}

TEST(FairSurface, EvensOutPixels)
{
  const ContourSet discs = BuildStack(
    { { PixelDisc(9, 1) }, { PixelDisc(10, 1) }, { PixelDisc(10, 1) }, { PixelDisc(9, 1) } });
  const FairSurface fair = Build(discs, NodeFairOptions());
  ExpectSoundSurface(fair.Mesh);
  EXPECT_NEAR(fair.Tolerance, 0.5, 1e-9);
  EXPECT_LE(fair.Farthest, fair.Tolerance);
  Monitor monitor;
  const PolyhedralSurface stairs =
    BuildPolyhedralSurface(discs, NodeFairOptions().Polyhedral, monitor);
  EXPECT_LT(AreaOf(fair.Mesh), AreaOf(stairs.Mesh));
}

TEST(FairSurface, EvensOutATracedRaster)
{
  // A tube traced on a nearly binary image: what is off differs from slice to slice.
  RingStack levels;
  for (unsigned slice = 0; slice < 6; ++slice)
  {
    levels.push_back({ Traced(20.3, 2, 0.3, slice) });
  }
  const ContourSet tube = BuildStack(levels, 3);
  const FairSurface fair = Build(tube, NodeFairOptions());
  ExpectSoundSurface(fair.Mesh);
  const TracedRaster raster = FindTracedRaster(tube);
  EXPECT_NEAR(raster.Pitch, 2, 0.05);
  EXPECT_GT(raster.Unsteadiness, 0.1);
  EXPECT_NEAR(fair.Tolerance, 2.5 * raster.Unsteadiness, 1e-12);
  EXPECT_GE(fair.EdgeLength, 0.8 * raster.Pitch);
  EXPECT_LE(fair.Farthest, fair.Tolerance);
  Monitor monitor;
  const PolyhedralSurface rough =
    BuildPolyhedralSurface(tube, NodeFairOptions().Polyhedral, monitor);
  const auto roughness = [](const TriangleMesh& mesh)
  {
    double sum = 0;
    double count = 0;
    for (const Point3& p : mesh.Points)
    {
      const bool isSide = p[2] > 2 && p[2] < 13;
      sum += isSide ? std::abs(std::hypot(p[0], p[1]) - 20.3) : 0;
      count += isSide ? 1 : 0;
    }
    return sum / count;
  };
  EXPECT_LT(roughness(fair.Mesh), 0.7 * roughness(rough.Mesh));
}

TEST(FairSurface, KeepsAThinHoleWithinTheTolerance)
{
  // Much thinner than slices are apart, and of few triangles: bending is stiff there.
  RingStack levels;
  for (int slice = 0; slice < 4; ++slice)
  {
    levels.push_back({ Traced(20.3, 2, 0.3, slice), RegularPolygon(5, 0.8, 0, { 3, 2 }) });
  }
  ExpectPromises(BuildStack(levels, 3), NodeFairOptions());
}

TEST(FairSurface, KeepsAnyTolerance)
{
  // Also where the contours have corners, and edges that are asked for are longer than what was drawn.
  const ContourSet needles =
    BuildStack({ { Needles(7, 4, 1.5) }, { Needles(7, 3.5, 1.6) }, { Needles(7, 4, 1.5) } }, 1.5);
  for (const double tolerance : { 0.1, 0.01, 1e-6, 0.0 })
  {
    for (const double edges : { 0.0, 2.0 })
    {
      FairOptions options = NodeFairOptions();
      options.Tolerance = tolerance;
      options.EdgeLength = edges;
      ExpectPromises(needles, options);
      ExpectPromises(Ball(10, 6), options);
    }
  }
}

TEST(FairSurface, APieceOfASingleSliceKeepsItsVolume)
{
  // Nothing on other slices holds it up.
  RingStack levels(6, { RegularPolygon(60, 5) });
  levels[3].push_back(RegularPolygon(30, 2, 0, { 12, 0 }));
  const ContourSet contours = BuildStack(levels);
  ExpectPromises(contours, NodeFairOptions());
  const auto volumeBeside = [](const TriangleMesh& mesh)
  {
    const TriangleComponents pieces = FindTriangleComponents(mesh);
    const std::vector<double> volumes = ComputeSignedVolumes(mesh, pieces.Of, pieces.Count);
    EXPECT_EQ(pieces.Count, 2);
    return *std::min_element(volumes.begin(), volumes.end());
  };
  Monitor monitor;
  const double wanted =
    volumeBeside(BuildPolyhedralSurface(contours, NodeFairOptions().Polyhedral, monitor).Mesh);
  EXPECT_NEAR(volumeBeside(Build(contours, NodeFairOptions()).Mesh), wanted, 0.1 * wanted);
}

TEST(FairSurface, PropertiesAreTaken)
{
  FairOptions options = NodeFairOptions();
  options.EdgeLength = 1.5;
  options.Tolerance = 0.4;
  options.Tension = 1;
  const FairSurface fair = Build(Ball(10, 12), options);
  EXPECT_EQ(fair.EdgeLength, 1.5);
  EXPECT_EQ(fair.Tolerance, 0.4);
  EXPECT_EQ(fair.Tension, 1);
  options.EdgeLength = 0.75;
  EXPECT_GT(Build(Ball(10, 12), options).Mesh.Triangles.size(), 3 * fair.Mesh.Triangles.size());
}

TEST(FairSurface, SaysWhatItChose)
{
  const FairSurface fair = Build(Ball(10, 12), NodeFairOptions());
  ASSERT_FALSE(fair.Report.empty());
  EXPECT_NE(fair.Report.back().find("a tolerance of"), std::string::npos) << fair.Report.back();
}

TEST(FairSurface, DoesNotDependOnTheThreads)
{
  FairOptions options = NodeFairOptions();
  options.Threads = 1;
  const FairSurface one = Build(Ball(10, 12), options);
  options.Threads = 3;
  const FairSurface three = Build(Ball(10, 12), options);
  EXPECT_EQ(one.Mesh.Points, three.Mesh.Points);
  EXPECT_EQ(one.Mesh.Triangles, three.Mesh.Triangles);
}

TEST(FairSurface, CanBeStopped)
{
  class Impatient : public Monitor
  {
    bool AbortRequested() override { return ++this->Asked > 30; }
    int Asked = 0;
  } impatient;
  EXPECT_THROW(BuildFairSurface(Ball(10, 12), NodeFairOptions(), impatient), Aborted);
}

TEST(FairSurface, OneSliceIsAnError)
{
  EXPECT_THROW(Build(BuildStack({ { RegularPolygon(9, 1) } }), NodeFairOptions()), Error);
}

TEST(FairSurface, AnEdgeLengthThatAsksForTooManyTrianglesIsAnError)
{
  for (const double length : { 1e-2, 1e-9, 1e-300 })
  {
    FairOptions options = NodeFairOptions();
    options.EdgeLength = length;
    try
    {
      Build(Ball(10, 12), options);
      FAIL() << "edges of " << length;
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::string(error.what()).find("choose a larger Edge Length"), std::string::npos);
    }
  }
}

TEST(FairSurface, AFlatEndKeepsItsRimAndDoesNotFlare)
{
  // A tube: as wide between its slices as on them, and its ends are discs.
  FairOptions options = NodeFairOptions();
  options.Polyhedral.EndCaps = PolyhedralOptions::Flat;
  const ContourSet tube = BuildStack({ { RegularPolygon(60, 2) }, { RegularPolygon(60, 2) } }, 2);
  const FairSurface fair = Build(tube, options);
  ExpectSoundSurface(fair.Mesh);
  double least = 2;
  for (const Point3& p : fair.Mesh.Points)
  {
    const bool onEnd = std::abs(p[2]) < 0.02 || std::abs(p[2] - 2) < 0.02;
    least = onEnd ? least : std::min(least, std::hypot(p[0], p[1]));
    EXPECT_TRUE(p[2] > -0.02 && p[2] < 2.02);
  }
  EXPECT_GT(least, 1.95);
}
