// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/CrossingGuard.h"

#include "Base/PointGrid.h"
#include "Base/SubMonitor.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TrianglePair.h"

#include <algorithm>
#include <tuple>

namespace recon
{
namespace
{
/// Sheets are told apart by the cosine of their normals.
constexpr double OtherSheet = 0.2;

using Triangle = EditableMesh::Triangle;
using Box = std::pair<Point3, Point3>;

Box BoxOf(const EditableMesh& mesh, const Triangle& t)
{
  Box box;
  for (int a = 0; a < 3; ++a)
  {
    std::tie(box.first[a], box.second[a]) =
      std::minmax({ mesh.P[t[0]][a], mesh.P[t[1]][a], mesh.P[t[2]][a] });
  }
  return box;
}

bool IsApart(const Box& box, const Point3& low, const Point3& high)
{
  for (int a = 0; a < 3; ++a)
  {
    if (high[a] < box.first[a] || box.second[a] < low[a])
    {
      return true;
    }
  }
  return false;
}
}

std::vector<char> ThinPlaces(
  const std::vector<Point3>& points, const std::vector<Vector3>& normals, double radius)
{
  // Eight cells around a point instead of 27.
  const PointGrid grid(points, 2 * radius);
  std::vector<char> thin(points.size(), 0);
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    if (!thin[v])
    {
      grid.ForNear(points[v], radius,
        [&](int w, double)
        {
          if (Dot(normals[v], normals[w]) < OtherSheet)
          {
            thin[v] = 1;
            thin[w] = 1;
          }
        });
    }
  }
  return thin;
}

std::int64_t MarkCrossings(const TriangleMesh& crossed, const std::vector<Point3>& points,
  double radius, int threads, Monitor& monitor, std::vector<char>& thin)
{
  SelfIntersectionOptions options;
  options.Threads = threads;
  AbortMonitor silent(monitor);
  const SelfIntersections found = FindSelfIntersections(crossed, options, silent);
  if (!found.Any())
  {
    return 0;
  }
  const PointGrid grid(points, radius);
  for (const IntersectingPair& pair : found.Pairs)
  {
    for (const int t : { pair.First, pair.Second })
    {
      if (pair.Kind != IntersectingPair::Touching)
      {
        grid.ForNear(
          crossed.Points[crossed.Triangles[t][0]], radius, [&](int v, double) { thin[v] = 1; });
      }
    }
  }
  return found.Crossing + found.Overlapping;
}

CrossingGuard::CrossingGuard(
  TriangleMesh& mesh, EditableMesh& edited, const std::vector<char>& thin, double cell)
  : Mesh(mesh),
    Edited(edited),
    Thin(thin),
    Cell(cell)
{
  edited.Changed = [this](int t) { this->Register(t); };
}

CrossingGuard::~CrossingGuard()
{
  this->Edited.Changed = nullptr;
}

bool CrossingGuard::AnyThin(const EditableMesh::Changes& before) const
{
  return std::any_of(before.begin(), before.end(),
    [this](const auto& change) { return this->IsThin(change.second); });
}

void CrossingGuard::Register(int t)
{
  if (this->Grid && this->Edited.IsAlive(t))
  {
    const auto [low, high] = BoxOf(this->Edited, this->Edited.T[t]);
    this->Grid->Put(t, low, high);
  }
}

bool CrossingGuard::Crosses(int t)
{
  if (!this->Grid)
  {
    this->Grid = std::make_unique<TriangleGrid>(this->Cell);
    for (int s = 0; s < static_cast<int>(this->Edited.T.size()); ++s)
    {
      this->Register(s);
    }
  }
  const auto [low, high] = BoxOf(this->Edited, this->Edited.T[t]);
  return this->Grid->AnyNear(low, high,
    [&, low = low, high = high](int s)
    {
      if (s == t || this->Edited.T[s][0] < 0 ||
        IsApart(BoxOf(this->Edited, this->Edited.T[s]), low, high))
      {
        return false;
      }
      const PairRelation relation = RelateTriangles(this->Mesh, s, t);
      return relation == PairRelation::Crossing || relation == PairRelation::Overlapping;
    });
}

bool CrossingGuard::KeepUncrossed(const EditableMesh::Changes& before)
{
  for (const auto& [t, old] : before)
  {
    if (this->Edited.IsAlive(t) && this->Crosses(t))
    {
      this->Edited.Restore(before);
      return false;
    }
  }
  return true;
}
}
