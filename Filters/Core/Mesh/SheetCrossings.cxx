// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SheetCrossings.h"

#include "Base/Predicates.h"
#include "Mesh/MeshTopology.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
std::pair<int, int> Ordered(int a, int b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// A side of a triangle: its ends by coordinates (welded index), then by index, smaller first.
struct Side
{
  std::pair<int, int> Place;
  std::pair<int, int> Index;
  int Triangle;
  int Opposite; ///< the third corner, welded index

  bool operator<(const Side& other) const
  {
    return std::tie(this->Place, this->Index, this->Triangle) <
      std::tie(other.Place, other.Index, other.Triangle);
  }
};

/// Places that several points of the mesh share; elsewhere connectivity by place is that by index.
std::vector<bool> FindSharedPlaces(const TriangleMesh& mesh, const TriangleMesh& welded)
{
  std::vector<int> pointOfPlace(welded.Points.size(), -1);
  std::vector<bool> shared(welded.Points.size(), false);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int place = welded.Triangles[t][k];
      const int point = mesh.Triangles[t][k];
      shared[place] = shared[place] || (pointOfPlace[place] >= 0 && pointOfPlace[place] != point);
      pointOfPlace[place] = point;
    }
  }
  return shared;
}

std::vector<Side> CollectSides(const TriangleMesh& mesh, const TriangleMesh& welded)
{
  const auto shared = FindSharedPlaces(mesh, welded);
  std::vector<Side> sides;
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const auto& places = welded.Triangles[t];
    const bool flat =
      Collinear(welded.Points[places[0]], welded.Points[places[1]], welded.Points[places[2]]);
    for (int k = 0; k < 3 && !flat; ++k)
    {
      const int next = (k + 1) % 3;
      if (shared[places[k]] || shared[places[next]])
      {
        sides.push_back({ Ordered(places[k], places[next]),
          Ordered(mesh.Triangles[t][k], mesh.Triangles[t][next]), static_cast<int>(t),
          places[(k + 2) % 3] });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

/// Directions around an edge, in the order of their angle from the first of them.
class Fan
{
public:
  Fan(const Point3& from, const Point3& to, const Point3& first) : From(from), To(to), First(first)
  {
  }

  /// Smaller angle, in [0, 2 pi); exact.
  bool Before(const Point3& a, const Point3& b) const
  {
    const int halfA = this->HalfOf(a);
    const int halfB = this->HalfOf(b);
    return halfA != halfB ? halfA < halfB : Orientation3(this->From, this->To, a, b) > 0;
  }

private:
  /// 0: along the first, 1: less than half a turn on, 2: half a turn, 3: more.
  int HalfOf(const Point3& p) const
  {
    const int side = Orientation3(this->From, this->To, this->First, p);
    if (side != 0)
    {
      return side > 0 ? 1 : 3;
    }
    return this->OnTheSideOfFirst(p) ? 0 : 2;
  }

  /// p is in the plane of the edge and the first.
  bool OnTheSideOfFirst(const Point3& p) const
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto flat = [axis](const Point3& x) {
        return Point2{ x[(axis + 1) % 3], x[(axis + 2) % 3] };
      };
      const int first = Orientation2(flat(this->From), flat(this->To), flat(this->First));
      if (first != 0)
      {
        return Orientation2(flat(this->From), flat(this->To), flat(p)) == first;
      }
    }
    return false; // not reached: the first triangle has an area
  }

  const Point3& From;
  const Point3& To;
  const Point3& First;
};

/// Ranks around the edge of the two triangles of a sheet; equal directions have equal ranks.
using Chord = std::pair<int, int>;

bool Interleave(const Chord& a, const Chord& b)
{
  const auto between = [&a](int rank) { return rank > a.first && rank < a.second; };
  const auto beyond = [&a](int rank) { return rank < a.first || rank > a.second; };
  return (between(b.first) && beyond(b.second)) || (between(b.second) && beyond(b.first));
}

std::vector<int> RankAround(const TriangleMesh& welded, const Side* begin, const Side* end)
{
  const Fan fan(welded.Points[begin->Place.first], welded.Points[begin->Place.second],
    welded.Points[begin->Opposite]);
  const auto before = [&](int i, int j)
  { return fan.Before(welded.Points[begin[i].Opposite], welded.Points[begin[j].Opposite]); };
  std::vector<int> order(end - begin);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = static_cast<int>(i);
  }
  std::sort(order.begin(), order.end(), before);
  std::vector<int> rank(order.size(), 0);
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    rank[order[i]] = rank[order[i - 1]] + (before(order[i - 1], order[i]) ? 1 : 0);
  }
  return rank;
}

bool SheetsCross(const TriangleMesh& welded, const Side* begin, const Side* end)
{
  const auto rank = RankAround(welded, begin, end);
  std::vector<Chord> chords;
  for (const Side* side = begin; side != end;)
  {
    const Side* next = side;
    while (next != end && next->Index == side->Index)
    {
      ++next;
    }
    if (next - side == 2)
    {
      chords.push_back(Ordered(rank[side - begin], rank[side - begin + 1]));
    }
    side = next;
  }
  for (std::size_t i = 0; i < chords.size(); ++i)
  {
    for (std::size_t j = i + 1; j < chords.size(); ++j)
    {
      if (Interleave(chords[i], chords[j]))
      {
        return true;
      }
    }
  }
  return false;
}
}

SheetCrossings FindSheetCrossings(const TriangleMesh& mesh)
{
  const TriangleMesh welded = WeldPoints(mesh);
  const auto sides = CollectSides(mesh, welded);
  SheetCrossings result;
  for (auto side = sides.begin(); side != sides.end();)
  {
    const auto end = std::find_if(
      side, sides.end(), [&](const Side& other) { return other.Place != side->Place; });
    const Side* const first = &*side;
    const Side* const last = first + (end - side);
    if (last - first > 2 && SheetsCross(welded, first, last))
    {
      std::transform(first, last, std::back_inserter(result.Triangles),
        [&](const Side& s) { return std::make_pair(result.Edges, s.Triangle); });
      ++result.Edges;
    }
    side = end;
  }
  std::sort(result.Triangles.begin(), result.Triangles.end());
  return result;
}
}
