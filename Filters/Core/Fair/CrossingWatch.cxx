// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/CrossingWatch.h"

#include "Base/Predicates.h"
#include "Mesh/TrianglePair.h"

#include <algorithm>

namespace recon
{
namespace
{
/// Corners and what is beside their box, which most points are, need no predicate.
bool IsWithin(const Point3& p, const std::array<Point3, 4>& corners)
{
  Box3 box;
  std::for_each(corners.begin(), corners.end(), [&box](const Point3& q) { box.Add(q); });
  if (!box.Contains(p) || std::find(corners.begin(), corners.end(), p) != corners.end())
  {
    return false;
  }
  const int turn = Orientation3(corners[0], corners[1], corners[2], corners[3]);
  bool within = turn != 0;
  for (std::size_t k = 0; k < 4 && within; ++k)
  {
    std::array<Point3, 4> other = corners;
    other[k] = p;
    within = Orientation3(other[0], other[1], other[2], other[3]) == turn;
  }
  return within;
}
}

CrossingWatch::CrossingWatch(const LinkedMesh& mesh, double edgeLength)
  : Mesh(mesh),
    EdgeLength(edgeLength)
{
}

Box3 CrossingWatch::BoxOf(int t) const
{
  Box3 box;
  for (const int v : this->Mesh.Triangles[t])
  {
    box.Add(this->Mesh.Points[v]);
  }
  return box;
}

void CrossingWatch::Register(const std::vector<int>& triangles)
{
  std::for_each(triangles.begin(), triangles.end(), [this](int t) { this->Register(t); });
}

/// To be put into the grid anew, before it is asked again.
void CrossingWatch::Register(int t)
{
  if (!this->Grid)
  {
    return;
  }
  this->IsChanged.resize(this->Mesh.Triangles.size(), 0);
  if (!this->IsChanged[t])
  {
    this->IsChanged[t] = 1;
    this->Changed.push_back(t);
  }
}

void CrossingWatch::PutChanged()
{
  for (const int t : this->Changed)
  {
    this->IsChanged[t] = 0;
    if (this->Mesh.IsAlive(t))
    {
      const Box3 box = this->BoxOf(t);
      this->Grid->Put(t, box.Low, box.High);
    }
  }
  this->Changed.clear();
}

bool CrossingWatch::Crosses(int t) const
{
  const Box3 box = this->BoxOf(t);
  return this->Grid->AnyNear(box.Low, box.High,
    [&](int s)
    {
      if (s == t || !this->Mesh.IsAlive(s) || !this->BoxOf(s).Meets(box))
      {
        return false;
      }
      const PairRelation relation = RelateTriangles(this->Mesh.Mesh, s, t);
      return relation == PairRelation::Crossing || relation == PairRelation::Overlapping;
    });
}

std::vector<CrossingWatch::Tetrahedron> CrossingWatch::WayOf(
  const std::vector<int>& around, int v, const Point3& to) const
{
  const auto& points = this->Mesh.Points;
  std::vector<Tetrahedron> way;
  for (const int t : around)
  {
    const LinkedMesh::Triangle& corners = this->Mesh.Triangles[t];
    const int k = this->Mesh.CornerOf(t, v);
    way.push_back({ to, points[v], points[corners[(k + 1) % 3]], points[corners[(k + 2) % 3]] });
  }
  return way;
}

bool CrossingWatch::AnyPointWithin(const std::vector<Tetrahedron>& way) const
{
  Box3 whole;
  for (const Tetrahedron& corners : way)
  {
    std::for_each(corners.begin(), corners.end(), [&whole](const Point3& p) { whole.Add(p); });
  }
  const auto isWithin = [&](int v)
  {
    const Point3& p = this->Mesh.Points[v];
    return whole.Contains(p) &&
      std::any_of(
        way.begin(), way.end(), [&p](const Tetrahedron& corners) { return IsWithin(p, corners); });
  };
  return this->Grid->AnyNear(whole.Low, whole.High,
    [&](int t)
    {
      const LinkedMesh::Triangle& corners = this->Mesh.Triangles[t];
      return this->Mesh.IsAlive(t) && std::any_of(corners.begin(), corners.end(), isWithin);
    });
}

bool CrossingWatch::TurnsPiece(const std::vector<int>& around, int v, const Point3& to) const
{
  std::vector<int> ring;
  for (const int t : around)
  {
    ring.push_back(this->Mesh.Triangles[t][(this->Mesh.CornerOf(t, v) + 1) % 3]);
  }
  const auto& points = this->Mesh.Points;
  double before = 0;
  double after = 0;
  for (const int w : ring)
  {
    for (const int t : this->Mesh.Around(w))
    {
      const LinkedMesh::Triangle& corners = this->Mesh.Triangles[t];
      if (std::find(corners.begin(), corners.end(), v) != corners.end())
      {
        continue;
      }
      const auto isOfRing = [&](int p)
      { return std::find(ring.begin(), ring.end(), p) != ring.end(); };
      if (!std::all_of(corners.begin(), corners.end(), isOfRing))
      {
        return false;
      }
      // Each comes three times, once a corner.
      const Point3& a = points[corners[0]];
      const Vector3 normal = Cross(points[corners[1]] - a, points[corners[2]] - a);
      before += Dot(normal, a - points[v]);
      after += Dot(normal, a - to);
    }
  }
  return !(before > 0 ? after > 0 : after < 0);
}

bool CrossingWatch::AnyCrosses(const std::vector<int>& triangles)
{
  if (!this->Grid)
  {
    this->Grid = std::make_unique<TriangleGrid>(2 * this->EdgeLength);
    for (int t = 0; t < static_cast<int>(this->Mesh.Triangles.size()); ++t)
    {
      this->Register(t);
    }
  }
  this->Register(triangles);
  this->PutChanged();
  return std::any_of(triangles.begin(), triangles.end(),
    [this](int t) { return this->Mesh.IsAlive(t) && this->Crosses(t); });
}
}
