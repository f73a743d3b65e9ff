// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/VertexStars.h"

#include "Base/Parallel.h"
#include "Base/Predicates.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace recon
{
namespace
{
/// Points that one piece of parallel work looks at.
constexpr std::size_t PointsABlock = 1024;
/// Points with more triangles around them are passed over: each is compared with each.
constexpr int MostAround = 32;

/// The triangles at each point, one after the other.
struct Incidence
{
  std::vector<int> First;                ///< a point: place of its first side
  std::vector<std::array<int, 2>> Sides; ///< of a triangle, opposite to the point, counterclockwise

  explicit Incidence(const TriangleMesh& mesh) : First(mesh.Points.size() + 1, 0)
  {
    for (const auto& t : mesh.Triangles)
    {
      for (const int v : t)
      {
        ++this->First[v + 1];
      }
    }
    for (std::size_t v = 1; v < this->First.size(); ++v)
    {
      this->First[v] += this->First[v - 1];
    }
    this->Sides.resize(3 * mesh.Triangles.size());
    std::vector<int> next(this->First.begin(), this->First.end() - 1);
    for (const auto& t : mesh.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Sides[next[t[k]]++] = { t[(k + 1) % 3], t[(k + 2) % 3] };
      }
    }
  }
};

using Side = std::array<int, 2>;

/// Whether each point of the sides is where one of them ends and one begins.
bool IsClosed(const Side* begin, const Side* end)
{
  return std::all_of(begin, end,
    [&](const Side& side)
    {
      return std::count_if(begin, end, [&](const Side& s) { return s[0] == side[1]; }) == 1 &&
        std::count_if(begin, end, [&](const Side& s) { return s[1] == side[1]; }) == 1;
    });
}

bool IsFlat(const std::vector<Point3>& points, int v, const Side* begin, const Side* end)
{
  if (end - begin < 3 || end - begin > MostAround || !IsClosed(begin, end))
  {
    return false;
  }
  Vector3 normal{ 0, 0, 0 };
  std::for_each(begin, end,
    [&](const Side& s)
    { normal = normal + Cross(points[s[0]] - points[v], points[s[1]] - points[v]); });
  int axis = std::abs(normal[1]) > std::abs(normal[0]) ? 1 : 0;
  axis = std::abs(normal[2]) > std::abs(normal[axis]) ? 2 : axis;
  const auto seen = [&](int p) {
    return Point2{ points[p][(axis + 1) % 3], points[p][(axis + 2) % 3] };
  };
  const Point2 middle = seen(v);
  const int turn = normal[axis] > 0 ? 1 : -1;
  const auto isAbove = [&](const Point2& p)
  { return p[1] > middle[1] || (p[1] == middle[1] && p[0] > middle[0]); };
  int rounds = 0;
  for (const Side* s = begin; s != end; ++s)
  {
    const Point2 from = seen((*s)[0]);
    const Point2 to = seen((*s)[1]);
    if (Orientation2(middle, from, to) != turn)
    {
      return false;
    }
    // All turn the same way, each by less than half a round: so each round comes down once.
    rounds += isAbove(from) && !isAbove(to) ? 1 : 0;
  }
  return rounds == 1;
}
}

std::vector<char> FindFlatStars(const TriangleMesh& mesh, int threads, Monitor& monitor)
{
  const Incidence around(mesh);
  std::vector<char> flat(mesh.Points.size(), 0);
  const Side* sides = around.Sides.data();
  ParallelForBlocks(flat.size(), PointsABlock, threads,
    [&](std::size_t from, std::size_t to)
    {
      for (std::size_t v = from; v < to; ++v)
      {
        flat[v] = IsFlat(
          mesh.Points, static_cast<int>(v), sides + around.First[v], sides + around.First[v + 1]);
      }
    },
    monitor, { 0, 0, "looking for self-intersections" });
  return flat;
}
}
