// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/EvenPasses.h"

#include "Base/Angles.h"
#include "Base/Geometry.h"
#include "Base/Parallel.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
/// Edges longer than this part of their size are split, shorter ones than the other collapsed, and
/// none longer than the third is made by it.
constexpr double LongEdge = 4.0 / 3;
constexpr double ShortEdge = 0.7;
constexpr double LongestMade = 1.6;
/// Cosine that a triangle keeps with the surface's normals at its corners; where a sliver has to go,
/// they are not asked.
constexpr double UsualCosine = 0.4;
constexpr double LeastCosine = -2;
/// Triangles with a smaller angle (its tangent) have no direction to speak of.
constexpr double NeedleTangent = 0.03;
/// Least angles (their tangents) above this need not become larger.
constexpr double GoodTangent = 0.42;
/// Of no triangle's least angle, which is at most 60 degrees.
constexpr double MostTangent = 2;
/// Of the least angle of slivers, below which they are mended: a fifth above FairLeastAngle.
const double SliverTangent = std::tan(FairLeastAngle * 1.2 * Pi / 180);
/// Triangles whose least angle's tangent is above this stay as they are.
constexpr double PerfectTangent = 1;
/// A point that is spread is looked for on the surface within so many edge lengths.
constexpr double Reach = 1;
/// A corner of a sliver is shifted by the first of these parts of an edge's length at most, or by one of the halves
/// of it; in so many directions.
constexpr double FarthestShift = 0.4;
constexpr int ShiftLengths = 4;
constexpr int ShiftDirections = 8;
constexpr int MostPasses = 6;
constexpr std::size_t PointsABlock = 1024;

}

EvenPasses::EvenPasses(const TriangleMesh& mesh, const std::vector<char>& parts,
  const SurfacePlaces* surface, const PlacesToKeep& keep, double edgeLength, int threads,
  Monitor& monitor)
  : Mesh(mesh, parts),
    Normals(PointNormals(mesh)),
    Thin(mesh.Points.size(), 0),
    Watch(Mesh, edgeLength),
    Kept(Mesh, keep, threads, monitor),
    Home(mesh.Points.size(), -1),
    Surface(surface),
    EdgeLength(edgeLength),
    Threads(threads),
    Observer(monitor)
{
}

/// The least cosine with the surface's normals at the corners.
double EvenPasses::AgreementOf(const Triangle& t) const
{
  const Vector3 n = this->Mesh.AreaNormal(t);
  const double length = Norm(n);
  return length > 0 ? std::min({ Dot(n, this->Normals[t[0]]), Dot(n, this->Normals[t[1]]),
                        Dot(n, this->Normals[t[2]]) }) /
      length
                    : -1;
}

/// What new triangles have to agree with: as much as usual, or as those that they come from do; of
/// these needles have no direction.
double EvenPasses::AgreementWanted(const std::vector<int>& before, double cosine) const
{
  double wanted = cosine;
  for (const int t : before)
  {
    const Triangle& corners = this->Mesh.Triangles[t];
    if (this->Mesh.LeastTangent(t) > NeedleTangent)
    {
      wanted = std::min(wanted, this->AgreementOf(corners));
    }
  }
  return wanted;
}

/// From a triangle to the one beside it with a longer longest side, as long as there is one: halving
/// that of the last makes no thin triangles.
int EvenPasses::TerminalOf(int t) const
{
  // Lengths rise, so it ends.
  while (true)
  {
    const int k = this->Mesh.LongestSide(t);
    const int across = this->Mesh.Neighbour[t][k];
    if (across < 0 ||
      !(this->Mesh.SideLength(across, this->Mesh.LongestSide(across)) >
        this->Mesh.SideLength(t, k)))
    {
      return t;
    }
    t = across;
  }
}

void EvenPasses::SplitLong()
{
  // Each split halves an edge that is longer than a bound, so that they come to an end; the list
  // grows meanwhile.
  for (int t = 0; t < static_cast<int>(this->Mesh.Triangles.size()); ++t)
  {
    while (this->Mesh.IsAlive(t))
    {
      const int own = this->Mesh.LongestSide(t);
      const auto ends = [&](int s, int k)
      {
        return std::make_pair(
          this->Mesh.Triangles[s][(k + 1) % 3], this->Mesh.Triangles[s][(k + 2) % 3]);
      };
      if (this->Mesh.SideLength(t, own) <= LongEdge * this->EdgeLength)
      {
        break;
      }
      const int terminal = this->TerminalOf(t);
      const int k = this->Mesh.LongestSide(terminal);
      const auto [a, b] = ends(terminal, k);
      const Vector3 sum = this->Normals[a] + this->Normals[b];
      const double length = Norm(sum);
      this->Mesh.Split(terminal, k);
      this->Normals.push_back(length > 0 ? (1 / length) * sum : this->Normals[a]);
      this->Thin.push_back(this->Thin[a] || this->Thin[b] ? 1 : 0);
      this->Home.push_back(std::max(this->Home[a], this->Home[b]));
      const std::vector<int> cut =
        this->Mesh.Around(static_cast<int>(this->Mesh.Points.size()) - 1);
      this->Watch.Register(cut);
      this->Kept.TakeCut(cut);
    }
  }
}

/// The tangent of the triangles' least angle, negative where one has turned against the surface.
double EvenPasses::QualityOf(const std::vector<int>& triangles) const
{
  double least = MostTangent;
  for (const int t : triangles)
  {
    const Triangle& corners = this->Mesh.Triangles[t];
    if (!(this->AgreementOf(corners) >= UsualCosine))
    {
      return -1;
    }
    least = std::min(least, this->Mesh.LeastTangent(t));
  }
  return least;
}

/// The tangent of the least angle that the triangles around a point would have in the other's place; negative where
/// that may not be.
double EvenPasses::QualityOfCollapse(int from, int into, double cosine) const
{
  double before = MostTangent;
  double after = MostTangent;
  int slivers = 0; // fewer
  const std::vector<int> around = this->Mesh.Around(from);
  const double wanted = this->AgreementWanted(around, cosine);
  for (const int t : around)
  {
    Triangle moved = this->Mesh.Triangles[t];
    before = std::min(before, this->Mesh.LeastTangent(t));
    slivers += this->Mesh.LeastTangent(t) < SliverTangent ? 1 : 0;
    if (this->Mesh.CornerOf(t, into) >= 0)
    {
      continue;
    }
    double longest = this->Mesh.SideLength(t, this->Mesh.LongestSide(t));
    std::replace(moved.begin(), moved.end(), from, into);
    for (const int v : moved)
    {
      if (v != into)
      {
        const double length = Norm(this->Mesh.Points[v] - this->Mesh.Points[into]);
        if (length > std::max(LongestMade * this->EdgeLength, 1.01 * longest))
        {
          return -1;
        }
      }
    }
    if (!(this->AgreementOf(moved) >= wanted))
    {
      return -1;
    }
    after = std::min(after, this->Mesh.LeastTangent(moved));
    slivers -= this->Mesh.LeastTangent(moved) < SliverTangent ? 1 : 0;
  }
  // Of a cluster of slivers some may stay for the next.
  const bool isFewer = cosine < UsualCosine && slivers > 0 && after > 0.5 * before;
  return isFewer || after > std::min(before, 0.5 * GoodTangent) ? after : -1;
}

std::vector<KeptPlaces::Change> EvenPasses::AfterCollapse(
  const std::vector<int>& around, int from, int into) const
{
  std::vector<KeptPlaces::Change> after;
  for (const int t : around)
  {
    if (this->Mesh.CornerOf(t, into) < 0)
    {
      Triangle moved = this->Mesh.Triangles[t];
      std::replace(moved.begin(), moved.end(), from, into);
      after.emplace_back(t, moved);
    }
  }
  return after;
}

bool EvenPasses::Collapse(int u, int v, double cosine)
{
  const double intoV = this->Mesh.MayCollapse(u, v) ? this->QualityOfCollapse(u, v, cosine) : -1;
  const double intoU = this->Mesh.MayCollapse(v, u) ? this->QualityOfCollapse(v, u, cosine) : -1;
  if (std::max(intoV, intoU) <= 0)
  {
    return false;
  }
  const int from = intoV >= intoU ? u : v;
  const int into = from == u ? v : u;
  const std::vector<int> around = this->Mesh.Around(from);
  if (!this->Kept.MayChange(around, this->AfterCollapse(around, from, into)))
  {
    return false;
  }
  const bool look =
    cosine < UsualCosine || this->AnyThin(around) || this->AgreementWanted(around, cosine) < cosine;
  const auto way = look ? this->Watch.WayOf(around, from, this->Mesh.Points[into])
                        : std::vector<CrossingWatch::Tetrahedron>();
  if (look && this->Watch.TurnsPiece(around, from, this->Mesh.Points[into]))
  {
    return false;
  }
  const LinkedMesh::Memory memory = look ? this->Mesh.Remember(around) : LinkedMesh::Memory();
  this->Mesh.Collapse(from, into);
  if (look && (this->Watch.AnyCrosses(around) || this->Watch.AnyPointWithin(way)))
  {
    this->Mesh.PutBack(memory);
    return false;
  }
  this->Watch.Register(around);
  this->Kept.Commit();
  return true;
}

void EvenPasses::CollapseShort()
{
  for (int pass = 0; pass < MostPasses; ++pass)
  {
    std::vector<std::tuple<double, int, int>> edges;
    for (const Triangle& t : this->Mesh.Triangles)
    {
      for (int k = 0; k < 3 && t[0] >= 0; ++k)
      {
        const int u = t[k];
        const int v = t[(k + 1) % 3];
        const double length = Norm(this->Mesh.Points[u] - this->Mesh.Points[v]);
        if (u < v && length < ShortEdge * this->EdgeLength)
        {
          edges.emplace_back(length, u, v);
        }
      }
    }
    std::sort(edges.begin(), edges.end());
    std::size_t collapsed = 0;
    for (const auto& [length, u, v] : edges)
    {
      collapsed += this->Mesh.Find(u, v).first >= 0 && this->Collapse(u, v, UsualCosine) ? 1 : 0;
    }
    this->Observer.Update(0, "making the mesh even");
    if (20 * collapsed <= edges.size())
    {
      return;
    }
  }
}

bool EvenPasses::FlipIfBetter(int t, int k, double cosine)
{
  const int across = this->Mesh.Neighbour[t][k];
  if (across < 0)
  {
    return false;
  }
  const Triangle& these = this->Mesh.Triangles[t];
  const Triangle& those = this->Mesh.Triangles[across];
  const double before = std::min(this->Mesh.LeastTangent(t), this->Mesh.LeastTangent(across));
  if (before >= PerfectTangent)
  {
    return false;
  }
  const int a = these[k];
  const int b = these[(k + 1) % 3];
  const int c = these[(k + 2) % 3];
  const int d = those[3 - this->Mesh.CornerOf(across, b) - this->Mesh.CornerOf(across, c)];
  const Triangle one{ a, b, d };
  const Triangle other{ a, d, c };
  if (!(std::min(this->Mesh.LeastTangent(one), this->Mesh.LeastTangent(other)) >
        1.0001 * before + 1e-9))
  {
    return false;
  }
  const double wanted = this->AgreementWanted({ t, across }, cosine);
  if (!(std::min(this->AgreementOf(one), this->AgreementOf(other)) >= wanted) ||
    Norm(this->Mesh.Points[a] - this->Mesh.Points[d]) >
      std::max(LongestMade * this->EdgeLength, this->Mesh.SideLength(t, k)) ||
    !(Dot(this->Mesh.AreaNormal(one), this->Mesh.AreaNormal(other)) > 0) ||
    !this->Mesh.MayFlip(t, k) ||
    !this->Kept.MayChange({ t, across }, { { t, one }, { across, other } }))
  {
    return false;
  }
  const bool look = wanted < UsualCosine || this->AnyThin({ t, across });
  const LinkedMesh::Memory memory =
    look ? this->Mesh.Remember({ t, across }) : LinkedMesh::Memory();
  const auto& points = this->Mesh.Points;
  const CrossingWatch::Tetrahedron between{ points[a], points[b], points[c], points[d] };
  this->Mesh.Flip(t, k);
  if (look && (this->Watch.AnyCrosses({ t, across }) || this->Watch.AnyPointWithin({ between })))
  {
    this->Mesh.PutBack(memory);
    return false;
  }
  this->Watch.Register(t);
  this->Watch.Register(across);
  this->Kept.Commit();
  return true;
}

bool EvenPasses::AnyThin(const std::vector<int>& triangles) const
{
  return std::any_of(triangles.begin(), triangles.end(),
    [this](int t)
    {
      const Triangle& corners = this->Mesh.Triangles[t];
      return this->Thin[corners[0]] || this->Thin[corners[1]] || this->Thin[corners[2]];
    });
}

void EvenPasses::Flip()
{
  const int count = static_cast<int>(this->Mesh.Triangles.size());
  std::vector<char> changed(count, 1);
  std::vector<int> next(count);
  std::vector<int> list;
  for (int t = 0; t < count; ++t)
  {
    list.push_back(t);
  }
  // In passes over what has changed in the one before.
  for (int pass = 0; pass < MostPasses && !list.empty(); ++pass)
  {
    next.clear();
    std::fill(changed.begin(), changed.end(), 0);
    for (const int t : list)
    {
      for (int k = 0; k < 3 && this->Mesh.IsAlive(t); ++k)
      {
        const int across = this->Mesh.Neighbour[t][k];
        if (!this->FlipIfBetter(t, k, UsualCosine))
        {
          continue;
        }
        for (const int s : { t, across })
        {
          if (!changed[s])
          {
            changed[s] = 1;
            next.push_back(s);
          }
        }
      }
    }
    std::sort(next.begin(), next.end());
    list = next;
    this->Observer.Update(0, "making the mesh even");
  }
}

/// The middle of the points around one, in its tangent plane.
Point3 EvenPasses::Middle(int v) const
{
  const std::vector<int>& around = this->Mesh.Around(v);
  Point3 mean{ 0, 0, 0 };
  for (const int t : around)
  {
    // Closed around: each neighbour comes after the point in one of its triangles.
    mean = mean + this->Mesh.Points[this->Mesh.Triangles[t][(this->Mesh.CornerOf(t, v) + 1) % 3]];
  }
  const Vector3 move = (1.0 / static_cast<double>(around.size())) * mean - this->Mesh.Points[v];
  const Vector3& n = this->Normals[v];
  return this->Mesh.Points[v] + (move - Dot(move, n) * n);
}

void EvenPasses::Spread()
{
  const std::size_t count = this->Mesh.Points.size();
  std::vector<Point3> places(count);
  std::vector<Vector3> normals(count);
  std::vector<char> found(count, 0);
  std::vector<Point3> middles(count);
  for (std::size_t v = 0; v < count; ++v)
  {
    const int number = static_cast<int>(v);
    found[v] =
      this->Mesh.IsAlivePoint(number) && !this->Mesh.OnBorder[v] && !this->Mesh.IsOnCrease(number);
    middles[v] = found[v] ? this->Middle(number) : this->Mesh.Points[v];
  }
  ParallelForBlocks(count, PointsABlock, this->Threads,
    [&](std::size_t from, std::size_t to)
    {
      for (std::size_t v = from; v < to; ++v)
      {
        const SurfacePlace place = found[v] ? this->Surface->Nearest(middles[v], this->Normals[v],
                                                Reach * this->EdgeLength, this->Home[v])
                                            : SurfacePlace();
        found[v] = place.Triangle >= 0;
        if (found[v])
        {
          this->Home[v] = place.Triangle;
          places[v] = place.On(this->Surface->Mesh);
          normals[v] = this->Surface->NormalAt(place);
        }
      }
    },
    this->Observer, { 0, 0, "making the mesh even" });
  for (std::size_t v = 0; v < count; ++v)
  {
    if (found[v])
    {
      this->Place(static_cast<int>(v), places[v], normals[v]);
    }
  }
}

/// Moves a point where isWell(triangles around) then, and nothing is crossed or lost. @returns whether it did
template <typename Test>
bool EvenPasses::Put(int v, Point3& place, Vector3& normal, const Test& isWell)
{
  const std::vector<int> around = this->Mesh.Around(v);
  const bool look = this->AnyThin(around);
  const auto way =
    look ? this->Watch.WayOf(around, v, place) : std::vector<CrossingWatch::Tetrahedron>();
  if (look && this->Watch.TurnsPiece(around, v, place))
  {
    return false;
  }
  const auto exchange = [&]
  {
    std::swap(this->Mesh.Points[v], place);
    std::swap(this->Normals[v], normal);
    this->Mesh.Forget(around);
  };
  exchange();
  std::vector<KeptPlaces::Change> after;
  for (const int t : around)
  {
    after.emplace_back(t, this->Mesh.Triangles[t]);
  }
  const bool isMoved = isWell(around) && this->Kept.MayChange(around, after) &&
    !(look && (this->Watch.AnyCrosses(around) || this->Watch.AnyPointWithin(way)));
  if (isMoved)
  {
    this->Kept.Commit();
  }
  else
  {
    exchange();
  }
  this->Watch.Register(around);
  return isMoved;
}

/// Moves a point, unless that makes things worse. @returns whether it did
bool EvenPasses::Place(int v, Point3& place, Vector3& normal)
{
  const double before = this->QualityOf(this->Mesh.Around(v));
  return this->Put(v, place, normal,
    [&](const std::vector<int>& around)
    { return this->QualityOf(around) > std::min(before, GoodTangent); });
}

/// More is better: first by how many are slivers, then by the least angle.
double EvenPasses::AngleScore(const std::vector<int>& triangles) const
{
  double least = MostTangent;
  double slivers = 0;
  for (const int t : triangles)
  {
    least = std::min(least, this->Mesh.LeastTangent(t));
    slivers += this->Mesh.LeastTangent(t) < SliverTangent ? 1 : 0;
  }
  return least / (2 * MostTangent) - slivers;
}

/// Of a sliver that neither flips nor collapses: a corner to the place beside it, along the surface, where
/// the triangles at it have larger angles.
bool EvenPasses::Shift(int t)
{
  std::vector<std::tuple<double, int, Point3>> shifts;
  for (const int v : Triangle(this->Mesh.Triangles[t]))
  {
    if (this->Mesh.OnBorder[v] || this->Mesh.IsOnCrease(v))
    {
      continue;
    }
    const std::vector<int> around = this->Mesh.Around(v);
    const double before = this->AngleScore(around);
    const PlanarFrame frame = PlanarFrame::About(this->Normals[v]);
    const Point3 here = this->Mesh.Points[v];
    double length = FarthestShift * this->EdgeLength;
    for (int shift = 0; shift < ShiftLengths * ShiftDirections; ++shift)
    {
      const double angle = 2 * Pi * shift / ShiftDirections;
      this->Mesh.Points[v] =
        here + ((length * std::cos(angle)) * frame.U + (length * std::sin(angle)) * frame.V);
      this->Mesh.Forget(around);
      const double after = this->AngleScore(around);
      if (after > before)
      {
        shifts.emplace_back(after, v, this->Mesh.Points[v]);
      }
      length *= (shift + 1) % ShiftDirections == 0 ? 0.5 : 1;
    }
    this->Mesh.Points[v] = here;
    this->Mesh.Forget(around);
  }
  std::sort(shifts.begin(), shifts.end(), std::greater<>());
  return std::any_of(shifts.begin(), shifts.end(),
    [&](const auto& shift)
    {
      const int v = std::get<1>(shift);
      Point3 place = std::get<2>(shift);
      Vector3 normal = this->Normals[v];
      return this->Put(v, place, normal, [](const std::vector<int>&) { return true; });
    });
}

bool EvenPasses::Mend(int t, double cosine)
{
  if (this->FlipIfBetter(t, this->Mesh.LongestSide(t), cosine))
  {
    return true;
  }
  std::array<std::pair<double, int>, 3> sides;
  for (int k = 0; k < 3; ++k)
  {
    sides[k] = { this->Mesh.SideLength(t, k), k };
  }
  std::sort(sides.begin(), sides.end());
  const Triangle corners = this->Mesh.Triangles[t];
  return std::any_of(sides.begin(), sides.end(),
           [&](const auto& side)
           {
             return this->Collapse(
               corners[(side.second + 1) % 3], corners[(side.second + 2) % 3], cosine);
           }) ||
    (cosine < UsualCosine && this->Shift(t));
}

void EvenPasses::MendSlivers()
{
  for (int pass = 0; pass < MostPasses; ++pass)
  {
    std::size_t mended = 0;
    const double cosine = 2 * pass < MostPasses ? UsualCosine : LeastCosine;
    for (int t = 0; t < static_cast<int>(this->Mesh.Triangles.size()); ++t)
    {
      if (this->Mesh.IsAlive(t) && this->Mesh.LeastTangent(t) < SliverTangent)
      {
        mended += this->Mend(t, cosine) ? 1 : 0;
      }
    }
    if (mended == 0 && 2 * pass >= MostPasses)
    {
      return;
    }
  }
}
}
