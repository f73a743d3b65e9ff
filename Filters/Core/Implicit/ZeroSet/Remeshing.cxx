// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/Remeshing.h"

#include "Base/Angles.h"
#include "Base/PointGrid.h"
#include "Implicit/ZeroSet/SliverRemoval.h"

#include <algorithm>
#include <tuple>

namespace recon
{
namespace
{
/// Edges shorter than this part of EdgeLength are collapsed, none longer than the other is made.
constexpr double ShortEdge = 0.6;
constexpr double LongEdge = 1.7;
/// But a triangle that is longer already may become longer by this factor, or its short edge would
/// stay for good.
constexpr double LongerAgain = 1.01;
/// Cosine that a triangle keeps with itself where the surface is not asked.
constexpr double LeastOwnAgreement = 0.5;
/// An edge is flipped where the least angle grows by more than this factor: the same pair of
/// triangles would else be flipped for and back by rounding; where that angle is nothing, by so many
/// radians.
constexpr double WorthFlipping = 1.0001;
constexpr double RoundingOfAngles = 1e-9;
/// Angles (radians) from which a triangle is good enough: a collapse, or a vertex that is spread,
/// may leave a smaller one than there was down to this.
constexpr double GoodForCollapse = 0.25;
constexpr double GoodForSpread = 0.4;
/// A vertex is snapped to an anchor within this part of EdgeLength, where the least angle around it
/// keeps the other part.
constexpr double AnchorReach = 0.6;
constexpr double AnchorKeeps = 0.99;
/// A snapped vertex may not make an angle smaller than this (degrees).
constexpr double LeastAnchoredAngle = 8;

bool SameWay(const Vector3& m, const Vector3& n)
{
  return Dot(m, n) > LeastOwnAgreement * Norm(m) * Norm(n);
}
}

Remesher::Remesher(TriangleMesh& mesh, std::vector<Vector3>& normals, double edgeLength,
  const std::vector<char>& thin, const std::vector<char>& faces)
  : Edited(mesh, normals, faces),
    EdgeLength(edgeLength),
    Guard(mesh, this->Edited, thin, 2 * edgeLength)
{
}

bool Remesher::Collapse(int u, int v, const Agreement& agreement)
{
  if (this->Edited.Around[u].empty() || this->Edited.Around[v].empty() ||
    !this->Edited.LinkAllows(u, v))
  {
    return false;
  }
  const double towardV = this->QualityOfCollapse(u, v, agreement);
  const double towardU = this->QualityOfCollapse(v, u, agreement);
  if (std::max(towardV, towardU) <= 0)
  {
    return false;
  }
  const int from = towardV >= towardU ? u : v;
  const EditableMesh::Changes before = this->Edited.Remember(this->Edited.Around[from]);
  this->Edited.Merge(from, from == u ? v : u);
  return this->Keep(before, agreement);
}

bool Remesher::Flip(int u, int v, const Agreement& agreement)
{
  const std::vector<int> both = this->Edited.TrianglesAt(u, v);
  if (both.size() != 2 || this->Edited.Faces[both[0]] != this->Edited.Faces[both[1]])
  {
    return false;
  }
  const int a = EditableMesh::Third(this->Edited.T[both[0]], u, v);
  const int b = EditableMesh::Third(this->Edited.T[both[1]], u, v);
  if (a == b || this->Edited.Around[u].size() < 4 || this->Edited.Around[v].size() < 4 ||
    !this->Edited.TrianglesAt(a, b).empty() ||
    Norm(this->Edited.P[a] - this->Edited.P[b]) > LongEdge * this->EdgeLength)
  {
    return false;
  }
  // both[0] runs u -> v or v -> u; keep its sense.
  const bool forward = EditableMesh::Follows(this->Edited.T[both[0]], u, v);
  const Triangle first = forward ? Triangle{ u, b, a } : Triangle{ u, a, b };
  const Triangle second = forward ? Triangle{ v, a, b } : Triangle{ v, b, a };
  const double before = std::min(
    this->Edited.AngleOf(this->Edited.T[both[0]]), this->Edited.AngleOf(this->Edited.T[both[1]]));
  const double after = std::min(this->Edited.AngleOf(first), this->Edited.AngleOf(second));
  const int face = this->Edited.Faces[both[0]];
  if (!(after > before * WorthFlipping + RoundingOfAngles) ||
    !this->Agrees(first, face, agreement) || !this->Agrees(second, face, agreement) ||
    !(Dot(this->Edited.AreaNormal(first), this->Edited.AreaNormal(second)) > 0) ||
    !this->MayReplace(both, { first, second }, agreement))
  {
    return false;
  }
  const EditableMesh::Changes old = this->Edited.Remember(both);
  this->Edited.Replace(both[0], first);
  this->Edited.Replace(both[1], second);
  return this->Keep(old, agreement);
}

bool Remesher::Move(int v, const Point3& to, const Vector3& normal, bool alwaysLook)
{
  const Point3 point = this->Edited.P[v];
  const Vector3 oldNormal = this->Edited.N[v];
  this->Edited.N[v] = normal;
  this->Edited.MoveTo(v, to);
  const std::vector<int>& around = this->Edited.Around[v];
  const bool look = alwaysLook ||
    std::any_of(around.begin(), around.end(),
      [this](int t) { return this->Guard.IsThin(this->Edited.T[t]); });
  if (look &&
    std::any_of(around.begin(), around.end(), [this](int t) { return this->Guard.Crosses(t); }))
  {
    this->Edited.N[v] = oldNormal;
    this->Edited.MoveTo(v, point);
    return false;
  }
  return true;
}

/// A change may make triangles cross where the surface's normals are not asked, and where another
/// sheet is near.
bool Remesher::Keep(const EditableMesh::Changes& before, const Agreement& agreement)
{
  return !(agreement.OnlyWithItself || this->Guard.AnyThin(before)) ||
    this->Guard.KeepUncrossed(before);
}

bool Remesher::Agrees(const Triangle& t, int face, const Agreement& agreement) const
{
  const Vector3 n = this->Edited.AreaNormal(t);
  const double length = Norm(n);
  if (agreement.OnlyWithItself)
  {
    return length > 0;
  }
  for (const int v : t)
  {
    if (!(Dot(n, this->Edited.NormalAt(v, face)) > agreement.WithSurface * length))
    {
      return false;
    }
  }
  return true;
}

/// Does a triangle keep its direction? A needle has none.
bool Remesher::KeepsItself(const Triangle& before, const Triangle& after) const
{
  return this->IsNeedle(before) ||
    SameWay(this->Edited.AreaNormal(before), this->Edited.AreaNormal(after));
}

bool Remesher::IsNeedle(const Triangle& t) const
{
  return this->Edited.AngleOf(t) < SliverAngle * RadiansPerDegree;
}

double Remesher::QualityAround(int v, const Agreement& agreement) const
{
  double least = Pi;
  for (const int t : this->Edited.Around[v])
  {
    if (!this->Agrees(this->Edited.T[t], this->Edited.Faces[t], agreement))
    {
      return -1;
    }
    least = std::min(least, this->Edited.AngleOf(this->Edited.T[t]));
  }
  return least;
}

double Remesher::QualityOfMove(int v, const Point3& to)
{
  const Point3 point = this->Edited.P[v];
  double least = Pi;
  for (const int t : this->Edited.Around[v])
  {
    const Vector3 old = this->Edited.AreaNormal(this->Edited.T[t]);
    const bool needle = this->IsNeedle(this->Edited.T[t]);
    this->Edited.P[v] = to;
    const Vector3 now = this->Edited.AreaNormal(this->Edited.T[t]);
    const bool keeps = needle || SameWay(old, now);
    least = std::min(least, keeps ? this->Edited.AngleOf(this->Edited.T[t]) : -1);
    this->Edited.P[v] = point;
  }
  return least;
}

bool Remesher::MayReplace(const std::vector<int>& before, const std::array<Triangle, 2>& after,
  const Agreement& agreement) const
{
  if (!agreement.OnlyWithItself)
  {
    return true;
  }
  bool all = true;
  bool any = false;
  for (const int t : before)
  {
    any = any || !this->IsNeedle(this->Edited.T[t]);
    all = all && this->KeepsItself(this->Edited.T[t], after[0]) &&
      this->KeepsItself(this->Edited.T[t], after[1]);
  }
  return all && any;
}

/// The least angle that u's triangles would have with v in its place; <= 0 where that may not be.
double Remesher::QualityOfCollapse(int u, int v, const Agreement& agreement) const
{
  if (this->Edited.Pinned[u] || (this->Edited.Border[u] && !this->Edited.Border[v]) ||
    (this->Edited.Border[u] && !this->Edited.IsBorderEdge(u, v)))
  {
    return -1;
  }
  double least = Pi;
  for (const int t : this->Edited.Around[u])
  {
    Triangle moved = this->Edited.T[t];
    if (EditableMesh::Has(moved, v))
    {
      continue;
    }
    std::replace(moved.begin(), moved.end(), u, v);
    if (!this->Agrees(moved, this->Edited.Faces[t], agreement) ||
      this->Edited.LongestEdge(moved) >
        std::max(
          LongEdge * this->EdgeLength, LongerAgain * this->Edited.LongestEdge(this->Edited.T[t])) ||
      (agreement.OnlyWithItself && !this->KeepsItself(this->Edited.T[t], moved)))
    {
      return -1;
    }
    least = std::min(least, this->Edited.AngleOf(moved));
  }
  // Not worse than what is there, unless that is good anyway.
  const double before = this->QualityAround(u, WithItself);
  return least > std::min(before, GoodForCollapse) ? least : -1;
}

void Remesher::CollapseShortEdges()
{
  const double limit = ShortEdge * this->EdgeLength;
  for (int pass = 0; pass < 4; ++pass)
  {
    std::size_t collapsed = 0;
    for (const auto& [u, v] : this->Edited.EdgesShorterThan(limit))
    {
      const Vector3 edge = this->Edited.P[v] - this->Edited.P[u];
      // A neighbour may have gone, or have been replaced, since the list was made.
      if (Norm(edge) < limit && this->Collapse(u, v, Usual))
      {
        ++collapsed;
      }
    }
    if (collapsed == 0)
    {
      return;
    }
  }
}

void Remesher::FlipEdges()
{
  for (int pass = 0; pass < 6; ++pass)
  {
    std::size_t flipped = 0;
    for (std::size_t t = 0; t < this->Edited.T.size(); ++t)
    {
      for (int k = 0; k < 3 && this->Edited.T[t][0] >= 0; ++k)
      {
        const int u = this->Edited.T[t][k];
        const int v = this->Edited.T[t][(k + 1) % 3];
        flipped += this->Flip(u, v, Usual) ? 1 : 0;
      }
    }
    if (flipped == 0)
    {
      return;
    }
  }
}

/// Where a vertex would like to be: the mean of its neighbours, in its tangent plane.
Point3 Remesher::Relaxed(int v) const
{
  const std::vector<int> around = this->Edited.Neighbours(v);
  Point3 mean{ 0, 0, 0 };
  for (const int w : around)
  {
    mean = mean + this->Edited.P[w];
  }
  const Vector3 move = (1.0 / static_cast<double>(around.size())) * mean - this->Edited.P[v];
  const Vector3& n = this->Edited.N[v];
  return this->Edited.P[v] + (move - Dot(move, n) * n);
}

void Remesher::Spread(const Projector& project)
{
  std::vector<int> vertices;
  std::vector<Point3> points;
  for (int v = 0; v < static_cast<int>(this->Edited.P.size()); ++v)
  {
    if (!this->Edited.Around[v].empty() && !this->Edited.Border[v] && !this->Edited.Pinned[v])
    {
      vertices.push_back(v);
      points.push_back(this->Relaxed(v));
    }
  }
  std::vector<Vector3> normals;
  std::vector<char> done;
  project(points, normals, done);
  for (std::size_t i = 0; i < vertices.size(); ++i)
  {
    if (!done[i])
    {
      continue;
    }
    const int v = vertices[i];
    const Point3 oldPoint = this->Edited.P[v];
    const Vector3 oldNormal = this->Edited.N[v];
    const double before = this->QualityAround(v, Usual);
    this->Edited.P[v] = points[i];
    this->Edited.N[v] = normals[i];
    const double after = this->QualityAround(v, Usual);
    this->Edited.P[v] = oldPoint;
    this->Edited.N[v] = oldNormal;
    if (after > std::min(before, GoodForSpread))
    {
      this->Move(v, points[i], normals[i]);
    }
  }
}

std::size_t Remesher::Anchor(const std::vector<Point3>& anchors)
{
  const PointGrid grid(this->Edited.P, this->EdgeLength);
  std::vector<std::tuple<double, int, int>> pairs;
  for (int a = 0; a < static_cast<int>(anchors.size()); ++a)
  {
    grid.ForNear(anchors[a], AnchorReach * this->EdgeLength,
      [&](int v, double r2)
      {
        if (!this->Edited.Around[v].empty() && !this->Edited.Border[v])
        {
          pairs.emplace_back(r2, a, v);
        }
      });
  }
  std::sort(pairs.begin(), pairs.end());
  std::vector<char> placed(anchors.size(), 0);
  std::size_t count = 0;
  for (const auto& [r2, a, v] : pairs)
  {
    if (placed[a] || this->Edited.Pinned[v])
    {
      continue;
    }
    const Point3 old = this->Edited.P[v];
    const double before = this->QualityAround(v, Usual);
    this->Edited.P[v] = anchors[a];
    const double after = this->QualityAround(v, Usual);
    this->Edited.P[v] = old;
    if (after > std::min(before * AnchorKeeps, LeastAnchoredAngle * RadiansPerDegree) &&
      this->Move(v, anchors[a], this->Edited.N[v]))
    {
      placed[a] = 1;
      this->Edited.Pinned[v] = 1;
      ++count;
    }
  }
  return count;
}
}
