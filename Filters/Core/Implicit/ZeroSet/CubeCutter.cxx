// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/CubeCutter.h"

#include <algorithm>
#include <utility>

namespace recon
{
namespace
{
/// Cut edges a cube, about: room is made for them at once.
constexpr std::size_t EdgesPerCube = 4;

/**
 * A cube is cut into six tetrahedra along its main diagonal (Kuhn), the same way in all cubes, so
 * that neighbours agree on the diagonals of their faces. Corners are named by their bits; each
 * tetrahedron climbs from 0 to 7.
 */
constexpr std::array<std::array<int, 4>, 6> Tetrahedra{ { { 0, 1, 3, 7 }, { 0, 1, 5, 7 },
  { 0, 2, 3, 7 }, { 0, 2, 6, 7 }, { 0, 4, 5, 7 }, { 0, 4, 6, 7 } } };

std::array<int, 3> Bits(int corner)
{
  return { corner & 1, (corner >> 1) & 1, (corner >> 2) & 1 };
}

/// A triangle as three pairs of cube corners, the first of each inside.
using CutTriangle = std::array<std::array<int, 2>, 3>;

/// Does the triangle through the edges' midpoints face away from the inside corner given? Integers,
/// exact.
bool FacesAway(const CutTriangle& t, int insideCorner)
{
  std::array<std::array<int, 3>, 3> p{};
  for (int k = 0; k < 3; ++k)
  {
    for (int a = 0; a < 3; ++a)
    {
      p[k][a] = Bits(t[k][0])[a] + Bits(t[k][1])[a];
    }
  }
  std::array<int, 3> u{};
  std::array<int, 3> v{};
  std::array<int, 3> w{};
  for (int a = 0; a < 3; ++a)
  {
    u[a] = p[1][a] - p[0][a];
    v[a] = p[2][a] - p[0][a];
    w[a] = 2 * Bits(insideCorner)[a] - p[0][a];
  }
  const int det = w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
    w[2] * (u[0] * v[1] - u[1] * v[0]);
  return det < 0;
}

void AppendOriented(CutTriangle t, int insideCorner, std::vector<CutTriangle>& triangles)
{
  if (!FacesAway(t, insideCorner))
  {
    std::swap(t[1], t[2]);
  }
  triangles.push_back(t);
}

/// The one or two triangles that cut a tetrahedron's inside corners from its outside ones.
void CutTetrahedron(
  const std::array<int, 4>& corners, int insideMask, std::vector<CutTriangle>& triangles)
{
  std::vector<int> in;
  std::vector<int> out;
  for (int k = 0; k < 4; ++k)
  {
    (((insideMask >> corners[k]) & 1) ? in : out).push_back(corners[k]);
  }
  if (in.size() == 1)
  {
    AppendOriented(
      { { { in[0], out[0] }, { in[0], out[1] }, { in[0], out[2] } } }, in[0], triangles);
  }
  else if (in.size() == 3)
  {
    AppendOriented(
      { { { in[0], out[0] }, { in[1], out[0] }, { in[2], out[0] } } }, in[0], triangles);
  }
  else if (in.size() == 2)
  {
    // Round the quadrilateral: each edge shares a corner with the next.
    AppendOriented(
      { { { in[0], out[0] }, { in[0], out[1] }, { in[1], out[1] } } }, in[0], triangles);
    AppendOriented(
      { { { in[0], out[0] }, { in[1], out[1] }, { in[1], out[0] } } }, in[0], triangles);
  }
}

/// The triangles of a cube for each of the 256 sets of inside corners.
const std::array<std::vector<CutTriangle>, 256>& CutTable()
{
  static const std::array<std::vector<CutTriangle>, 256> table = []
  {
    std::array<std::vector<CutTriangle>, 256> cuts;
    for (int mask = 0; mask < 256; ++mask)
    {
      for (const auto& tetrahedron : Tetrahedra)
      {
        CutTetrahedron(tetrahedron, mask, cuts[mask]);
      }
    }
    return cuts;
  }();
  return table;
}

LatticeIndex CornerOf(const LatticeIndex& cube, int c)
{
  return { cube[0] + (c & 1), cube[1] + ((c >> 1) & 1), cube[2] + ((c >> 2) & 1) };
}
}

CubeCutter::CubeCutter(const SurfaceTracker& tracker) : Tracker(tracker)
{
  this->Index.reserve(EdgesPerCube * tracker.Cubes().size());
  for (const LatticeIndex& cube : tracker.Cubes())
  {
    const int face = tracker.Grid().FaceInside(cube);
    if (face == 0)
    {
      this->March(cube);
    }
    else if (face > 0)
    {
      this->CutFace(cube, face);
    }
  }
}

void CubeCutter::March(const LatticeIndex& cube)
{
  int mask = 0;
  for (int c = 0; c < 8; ++c)
  {
    mask |= this->Tracker.ValueAt(CornerOf(cube, c)) > 0 ? 1 << c : 0;
  }
  for (const CutTriangle& t : CutTable()[mask])
  {
    std::array<int, 3> triangle{};
    for (int k = 0; k < 3; ++k)
    {
      triangle[k] = this->PointOn(cube, std::min(t[k][0], t[k][1]), std::max(t[k][0], t[k][1]));
    }
    this->Cut.push_back(triangle);
    this->CutFaces.push_back(0);
  }
}

/// The face that a cube beyond the bounds shares with one within, cut along the same diagonal.
void CubeCutter::CutFace(const LatticeIndex& cube, int face)
{
  const int axis = (face - 1) / 2;
  const bool high = face % 2 == 0;
  const int least = high ? 0 : 1 << axis;
  const int one = least | (1 << (axis + 1) % 3);
  const int other = least | (1 << (axis + 2) % 3);
  const int most = one | other;
  // Counterclockwise seen from where the axis points to.
  for (std::array<int, 3> corners :
    { std::array<int, 3>{ least, one, most }, { least, most, other } })
  {
    if (!high)
    {
      std::swap(corners[1], corners[2]);
    }
    this->CutFlatTriangle(cube, corners, face);
  }
}

/// The inside part of a triangle in the bounds.
void CubeCutter::CutFlatTriangle(
  const LatticeIndex& cube, const std::array<int, 3>& corners, int face)
{
  std::vector<int> around;
  for (int k = 0; k < 3; ++k)
  {
    const int here = corners[k];
    const int next = corners[(k + 1) % 3];
    const bool inside = this->Tracker.ValueAt(CornerOf(cube, here)) > 0;
    if (inside)
    {
      around.push_back(this->PointOn(cube, here, here));
    }
    if (inside != (this->Tracker.ValueAt(CornerOf(cube, next)) > 0))
    {
      around.push_back(this->PointOn(cube, std::min(here, next), std::max(here, next)));
    }
  }
  for (std::size_t k = 2; k < around.size(); ++k)
  {
    this->Cut.push_back({ around[0], around[k - 1], around[k] });
    this->CutFaces.push_back(static_cast<char>(face));
  }
}

/// Corners of a Kuhn tetrahedron are nested: the smaller's bits are among the larger's.
int CubeCutter::PointOn(const LatticeIndex& cube, int small, int large)
{
  const LatticeEdge edge{ CornerOf(cube, small), large ^ small };
  const auto [place, isNew] =
    this->Index.emplace(edge.Key(), static_cast<int>(this->CutEdges.size()));
  if (isNew)
  {
    this->CutEdges.push_back(edge);
  }
  return place->second;
}
}
