// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/MeshCleanUp.h"

#include "Base/PointGrid.h"
#include "Base/SubMonitor.h"
#include "Implicit/ZeroSet/TriangleGrid.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TrianglePair.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <tuple>

namespace recon
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
/// Edges shorter than this part of EdgeLength are collapsed, none longer than the other is made.
constexpr double ShortEdge = 0.6;
constexpr double LongEdge = 1.7;
/// But a triangle that is longer already may become longer by this factor, or its short edge would
/// stay for good.
constexpr double LongerAgain = 1.01;
/// Cosine that a triangle's normal must keep with the surface's normals at its corners.
constexpr double LeastAgreement = 0.35;
/// The same where a sliver has to go at any (safe) price.
constexpr double LastResortAgreement = 0.05;
/// The same where not even that mends it: the surface's normals are not asked, as they say nothing
/// where a wall is thinner than a cell or the bounds cut it; no triangle may turn from itself.
constexpr double OwnAgreement = -2;
/// Cosine that a triangle keeps with itself then.
constexpr double LeastOwnAgreement = 0.5;
/// Triangles with a smaller angle (degrees) are worked on then.
constexpr double NeedleAngle = 2;
/// Triangles with a smaller angle (degrees) are worked on after the regular rounds.
constexpr double SliverAngle = 5;
/// A needle that can neither be flipped nor collapsed, as its short edge is the waist of a neck,
/// has an end of that edge moved along the surface: by so many edge lengths, in so many directions.
constexpr double Shifts[] = { 0.02, 0.04, 0.08, 0.16 };
constexpr int ShiftDirections = 8;
constexpr int MaximumShiftPasses = 4;
/// A snapped vertex may not make an angle smaller than this (degrees).
constexpr double LeastAnchoredAngle = 8;
constexpr int MaximumSliverPasses = 12;
/// Where two sheets of the surface are nearer than this many edge lengths, no change may make
/// triangles cross. Sheets are told apart by the cosine of their normals.
constexpr double ThinPlace = 1;
constexpr double OtherSheet = 0.2;
/// Where triangles cross all the same, it is begun again with all places thin that are so many edge
/// lengths around, up to so many times.
constexpr double AroundCrossing = 4;
constexpr int MaximumAttempts = 3;

using Triangle = std::array<int, 3>;

double AngleAt(const Point3& a, const Point3& b, const Point3& c)
{
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  return std::atan2(Norm(Cross(u, v)), Dot(u, v));
}

double LeastAngleOf(const Point3& a, const Point3& b, const Point3& c)
{
  return std::min({ AngleAt(a, b, c), AngleAt(b, c, a), AngleAt(c, a, b) });
}

/**
 * A triangle mesh that is edited in place: triangles die, points lose theirs, and Compact() at the
 * end.
 */
class Editor
{
public:
  /// @param thin a point: whether changes there are looked at for crossings
  Editor(TriangleMesh& mesh, std::vector<Vector3>& normals, double edgeLength,
    const std::vector<char>& thin)
    : P(mesh.Points),
      N(normals),
      T(mesh.Triangles),
      Around(mesh.Points.size()),
      Border(mesh.Points.size(), 0),
      Pinned(mesh.Points.size(), 0),
      Mesh(mesh),
      Thin(thin),
      EdgeLength(edgeLength)
  {
    for (int t = 0; t < static_cast<int>(this->T.size()); ++t)
    {
      for (const int v : this->T[t])
      {
        this->Around[v].push_back(t);
      }
    }
    for (int v = 0; v < static_cast<int>(this->P.size()); ++v)
    {
      for (const int w : this->Neighbours(v))
      {
        if (this->TrianglesAt(v, w).size() == 1)
        {
          this->Border[v] = 1;
        }
      }
    }
  }

  std::vector<int> Neighbours(int v) const
  {
    std::vector<int> all;
    for (const int t : this->Around[v])
    {
      for (const int w : this->T[t])
      {
        if (w != v)
        {
          all.push_back(w);
        }
      }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  /// The triangles on an edge.
  std::vector<int> TrianglesAt(int u, int v) const
  {
    std::vector<int> found;
    for (const int t : this->Around[u])
    {
      if (Has(this->T[t], v))
      {
        found.push_back(t);
      }
    }
    return found;
  }

  /// All edges (u < v), shorter than a limit, shortest first.
  std::vector<std::pair<int, int>> EdgesShorterThan(double limit) const
  {
    std::vector<std::tuple<double, int, int>> edges;
    for (const Triangle& t : this->T)
    {
      for (int k = 0; k < 3 && t[0] >= 0; ++k)
      {
        const int u = t[k];
        const int v = t[(k + 1) % 3];
        const double length = Norm(this->P[v] - this->P[u]);
        if (length < limit)
        {
          edges.emplace_back(length, std::min(u, v), std::max(u, v));
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    std::vector<std::pair<int, int>> pairs;
    for (const auto& [length, u, v] : edges)
    {
      pairs.emplace_back(u, v);
    }
    return pairs;
  }

  /// Collapses an edge onto that of its ends which leaves the better triangles, if either may be
  /// kept.
  bool Collapse(int u, int v, double agreement)
  {
    if (this->Around[u].empty() || this->Around[v].empty() || !this->LinkAllows(u, v))
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
    const Changes before = this->Remember(this->Around[from]);
    this->Merge(from, from == u ? v : u);
    return !this->MayCross(before, agreement) || this->KeepUncrossed(before);
  }

  /// Flips the edge where that makes the smaller of the two triangles' least angles larger.
  bool Flip(int u, int v, double agreement)
  {
    const std::vector<int> both = this->TrianglesAt(u, v);
    if (both.size() != 2)
    {
      return false;
    }
    const int a = Third(this->T[both[0]], u, v);
    const int b = Third(this->T[both[1]], u, v);
    if (a == b || this->Around[u].size() < 4 || this->Around[v].size() < 4 ||
      !this->TrianglesAt(a, b).empty() ||
      Norm(this->P[a] - this->P[b]) > LongEdge * this->EdgeLength)
    {
      return false;
    }
    // both[0] runs u -> v or v -> u; keep its sense.
    const bool forward = Follows(this->T[both[0]], u, v);
    const Triangle first = forward ? Triangle{ u, b, a } : Triangle{ u, a, b };
    const Triangle second = forward ? Triangle{ v, a, b } : Triangle{ v, b, a };
    const double before =
      std::min(this->AngleOf(this->T[both[0]]), this->AngleOf(this->T[both[1]]));
    const double after = std::min(this->AngleOf(first), this->AngleOf(second));
    if (!(after > before * 1.0001 + 1e-9) || !this->Agrees(first, agreement) ||
      !this->Agrees(second, agreement) || !this->Agree(first, second) ||
      !this->MayReplace(both, { first, second }, agreement))
    {
      return false;
    }
    const Changes old = this->Remember(both);
    this->Replace(both[0], first);
    this->Replace(both[1], second);
    return !this->MayCross(old, agreement) || this->KeepUncrossed(old);
  }

  bool Agrees(const Triangle& t, double agreement) const
  {
    const Vector3 n = this->AreaNormal(t);
    const double length = Norm(n);
    for (const int v : t)
    {
      if (!(Dot(n, this->N[v]) > agreement * length))
      {
        return false;
      }
    }
    return true;
  }

  double AngleOf(const Triangle& t) const
  {
    return LeastAngleOf(this->P[t[0]], this->P[t[1]], this->P[t[2]]);
  }

  /// The least angle around a vertex, negative where a triangle has turned against the surface.
  double QualityAround(int v, double agreement) const
  {
    double least = Pi;
    for (const int t : this->Around[v])
    {
      if (!this->Agrees(this->T[t], agreement))
      {
        return -1;
      }
      least = std::min(least, this->AngleOf(this->T[t]));
    }
    return least;
  }

  /// The least angle around a vertex if it were there; negative where a triangle would turn.
  double QualityOfMove(int v, const Point3& to)
  {
    const Point3 point = this->P[v];
    double least = Pi;
    for (const int t : this->Around[v])
    {
      const Vector3 old = this->AreaNormal(this->T[t]);
      const bool needle = this->IsNeedle(this->T[t]);
      this->P[v] = to;
      const Vector3 now = this->AreaNormal(this->T[t]);
      const bool keeps = needle || this->SameWay(old, now);
      least = std::min(least, keeps ? this->AngleOf(this->T[t]) : -1);
      this->P[v] = point;
    }
    return least;
  }

  /// Moves a vertex, unless triangles would cross: in thin places, or where that is always looked
  /// at. @returns whether it was moved.
  bool Move(int v, const Point3& to, const Vector3& normal, bool alwaysLook = false)
  {
    const Point3 point = this->P[v];
    const Vector3 oldNormal = this->N[v];
    this->P[v] = to;
    this->N[v] = normal;
    this->RegisterAround(v);
    const std::vector<int>& around = this->Around[v];
    const bool look = alwaysLook ||
      std::any_of(around.begin(), around.end(), [this](int t) { return this->IsThin(this->T[t]); });
    if (look &&
      std::any_of(around.begin(), around.end(), [this](int t) { return this->Crosses(t); }))
    {
      this->P[v] = point;
      this->N[v] = oldNormal;
      this->RegisterAround(v);
      return false;
    }
    return true;
  }

  void Compact()
  {
    std::vector<int> renamed(this->P.size(), -1);
    std::size_t points = 0;
    std::size_t triangles = 0;
    for (const Triangle& t : this->T)
    {
      if (t[0] >= 0)
      {
        this->T[triangles++] = t;
      }
    }
    this->T.resize(triangles);
    for (std::size_t v = 0; v < this->P.size(); ++v)
    {
      if (!this->Around[v].empty())
      {
        renamed[v] = static_cast<int>(points);
        this->P[points] = this->P[v];
        this->N[points] = this->N[v];
        ++points;
      }
    }
    this->P.resize(points);
    this->N.resize(points);
    for (Triangle& t : this->T)
    {
      for (int& v : t)
      {
        v = renamed[v];
      }
    }
  }

  std::vector<Point3>& P;
  std::vector<Vector3>& N;
  std::vector<Triangle>& T;
  std::vector<std::vector<int>> Around;
  std::vector<char> Border;
  std::vector<char> Pinned;

private:
  using Changes = std::vector<std::pair<int, Triangle>>; ///< triangles by number, as they were

  Changes Remember(const std::vector<int>& triangles) const
  {
    Changes all;
    for (const int t : triangles)
    {
      all.emplace_back(t, this->T[t]);
    }
    return all;
  }

  bool IsThin(const Triangle& t) const
  {
    return this->Thin[t[0]] || this->Thin[t[1]] || this->Thin[t[2]];
  }

  /// Is it possible that a change makes triangles cross? Where the surface's normals are not asked,
  /// and where another sheet is near.
  bool MayCross(const Changes& before, double agreement) const
  {
    return agreement <= OwnAgreement ||
      std::any_of(before.begin(), before.end(),
        [this](const auto& change) { return this->IsThin(change.second); });
  }

  /// Takes a change back where a changed triangle crosses another one. @returns whether it stays.
  bool KeepUncrossed(const Changes& before)
  {
    for (const auto& [t, old] : before)
    {
      if (this->T[t][0] >= 0 && this->Crosses(t))
      {
        this->Restore(before);
        return false;
      }
    }
    return true;
  }

  void Restore(const Changes& before)
  {
    for (const auto& [t, old] : before)
    {
      if (this->T[t][0] >= 0)
      {
        this->Detach(t);
      }
      this->T[t] = old;
      for (const int v : old)
      {
        this->Around[v].push_back(t);
      }
      this->Register(t);
    }
  }

  bool Crosses(int t)
  {
    if (!this->Grid)
    {
      this->Grid = std::make_unique<TriangleGrid>(2 * this->EdgeLength);
      for (int s = 0; s < static_cast<int>(this->T.size()); ++s)
      {
        this->Register(s);
      }
    }
    const auto [low, high] = this->BoxOf(this->T[t]);
    return this->Grid->AnyNear(low, high,
      [&, low = low, high = high](int s)
      {
        if (s == t || this->T[s][0] < 0 || this->IsApart(this->T[s], low, high))
        {
          return false;
        }
        const PairRelation relation = RelateTriangles(this->Mesh, s, t);
        return relation == PairRelation::Crossing || relation == PairRelation::Overlapping;
      });
  }

  std::pair<Point3, Point3> BoxOf(const Triangle& t) const
  {
    std::pair<Point3, Point3> box;
    for (int a = 0; a < 3; ++a)
    {
      std::tie(box.first[a], box.second[a]) =
        std::minmax({ this->P[t[0]][a], this->P[t[1]][a], this->P[t[2]][a] });
    }
    return box;
  }

  /// Are a triangle's box and this one disjoint?
  bool IsApart(const Triangle& t, const Point3& low, const Point3& high) const
  {
    const auto [lowT, highT] = this->BoxOf(t);
    for (int a = 0; a < 3; ++a)
    {
      if (high[a] < lowT[a] || highT[a] < low[a])
      {
        return true;
      }
    }
    return false;
  }

  /// Lets Crosses know where a triangle is now.
  void Register(int t)
  {
    if (this->Grid && this->T[t][0] >= 0)
    {
      const auto [low, high] = this->BoxOf(this->T[t]);
      this->Grid->Put(t, low, high);
    }
  }

  void RegisterAround(int v)
  {
    for (const int t : this->Around[v])
    {
      this->Register(t);
    }
  }

  static bool Has(const Triangle& t, int v) { return t[0] == v || t[1] == v || t[2] == v; }

  static int Third(const Triangle& t, int u, int v)
  {
    for (const int w : t)
    {
      if (w != u && w != v)
      {
        return w;
      }
    }
    return -1;
  }

  static bool Follows(const Triangle& t, int u, int v)
  {
    return (t[0] == u && t[1] == v) || (t[1] == u && t[2] == v) || (t[2] == u && t[0] == v);
  }

  Vector3 AreaNormal(const Triangle& t) const
  {
    return Cross(this->P[t[1]] - this->P[t[0]], this->P[t[2]] - this->P[t[0]]);
  }

  /// Two triangles that share an edge must not fold back onto one another.
  bool Agree(const Triangle& s, const Triangle& t) const
  {
    return Dot(this->AreaNormal(s), this->AreaNormal(t)) > 0;
  }

  /// Does a triangle keep its direction? A needle has none.
  bool KeepsItself(const Triangle& before, const Triangle& after) const
  {
    return this->IsNeedle(before) ||
      this->SameWay(this->AreaNormal(before), this->AreaNormal(after));
  }

  bool IsNeedle(const Triangle& t) const { return this->AngleOf(t) < SliverAngle * Pi / 180; }

  static bool SameWay(const Vector3& m, const Vector3& n)
  {
    return Dot(m, n) > LeastOwnAgreement * Norm(m) * Norm(n);
  }

  bool MayReplace(
    const std::vector<int>& before, const std::array<Triangle, 2>& after, double agreement) const
  {
    if (agreement > OwnAgreement)
    {
      return true;
    }
    bool all = true;
    bool any = false;
    for (const int t : before)
    {
      any = any || !this->IsNeedle(this->T[t]);
      all =
        all && this->KeepsItself(this->T[t], after[0]) && this->KeepsItself(this->T[t], after[1]);
    }
    return all && any;
  }

  bool LinkAllows(int u, int v) const
  {
    const std::vector<int> shared = this->TrianglesAt(u, v);
    if (shared.empty() || shared.size() > 2)
    {
      return false;
    }
    // Two border vertices across an inner edge: the border would be pinched.
    if (shared.size() == 2 && this->Border[u] && this->Border[v])
    {
      return false;
    }
    const std::vector<int> nu = this->Neighbours(u);
    const std::vector<int> nv = this->Neighbours(v);
    std::vector<int> common;
    std::set_intersection(nu.begin(), nu.end(), nv.begin(), nv.end(), std::back_inserter(common));
    if (common.size() != shared.size())
    {
      return false;
    }
    for (const int w : common)
    {
      if (this->Around[w].size() < (this->Border[w] ? 2u : 4u))
      {
        return false;
      }
    }
    return true;
  }

  /// The least angle that u's triangles would have with v in its place; <= 0 where that may not be.
  double QualityOfCollapse(int u, int v, double agreement) const
  {
    if (this->Pinned[u] || (this->Border[u] && !this->Border[v]) ||
      (this->Border[u] && this->TrianglesAt(u, v).size() != 1))
    {
      return -1;
    }
    double least = Pi;
    for (const int t : this->Around[u])
    {
      Triangle moved = this->T[t];
      if (Has(moved, v))
      {
        continue;
      }
      std::replace(moved.begin(), moved.end(), u, v);
      if (!this->Agrees(moved, agreement) ||
        this->LongestEdge(moved) >
          std::max(LongEdge * this->EdgeLength, LongerAgain * this->LongestEdge(this->T[t])) ||
        (agreement <= OwnAgreement && !this->KeepsItself(this->T[t], moved)))
      {
        return -1;
      }
      least = std::min(least, this->AngleOf(moved));
    }
    // Not worse than what is there, unless that is good anyway.
    const double before = this->QualityAround(u, -2);
    return least > std::min(before, 0.25) ? least : -1;
  }

  double LongestEdge(const Triangle& t) const
  {
    return std::max({ Norm(this->P[t[1]] - this->P[t[0]]), Norm(this->P[t[2]] - this->P[t[1]]),
      Norm(this->P[t[0]] - this->P[t[2]]) });
  }

  void Detach(int t)
  {
    for (const int v : this->T[t])
    {
      auto& list = this->Around[v];
      list.erase(std::find(list.begin(), list.end(), t));
    }
  }

  void Replace(int t, const Triangle& by)
  {
    this->Detach(t);
    this->T[t] = by;
    for (const int v : by)
    {
      this->Around[v].push_back(t);
    }
    this->Register(t);
  }

  /// u's triangles become v's, those on the edge go.
  void Merge(int u, int v)
  {
    const std::vector<int> all = this->Around[u];
    for (const int t : all)
    {
      if (Has(this->T[t], v))
      {
        this->Detach(t);
        this->T[t] = { -1, -1, -1 };
        continue;
      }
      Triangle moved = this->T[t];
      std::replace(moved.begin(), moved.end(), u, v);
      this->Replace(t, moved);
    }
  }

  const TriangleMesh& Mesh; ///< P and T
  const std::vector<char>& Thin;
  double EdgeLength;
  std::unique_ptr<TriangleGrid> Grid; ///< made when it is first needed
};

void CollapseShortEdges(Editor& editor, double limit)
{
  for (int pass = 0; pass < 4; ++pass)
  {
    std::size_t collapsed = 0;
    for (const auto& [u, v] : editor.EdgesShorterThan(limit))
    {
      const Vector3 edge = editor.P[v] - editor.P[u];
      // A neighbour may have gone, or have been replaced, since the list was made.
      if (Norm(edge) < limit && editor.Collapse(u, v, LeastAgreement))
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

void FlipEdges(Editor& editor)
{
  for (int pass = 0; pass < 6; ++pass)
  {
    std::size_t flipped = 0;
    for (std::size_t t = 0; t < editor.T.size(); ++t)
    {
      for (int k = 0; k < 3 && editor.T[t][0] >= 0; ++k)
      {
        const int u = editor.T[t][k];
        const int v = editor.T[t][(k + 1) % 3];
        flipped += editor.Flip(u, v, LeastAgreement) ? 1 : 0;
      }
    }
    if (flipped == 0)
    {
      return;
    }
  }
}

/// Where a vertex would like to be: the mean of its neighbours, in its tangent plane.
Point3 Relaxed(const Editor& editor, int v)
{
  const std::vector<int> around = editor.Neighbours(v);
  Point3 mean{ 0, 0, 0 };
  for (const int w : around)
  {
    mean = mean + editor.P[w];
  }
  const Vector3 move = (1.0 / static_cast<double>(around.size())) * mean - editor.P[v];
  const Vector3& n = editor.N[v];
  return editor.P[v] + (move - Dot(move, n) * n);
}

void Spread(Editor& editor, const Projector& project)
{
  std::vector<int> vertices;
  std::vector<Point3> points;
  for (int v = 0; v < static_cast<int>(editor.P.size()); ++v)
  {
    if (!editor.Around[v].empty() && !editor.Border[v] && !editor.Pinned[v])
    {
      vertices.push_back(v);
      points.push_back(Relaxed(editor, v));
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
    const Point3 oldPoint = editor.P[v];
    const Vector3 oldNormal = editor.N[v];
    const double before = editor.QualityAround(v, LeastAgreement);
    editor.P[v] = points[i];
    editor.N[v] = normals[i];
    const double after = editor.QualityAround(v, LeastAgreement);
    editor.P[v] = oldPoint;
    editor.N[v] = oldNormal;
    if (after > std::min(before, 0.4))
    {
      editor.Move(v, points[i], normals[i]);
    }
  }
}

/// One try at each sliver: the diagonal across it, or its shortest edge away.
std::size_t MendSlivers(Editor& editor, double angle, double agreement)
{
  std::size_t mended = 0;
  for (std::size_t t = 0; t < editor.T.size(); ++t)
  {
    if (editor.T[t][0] < 0 || editor.AngleOf(editor.T[t]) >= angle)
    {
      continue;
    }
    std::array<std::tuple<double, int, int>, 3> edges;
    for (int k = 0; k < 3; ++k)
    {
      const int u = editor.T[t][k];
      const int v = editor.T[t][(k + 1) % 3];
      edges[k] = { Norm(editor.P[v] - editor.P[u]), u, v };
    }
    std::sort(edges.begin(), edges.end());
    const auto [longest, a, b] = edges[2];
    bool changed = editor.Flip(a, b, agreement);
    for (int k = 0; k < 3 && !changed; ++k)
    {
      changed = editor.Collapse(std::get<1>(edges[k]), std::get<2>(edges[k]), agreement);
    }
    mended += changed ? 1 : 0;
  }
  return mended;
}

/// Places along the surface that a vertex may be moved to.
struct ShiftedVertices
{
  std::vector<int> Vertices;
  std::vector<Point3> Points;
  std::vector<Vector3> Normals;
  std::vector<char> Done;

  void Add(const Editor& editor, int v, double edgeLength)
  {
    const Vector3& n = editor.N[v];
    const int least = std::abs(n[0]) < std::abs(n[1]) ? (std::abs(n[0]) < std::abs(n[2]) ? 0 : 2)
                                                      : (std::abs(n[1]) < std::abs(n[2]) ? 1 : 2);
    Vector3 axis{ 0, 0, 0 };
    axis[least] = 1;
    const Vector3 u = (1 / Norm(Cross(axis, n))) * Cross(axis, n);
    const Vector3 w = Cross(n, u);
    for (const double shift : Shifts)
    {
      for (int k = 0; k < ShiftDirections; ++k)
      {
        const double angle = 2 * Pi * k / ShiftDirections;
        this->Vertices.push_back(v);
        this->Points.push_back(editor.P[v] + (shift * edgeLength * std::cos(angle)) * u +
          (shift * edgeLength * std::sin(angle)) * w);
      }
    }
  }
};

/// Moves the ends of needles' short edges to where the least angle around them is largest.
std::size_t ShiftNeedles(Editor& editor, const Projector& project, double edgeLength)
{
  ShiftedVertices shifted;
  for (const Triangle& t : editor.T)
  {
    if (t[0] < 0 || editor.AngleOf(t) >= NeedleAngle * Pi / 180)
    {
      continue;
    }
    for (const int v : t)
    {
      if (!editor.Border[v] && !editor.Pinned[v] && Norm(editor.N[v]) > 0.5)
      {
        shifted.Add(editor, v, edgeLength);
      }
    }
  }
  if (shifted.Points.empty())
  {
    return 0;
  }
  project(shifted.Points, shifted.Normals, shifted.Done);
  std::size_t moved = 0;
  const std::size_t many = ShiftDirections * std::size(Shifts);
  for (std::size_t from = 0; from < shifted.Points.size(); from += many)
  {
    const int v = shifted.Vertices[from];
    const double before = editor.QualityAround(v, OwnAgreement);
    if (before >= NeedleAngle * Pi / 180)
    {
      continue;
    }
    std::vector<std::pair<double, std::size_t>> better;
    for (std::size_t i = from; i < from + many; ++i)
    {
      const double quality = shifted.Done[i] ? editor.QualityOfMove(v, shifted.Points[i]) : -1;
      if (quality > before)
      {
        better.emplace_back(-quality, i);
      }
    }
    std::sort(better.begin(), better.end());
    // The best one where nothing crosses.
    moved += std::any_of(better.begin(), better.end(),
               [&](const auto& place)
               {
                 const std::size_t i = place.second;
                 return editor.Move(v, shifted.Points[i], shifted.Normals[i], true);
               })
      ? 1
      : 0;
  }
  return moved;
}

void RemoveSlivers(Editor& editor, const Projector& project, double edgeLength)
{
  for (int pass = 0; pass < MaximumSliverPasses; ++pass)
  {
    const double agreement = pass < MaximumSliverPasses / 2 ? LeastAgreement : LastResortAgreement;
    if (MendSlivers(editor, SliverAngle * Pi / 180, agreement) == 0 && pass > 0)
    {
      break;
    }
    FlipEdges(editor);
    if (pass % 3 == 2)
    {
      Spread(editor, project);
    }
  }
  for (int pass = 0; pass < MaximumSliverPasses; ++pass)
  {
    if (MendSlivers(editor, NeedleAngle * Pi / 180, OwnAgreement) == 0)
    {
      break;
    }
  }
  for (int pass = 0; pass < MaximumShiftPasses; ++pass)
  {
    if (ShiftNeedles(editor, project, edgeLength) == 0)
    {
      break;
    }
    MendSlivers(editor, NeedleAngle * Pi / 180, OwnAgreement);
  }
}

/// Moves the nearest free vertex of each anchor onto it, nearest pairs first.
std::size_t Anchor(Editor& editor, const std::vector<Point3>& anchors, double edgeLength)
{
  const PointGrid grid(editor.P, edgeLength);
  std::vector<std::tuple<double, int, int>> pairs;
  for (int a = 0; a < static_cast<int>(anchors.size()); ++a)
  {
    grid.ForNear(anchors[a], 0.6 * edgeLength,
      [&](int v, double r2)
      {
        if (!editor.Around[v].empty() && !editor.Border[v])
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
    if (placed[a] || editor.Pinned[v])
    {
      continue;
    }
    const Point3 old = editor.P[v];
    const double before = editor.QualityAround(v, LeastAgreement);
    editor.P[v] = anchors[a];
    const double after = editor.QualityAround(v, LeastAgreement);
    editor.P[v] = old;
    if (after > std::min(before * 0.99, LeastAnchoredAngle * Pi / 180) &&
      editor.Move(v, anchors[a], editor.N[v]))
    {
      placed[a] = 1;
      editor.Pinned[v] = 1;
      ++count;
    }
  }
  return count;
}

/// Points near which another sheet of the surface is.
std::vector<char> ThinPlaces(
  const std::vector<Point3>& points, const std::vector<Vector3>& normals, double edgeLength)
{
  const double radius = ThinPlace * edgeLength;
  const PointGrid grid(points, radius);
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

/// Marks the points around triangles of `crossed` that cross. @returns how many pairs do.
std::int64_t MarkCrossings(const TriangleMesh& crossed, const std::vector<Point3>& points,
  double edgeLength, int threads, Monitor& monitor, std::vector<char>& thin)
{
  SelfIntersectionOptions options;
  options.Threads = threads;
  AbortMonitor silent(monitor);
  const SelfIntersections found = FindSelfIntersections(crossed, options, silent);
  if (!found.Any())
  {
    return 0;
  }
  const PointGrid grid(points, edgeLength);
  for (const IntersectingPair& pair : found.Pairs)
  {
    for (const int t : { pair.First, pair.Second })
    {
      if (pair.Kind != IntersectingPair::Touching)
      {
        grid.ForNear(crossed.Points[crossed.Triangles[t][0]], AroundCrossing * edgeLength,
          [&](int v, double) { thin[v] = 1; });
      }
    }
  }
  return found.Crossing + found.Overlapping;
}

CleanUpResult CleanUpOnce(TriangleMesh& mesh, std::vector<Vector3>& normals,
  const Projector& project, const CleanUpOptions& options, const std::vector<char>& thin,
  Monitor& monitor)
{
  Editor editor(mesh, normals, options.EdgeLength, thin);
  for (int round = 0; round < options.Rounds; ++round)
  {
    monitor.Update(static_cast<double>(round) / (options.Rounds + 1), "cleaning up the mesh");
    CollapseShortEdges(editor, ShortEdge * options.EdgeLength);
    FlipEdges(editor);
    Spread(editor, project);
    FlipEdges(editor);
  }
  monitor.Update(
    static_cast<double>(options.Rounds) / (options.Rounds + 1), "cleaning up the mesh");
  RemoveSlivers(editor, project, options.EdgeLength);
  CleanUpResult result;
  if (!options.Anchors.empty())
  {
    result.Anchored = Anchor(editor, options.Anchors, options.EdgeLength);
    FlipEdges(editor);
    Spread(editor, project);
    RemoveSlivers(editor, project, options.EdgeLength);
  }
  editor.Compact();
  result.LeastAngle = LeastAngle(mesh);
  return result;
}
}

CleanUpResult CleanUp(TriangleMesh& mesh, std::vector<Vector3>& normals, const Projector& project,
  const CleanUpOptions& options, Monitor& monitor)
{
  const TriangleMesh given = mesh;
  const std::vector<Vector3> givenNormals = normals;
  std::vector<char> thin = ThinPlaces(given.Points, givenNormals, options.EdgeLength);
  CleanUpResult result;
  for (int attempt = 0; attempt < MaximumAttempts; ++attempt)
  {
    mesh = given;
    normals = givenNormals;
    result = CleanUpOnce(mesh, normals, project, options, thin, monitor);
    result.Crossing =
      MarkCrossings(mesh, given.Points, options.EdgeLength, options.Threads, monitor, thin);
    if (result.Crossing == 0)
    {
      break;
    }
  }
  monitor.Update(1, "cleaning up the mesh");
  return result;
}

double LeastAngle(const TriangleMesh& mesh)
{
  double least = Pi;
  for (const Triangle& t : mesh.Triangles)
  {
    least = std::min(least, LeastAngleOf(mesh.Points[t[0]], mesh.Points[t[1]], mesh.Points[t[2]]));
  }
  return least * 180 / Pi;
}
}
