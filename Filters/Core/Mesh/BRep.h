// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BRep.h
 * @brief Boundary representation: shells of vertices, half-edges, triangles and contours.
 *
 * The topology that the thesis's appendix ("BRep file grammar") writes down. Coordinates are in the
 * units and the right-handed system of the surface. All numbers count from 0 within their shell.
 */
#ifndef recon_BRep_h
#define recon_BRep_h

#include "Base/Monitor.h"
#include "Mesh/TriangleMesh.h"

#include <array>
#include <string>
#include <vector>

namespace recon
{
/**
 * One piece of surface.
 *
 * Every triangle has three half-edges of its own, so there are three times as many as faces. The
 * partner of a half-edge is the same edge the other way round, in the neighbouring triangle. Where
 * the shell has a border there is no neighbour; the partner is then the next half-edge along that
 * border, as in the example of the appendix, and the border is one of the contours.
 */
struct BRepShell
{
  std::vector<Point3> Vertices;
  std::vector<std::array<int, 2>>
    Edges; ///< a half-edge: the vertices that it comes from and goes to
  std::vector<std::array<int, 3>> Faces; ///< a triangle: its half-edges in order
  std::vector<int> Partners;             ///< a half-edge: its partner
  /// Closed loops of half-edges. Where a surface that pinches itself was cut apart into a manifold,
  /// the next one may start at another vertex of the same position.
  std::vector<std::vector<int>> Contours;
};

struct BRepShellSet
{
  std::vector<BRepShell> Shells;
};

struct BRep
{
  std::vector<BRepShellSet> ShellSets;
};

/**
 * What is wrong with the topology of a shell, in one sentence; empty where nothing is.
 *
 * Checked are the numbers (all within range), the faces (each half-edge in exactly one, three that
 * join end to start through three different vertices), the partners (either each other's, and the
 * same edge the other way round, or a border that closes) and the contours (loops that close).
 */
std::string FindShellDefect(const BRepShell& shell);

/// A triangle mesh with shells and contours that BRep and back leave as they are.
struct ShelledMesh
{
  TriangleMesh Mesh;
  std::vector<int> ShellOfTriangle;    ///< counted over all shell sets
  std::vector<int> ShellSetOfTriangle; ///< empty: one shell set
  /// Closed loops of points of Mesh; the first is not repeated.
  std::vector<std::vector<int>> Contours;
  std::vector<int> ShellOfContour;
  std::vector<int> ShellSetOfContour;
};

/// Shell after shell; points are not shared between shells. The shells must be free of defects.
ShelledMesh MakeMesh(const BRep& brep);

/// A loop of positions in space; the first is not repeated.
using SpaceLoop = std::vector<Point3>;

/**
 * Shells of a surface: a shell a connected component (triangles that share edges), in the
 * order of their first triangles; points, triangles and their corners keep their order.
 *
 * A contour is found where it runs along edges of the surface: its vertices are points of the
 * surface to the last bit, and each of its edges is one edge of the surface or a row of edges
 * whose inner points lie on it (thesis 5.1 and 5.2 add such points), up to 1e-9 of the size of
 * the surface. Its half-edges lie on the side where they run as the contour does; along a
 * border that the surface follows the other way round, the contour is turned.
 *
 * Borders that are no contour become contours as well, for only so the file tells them.
 *
 * @param shellSetOfTriangle number of the shell set of each triangle, or empty for one set
 * @param missing numbers of the contours that do not run along edges of one shell; they are left
 * out
 * @throws Error where a triangle uses a point twice, an edge belongs to more than two triangles,
 * two neighbours are oriented against each other, one component lies in two shell sets, or there is
 * no triangle; the sentence says where. Aborted.
 */
BRep MakeBRep(const TriangleMesh& mesh, const std::vector<int>& shellSetOfTriangle,
  const std::vector<SpaceLoop>& contours, std::vector<int>& missing, Monitor& monitor);
}

#endif
