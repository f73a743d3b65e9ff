// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/MeshTopology.h"
#include "Mesh/SurfaceSummary.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

using namespace recon;
using namespace recon::testing;

TEST(SurfaceSummary, AClosedSurfaceHasItsVolume)
{
  EXPECT_EQ(SummariseSurface(MakeCube(), false), "closed, volume 1");
  EXPECT_EQ(SummariseSurface(MakeCube(), true), "closed, 0.001 cm3");
}

TEST(SurfaceSummary, AHoleIsCountedByItsEdges)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles.pop_back();
  EXPECT_EQ(SummariseSurface(mesh, false), "open (3 open edges), no volume");
}

TEST(SurfaceSummary, ATriangleTurnedOverIsNoManifold)
{
  TriangleMesh mesh = MakeCube();
  std::swap(mesh.Triangles[0][0], mesh.Triangles[0][1]);
  EXPECT_EQ(SummariseSurface(mesh, false), "no manifold (3 edges not of two triangles), no volume");
}

TEST(SurfaceSummary, NothingIsSaidToBeNothing)
{
  EXPECT_EQ(SummariseSurface(TriangleMesh(), true), "no surface");
}

/// The certificate's figures of the same edges.
TEST(SurfaceSummary, CountsWhatTheCertificateCounts)
{
  TriangleMesh mesh = MakeTorus(2, 0.5);
  unsigned state = 7;
  const auto next = [&](std::size_t below)
  {
    state = state * 1664525U + 1013904223U;
    return static_cast<std::size_t>(state >> 8) % below;
  };
  for (int round = 0; round < 40; ++round)
  {
    const std::size_t victim = next(mesh.Triangles.size());
    switch (next(3))
    {
      case 0:
        mesh.Triangles.erase(mesh.Triangles.begin() + static_cast<std::ptrdiff_t>(victim));
        break;
      case 1:
        mesh.Triangles.push_back(mesh.Triangles[victim]);
        break;
      default:
        std::swap(mesh.Triangles[victim][1], mesh.Triangles[victim][2]);
    }
    const EdgeCensus census = CountEdges(mesh);
    const TopologyFigures figures = CheckTopology(mesh).Total;
    EXPECT_EQ(census.Open, figures.OpenEdges);
    EXPECT_EQ(census.Open + census.Irregular == 0,
      figures.Closed && figures.EdgeManifold && figures.Oriented);
    EXPECT_GE(census.Irregular, figures.OverusedEdges);
  }
}
