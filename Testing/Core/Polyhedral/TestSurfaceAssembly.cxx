// SPDX-License-Identifier: GPL-3.0-or-later
// The surface of a stack, put together from parts, is the boundary of the whole that is looked at at once.
#include "BoundaryOracle.h"
#include "DegenerateStacks.h"
#include "SameSurface.h"

#include "Polyhedral/SolidBoundary.h"
#include "Polyhedral/SurfaceAssembly.h"

#include <gtest/gtest.h>

#include <string>

using namespace recon;
using namespace recon::testing;

namespace
{
AssembledSurface Assemble(const ContourSet& contours, const PolyhedralOptions& options,
  const PolyhedralStages& stages, std::size_t levelsAtATime)
{
  Monitor monitor;
  SurfaceAssembly assembly(contours, options, monitor);
  for (std::size_t levels = 0; levels < stages.Levels.size();)
  {
    levels = std::min(stages.Levels.size(), levels + levelsAtATime);
    // One level below those that were added is needed once more.
    EXPECT_LE(assembly.Add(stages, levels), levels);
  }
  return assembly.Finish();
}

/// @returns how many faces had halved edges
std::size_t ExpectSameFromParts(const ContourSet& contours, const PolyhedralOptions& options)
{
  Monitor monitor;
  const PolyhedralStages stages = BuildPolyhedralStages(contours, options, monitor);
  const AssembledSurface whole = Assemble(contours, options, stages, stages.Levels.size());
  const SolidBoundary boundary =
    ExtractSolidBoundary(BuildSolidComplex(stages.Levels, stages.Slabs));
  std::vector<std::array<int, 3>> triangles;
  for (const SolidBoundary::Face& face : boundary.Faces)
  {
    triangles.push_back(face.Points);
  }
  EXPECT_EQ(whole.Surface.Mesh.Triangles, triangles);
  EXPECT_EQ(whole.Surface.Mesh.Points.size(), boundary.Points.size());
  EXPECT_EQ(whole.IsPointExact.size(), boundary.Points.size());
  for (const std::size_t levelsAtATime : { 1, 2, 3 })
  {
    SCOPED_TRACE(std::to_string(levelsAtATime) + " levels at a time");
    const AssembledSurface parts = Assemble(contours, options, stages, levelsAtATime);
    ExpectSameSurface(parts.Surface, whole.Surface);
    EXPECT_EQ(parts.IsPointExact, whole.IsPointExact);
  }
  return boundary.Splits.size();
}
}

TEST(SurfaceAssembly, IsTheBoundaryOfTheWholeWithEveryOption)
{
  for (const PolyhedralOptions& options : EveryCombination())
  {
    SCOPED_TRACE("mapping " + std::to_string(options.Mapping) + ", ends " +
      std::to_string(options.EndCaps) + ", isolated " + std::to_string(options.IsolatedContours));
    ExpectSameFromParts(BuildStack(RandomStack(5)), options);
    ExpectSameFromParts(
      BuildStack({ { Blob(60, 0) }, { Blob(50, 1), Blob(30, 2, { 3, 0 }) }, { Blob(40, 3) },
        { Blob(30, 4) }, { Blob(20, 5), Blob(20, 6, { 4, 1 }) } }),
      options);
  }
}

TEST(SurfaceAssembly, IsTheBoundaryOfTheWholeWhereEdgesAreHalved)
{
  std::size_t halved = 0;
  for (unsigned seed = 1; seed <= 150; ++seed)
  {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Monitor monitor;
    const ContourSet contours = BuildContourSet(DegenerateStack(seed).Maker.Soup, {}, monitor);
    if (!contours.Parallel || contours.Levels.size() < 2)
    {
      continue;
    }
    for (const PolyhedralOptions::EndCapsType ends :
      { PolyhedralOptions::Flat, PolyhedralOptions::Tapered })
    {
      PolyhedralOptions options;
      options.EndCaps = ends;
      options.IsolatedContours = PolyhedralOptions::Extrude;
      halved += ExpectSameFromParts(contours, options);
    }
  }
  EXPECT_GT(halved, 20u) << "the stacks do not show it";
}
