// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfaceInvariants.h
 * @brief What the polyhedral surface promises about its contours, beside being sound.
 */
#ifndef recon_Testing_SurfaceInvariants_h
#define recon_Testing_SurfaceInvariants_h

#include "Contours/ContourSetBuilder.h"
#include "Core/Mesh/MeshInvariants.h"
#include "Mesh/SectionComparison.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace recon::testing
{
/// Numbers of the contours that the report says are not part of the surface: wholly, or in part
/// (one that touches itself bounds several pieces of solid).
struct LeftOut
{
  std::set<int> Wholly;
  std::set<int> InPart;
};

inline LeftOut ContoursLeftOut(const PolyhedralSurface& surface)
{
  LeftOut leftOut;
  for (const std::string& line : surface.Report)
  {
    int contour = -1;
    if (std::sscanf(line.c_str(), "Contour %d", &contour) == 1)
    {
      const bool inPart = line.find("left out in part") != std::string::npos;
      const bool wholly = !inPart && line.find("left out") != std::string::npos;
      (inPart ? leftOut.InPart : leftOut.Wholly).insert(wholly || inPart ? contour : -1);
    }
  }
  leftOut.Wholly.erase(-1);
  return leftOut;
}

/// The same contours without those: levels stay, even where nothing is left on them.
inline ContourSet WithoutContours(const ContourSet& contours, const std::set<int>& leftOut)
{
  ContourSet rest = contours;
  rest.Contours.clear();
  for (Level& level : rest.Levels)
  {
    level.Contours.clear();
  }
  for (std::size_t c = 0; c < contours.Contours.size(); ++c)
  {
    if (leftOut.count(static_cast<int>(c)) == 0)
    {
      rest.Levels[contours.Contours[c].Level].Contours.push_back(
        static_cast<int>(rest.Contours.size()));
      rest.Contours.push_back(contours.Contours[c]);
    }
  }
  return rest;
}

/// Every vertex of every contour is a point of the mesh, to the last bit.
inline void ExpectContourVertices(const PolyhedralSurface& surface, const ContourSet& contours)
{
  const std::set<Point3> points(surface.Mesh.Points.begin(), surface.Mesh.Points.end());
  int missing = 0;
  std::string first;
  for (std::size_t c = 0; c < contours.Contours.size(); ++c)
  {
    for (int p : contours.Contours[c].Points)
    {
      if (points.count(contours.Points[p]) == 0)
      {
        const Point3& x = contours.Points[p];
        first = missing++ > 0
          ? first
          : "contour of level " + std::to_string(contours.Contours[c].Level) + " at " +
            std::to_string(x[0]) + ", " + std::to_string(x[1]) + ", " + std::to_string(x[2]);
      }
    }
  }
  EXPECT_EQ(missing, 0) << "contour vertices that are no point of the surface; " << first;
}

/// Cut at the contours' planes, the surface gives the contours back, but for the area given of some
/// levels.
inline void ExpectSections(
  const TriangleMesh& mesh, const ContourSet& contours, const std::map<int, double>& missing = {})
{
  Monitor monitor;
  double contourArea = 0, difference = 0, worst = 0;
  int worstLevel = -1, open = 0;
  for (const auto& section : CompareSections(mesh, contours, {}, monitor))
  {
    if (missing.count(section.Level) > 0)
    {
      EXPECT_LE(section.SymmetricDifference.value_or(INFINITY), missing.at(section.Level))
        << "level " << section.Level << " where contours are left out in part";
      continue;
    }
    contourArea += section.ContourArea;
    open += !section.SymmetricDifference.has_value();
    const double here = section.SymmetricDifference.value_or(0);
    difference += here;
    if (here > worst)
    {
      worst = here;
      worstLevel = section.Level;
    }
    EXPECT_LE(here, 1e-6 * section.ContourArea) << "level " << section.Level;
  }
  EXPECT_EQ(open, 0) << "planes in which the surface is open";
  EXPECT_LT(difference, 1e-6 * contourArea) << "worst on level " << worstLevel;
}

/// The arrays beside the mesh belong to it.
inline void ExpectLabels(const PolyhedralSurface& surface, const ContourSet& contours)
{
  const std::size_t triangles = surface.Mesh.Triangles.size();
  ASSERT_EQ(surface.Slab.size(), triangles);
  ASSERT_EQ(surface.FaceKind.size(), triangles);
  ASSERT_EQ(surface.MappingGroup.size(), triangles);
  ASSERT_EQ(surface.Piece.size(), triangles);
  ASSERT_EQ(surface.PointKind.size(), surface.Mesh.Points.size());
  const int slabs = static_cast<int>(contours.Levels.size()) - 1;
  const auto& frame = contours.Levels[0].Frame;
  int outside = 0, tilted = 0;
  for (std::size_t t = 0; t < triangles; ++t)
  {
    // Caps may stand out beyond the first and the last level.
    outside += surface.Slab[t] < -1 || surface.Slab[t] > slabs;
    double low = INFINITY, high = -INFINITY;
    for (int p : surface.Mesh.Triangles[t])
    {
      low = std::min(low, frame.OffsetOf(surface.Mesh.Points[p]));
      high = std::max(high, frame.OffsetOf(surface.Mesh.Points[p]));
    }
    // Contour points of one level may scatter a little about its plane.
    const double span = contours.Levels.back().Offset - contours.Levels[0].Offset;
    tilted += surface.FaceKind[t] == PolyhedralSurface::Cap && high - low > 1e-3 * span;
  }
  EXPECT_EQ(outside, 0) << "triangles of no slab";
  EXPECT_EQ(tilted, 0) << "caps that are not in a plane";
}

/// Everything that PolyhedralSurface.h promises of a result.
inline void ExpectKeepsPromises(const PolyhedralSurface& surface, const ContourSet& contours)
{
  ExpectClosed(surface.Mesh);
  ExpectManifold(surface.Mesh);
  ExpectOriented(surface.Mesh);
  ExpectNoSelfIntersections(surface.Mesh);
  ExpectLabels(surface, contours);
  const LeftOut leftOut = ContoursLeftOut(surface);
  const ContourSet kept = WithoutContours(contours, leftOut.Wholly);
  ASSERT_FALSE(kept.Contours.empty()) << "every contour was left out";
  std::set<int> notWhole = leftOut.Wholly;
  notWhole.insert(leftOut.InPart.begin(), leftOut.InPart.end());
  ExpectContourVertices(surface, WithoutContours(contours, notWhole));
  std::map<int, double> missing;
  for (int c : leftOut.InPart)
  {
    // Some of what the outer wall encloses is there, so less than all is missing.
    const Contour& contour = contours.Contours[c];
    const Contour& wall = contour.Depth % 2 == 0 ? contour : contours.Contours[contour.Parent];
    missing[contour.Level] += std::abs(wall.SignedArea);
  }
  ExpectSections(surface.Mesh, kept, missing);
}

/// The same where all contours may have been left out.
inline void ExpectKeepsPromisesOrIsEmpty(
  const PolyhedralSurface& surface, const ContourSet& contours)
{
  if (ContoursLeftOut(surface).Wholly.size() == contours.Contours.size())
  {
    EXPECT_TRUE(surface.Mesh.Triangles.empty());
    return;
  }
  ExpectKeepsPromises(surface, contours);
}

/// For the trace of a failure.
inline std::string Describe(const PolyhedralOptions& options)
{
  const char* const caps[] = { "Flat", "HalfSlice", "Tapered", "None", "Extrapolated" };
  std::ostringstream text;
  text << (options.InternalPoints ? "with" : "without") << " internal points, "
       << (options.LiftInternalPoints ? "" : "not ") << "lifted, Mapping "
       << (options.Mapping == PolyhedralOptions::Overlap ? "Overlap" : "Proximity")
       << ", OverlapThreshold " << options.OverlapThreshold << ", MaximumGap " << options.MaximumGap
       << ", EndCaps " << caps[options.EndCaps] << ", IsolatedContours "
       << (options.IsolatedContours == PolyhedralOptions::Extrude ? "Extrude" : "Drop") << ", "
       << options.ForcedJoins.size() << " joins forced, " << options.ForbiddenJoins.size()
       << " forbidden";
  return text.str();
}

inline PolyhedralSurface BuildSurface(
  const ContourSet& contours, const PolyhedralOptions& options = {})
{
  Monitor monitor;
  return BuildPolyhedralSurface(contours, options, monitor);
}

inline double VolumeOf(const TriangleMesh& mesh)
{
  const std::vector<int> one(mesh.Triangles.size(), 0);
  return ComputeSignedVolumes(mesh, one, 1)[0];
}

/// Bitwise.
inline void ExpectEqualSurfaces(const PolyhedralSurface& a, const PolyhedralSurface& b)
{
  EXPECT_TRUE(a.Mesh.Points == b.Mesh.Points);
  EXPECT_TRUE(a.Mesh.Triangles == b.Mesh.Triangles);
  EXPECT_EQ(a.Slab == b.Slab && a.FaceKind == b.FaceKind, true);
  EXPECT_TRUE(a.MappingGroup == b.MappingGroup);
  EXPECT_TRUE(a.Piece == b.Piece);
  EXPECT_TRUE(a.PointKind == b.PointKind);
  EXPECT_EQ(a.Report, b.Report);
}
}

#endif
