// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MeshInvariants.h
 * @brief What every surface that this project makes must be, as checks that a test calls.
 *
 * Each judges by the same core that the Surface Certificate is made of, which has tests of its own
 * on meshes with known answers. A failure says how much is wrong and where the first of it lies.
 *
 * @code
 * ExpectClosed(mesh);
 * ExpectManifold(mesh);
 * ExpectOriented(mesh);             // consistently, and outward
 * ExpectNoSelfIntersections(mesh);  // none crosses or overlaps; touching is allowed
 * ExpectContourVerticesOnSurface(mesh, contours); // each is a vertex of the mesh, to the last bit
 * ExpectSectionsEqualContours(mesh, contours);    // the mesh cut at the levels gives the contours
 * back
 * @endcode
 */
#ifndef recon_Testing_MeshInvariants_h
#define recon_Testing_MeshInvariants_h

#include "Mesh/MassProperties.h"
#include "Mesh/MeshDefects.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SectionComparison.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SheetCrossings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace recon
{
namespace testing
{
inline std::string Describe(const TriangleMesh& mesh, int triangle)
{
  std::ostringstream text;
  text.precision(17);
  text << "triangle " << triangle;
  for (const int p : mesh.Triangles[triangle])
  {
    const Point3& x = mesh.Points[p];
    text << " " << p << " (" << x[0] << ", " << x[1] << ", " << x[2] << ")";
  }
  return text.str();
}

/// Up to three triangles that have one of the defects.
inline std::string DescribeDefects(
  const TriangleMesh& mesh, const std::vector<int>& defectOfTriangle, int defects)
{
  std::string text;
  int shown = 0;
  for (std::size_t t = 0; t < defectOfTriangle.size() && shown < 3; ++t)
  {
    if ((defectOfTriangle[t] & defects) != 0)
    {
      text += "\n  " + Describe(mesh, static_cast<int>(t));
      ++shown;
    }
  }
  return text;
}

/// There is a surface, every edge of it belongs to exactly two triangles, and none is degenerate by
/// index.
inline void ExpectClosed(const TriangleMesh& mesh)
{
  const MeshTopology topology = CheckTopology(mesh);
  const std::string where =
    DescribeDefects(mesh, topology.DefectOfTriangle, DefectOpenEdge | DefectOverusedEdge);
  EXPECT_GT(topology.Total.Components, 0) << "there is no surface at all";
  EXPECT_TRUE(topology.Total.Closed) << where;
  EXPECT_EQ(topology.Total.OpenEdges, 0) << where;
}

/// No edge of more than two triangles, no pinched vertex, no triangle twice.
inline void ExpectManifold(const TriangleMesh& mesh)
{
  const MeshTopology topology = CheckTopology(mesh);
  const std::string where = DescribeDefects(
    mesh, topology.DefectOfTriangle, DefectOverusedEdge | DefectPinchedVertex | DefectDuplicate);
  EXPECT_EQ(topology.Total.OverusedEdges, 0) << where;
  EXPECT_EQ(topology.Total.PinchedVertices, 0) << where;
  EXPECT_EQ(topology.Total.DuplicateTriangles, 0) << where;
}

/// Neighbours agree, and normals point away from the solid (into the hole, for a cavity).
inline void ExpectOriented(const TriangleMesh& mesh)
{
  const MeshTopology topology = CheckTopology(mesh);
  const std::string where =
    DescribeDefects(mesh, topology.DefectOfTriangle, DefectMisorientedEdge | DefectInward);
  EXPECT_EQ(topology.Total.MisorientedEdges, 0) << where;
  EXPECT_TRUE(topology.Total.Outward) << where;
}

/// No two triangles cross or overlap, no two sheets cross. Touching is allowed: it is what a
/// manifold cut leaves.
inline void ExpectNoSelfIntersections(const TriangleMesh& mesh)
{
  Monitor monitor;
  const SelfIntersections found = FindSelfIntersections(mesh, monitor);
  std::string where;
  int shown = 0;
  for (const auto& pair : found.Pairs)
  {
    if (pair.Kind != IntersectingPair::Touching && shown++ < 3)
    {
      where += "\n  " + Describe(mesh, pair.First) + "\n    and " + Describe(mesh, pair.Second);
    }
  }
  EXPECT_EQ(found.Crossing, 0) << where;
  EXPECT_EQ(found.Overlapping, 0) << where;
  const SheetCrossings sheets = FindSheetCrossings(mesh);
  EXPECT_EQ(sheets.Edges, 0) << "sheets cross at edges, the first at "
                             << Describe(mesh, sheets.Triangles.front().second);
}

/// All of the above.
inline void ExpectSoundSurface(const TriangleMesh& mesh)
{
  ExpectClosed(mesh);
  ExpectManifold(mesh);
  ExpectOriented(mesh);
  ExpectNoSelfIntersections(mesh);
}

/// The mesh encloses a volume, and it is this one up to a relative tolerance.
inline void ExpectVolume(const TriangleMesh& mesh, double volume, double relativeTolerance)
{
  const MeshTopology topology = CheckTopology(mesh);
  std::vector<bool> encloses;
  for (const auto& component : topology.Components)
  {
    encloses.push_back(component.EnclosesVolume());
  }
  const MassFigures whole =
    ComputeMassProperties(mesh, topology.ComponentOfTriangle, encloses).back();
  ASSERT_TRUE(whole.Volume.has_value()) << "the surface encloses no volume";
  EXPECT_NEAR(*whole.Volume, volume, relativeTolerance * std::fabs(volume));
}

/// Every vertex of every contour is a point of some triangle, with exactly its coordinates.
inline void ExpectContourVerticesOnSurface(const TriangleMesh& mesh, const ContourSet& contours)
{
  std::vector<Point3> used;
  for (const auto& t : mesh.Triangles)
  {
    for (const int p : t)
    {
      used.push_back(mesh.Points[p]);
    }
  }
  std::sort(used.begin(), used.end());
  int looked = 0;
  int missing = 0;
  std::ostringstream where;
  where.precision(17);
  for (const auto& contour : contours.Contours)
  {
    for (const int p : contour.Points)
    {
      const Point3& x = contours.Points[p];
      ++looked;
      if (!std::binary_search(used.begin(), used.end(), x) && missing++ < 3)
      {
        where << "\n  level " << contour.Level << " (" << x[0] << ", " << x[1] << ", " << x[2]
              << ")";
      }
    }
  }
  EXPECT_GT(looked, 0) << "there are no contours to look for";
  EXPECT_EQ(missing, 0) << "of " << looked << where.str();
}

/// At every level the area that belongs to the contours or to the surface's section alone is below
/// `relative` of the contours' area.
inline void ExpectSectionsEqualContours(
  const TriangleMesh& mesh, const ContourSet& contours, double relative = 1e-6)
{
  Monitor monitor;
  const auto levels = CompareSections(mesh, contours, SectionOptions(), monitor);
  EXPECT_FALSE(levels.empty()) << "there are no contours to compare with";
  for (const auto& level : levels)
  {
    if (!level.SymmetricDifference)
    {
      ADD_FAILURE() << "the surface is open at level " << level.Level << ", offset "
                    << level.Offset;
      continue;
    }
    EXPECT_LE(*level.SymmetricDifference, relative * level.ContourArea)
      << "at level " << level.Level << ", offset " << level.Offset << ", contours "
      << level.ContourArea << ", surface " << *level.SurfaceArea;
  }
}
}
}

#endif
