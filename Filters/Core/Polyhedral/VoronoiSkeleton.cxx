// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/VoronoiSkeleton.h"

#include "Base/BoundingBox.h"
#include "Planar/LoopTwins.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>

namespace recon
{
namespace
{
/// Units of the last decimal by which rounding makes a circle stick out: each of the three points
/// that define it, and the larger circle's, is off by sqrt(1/2) of a unit, and it bulges between
/// them by half of that once more.
constexpr double UnitsOfRounding = 2;
/// What sticks out by more of the larger radius is a shape, whatever the decimals.
constexpr double MostOfRadius = 0.05;
/// The same where it sticks into the convex hull, of the diagonal of the level.
constexpr double MostOfDiagonal = 0.01;
/// In the place of a triangle: beyond the convex hull, a circle of infinite radius.
constexpr int BeyondHull = -2;

/// Share of the numbers of a level that may have more decimals than the others.
constexpr double FinerNumbers = 0.05;

std::vector<double> CoordinatesOf(const ContourSet& contours, int level, std::size_t axis)
{
  std::vector<double> numbers;
  for (int c : contours.Levels[level].Contours)
  {
    for (int p : contours.Contours[c].Points)
    {
      numbers.push_back(contours.Points[p][axis]);
    }
  }
  return numbers;
}

struct Circle
{
  Point2 Centre{};
  double Radius = 0; ///< 0: has no place in the skeleton
};

/**
 * Circles as trees: each hangs on the larger neighbour that it sticks out of least, and where two
 * trees meet the smaller root hangs on the larger one. At an edge of the convex hull a circle of ER
 * may hang on the half plane beyond, so that shallow bays are rounding, too. A branch is rounding
 * where all of it sticks out of what it hangs on by no more.
 *
 * Added up along a branch, what each circle sticks out of the one before is at least what the last
 * sticks out of the first, and the same where the branch is straight.
 */
class Pruning
{
public:
  Pruning(const LevelTriangulation& level, bool inside, double unit)
    : Level(level),
      Rounding(UnitsOfRounding * unit),
      Circles(level.Triangles.size()),
      Parent(level.Triangles.size(), -1),
      Root(level.Triangles.size(), -1)
  {
    Box2 box;
    for (const Point2& p : level.Points)
    {
      box.Add(p);
    }
    this->Diagonal = box.Diagonal();
    for (std::size_t t = 0; t < this->Circles.size(); ++t)
    {
      const Point2 centre = level.VoronoiVertex(static_cast<int>(t));
      if ((level.Inside[t] != 0) == inside && std::isfinite(centre[0]) && std::isfinite(centre[1]))
      {
        this->Circles[t] = { centre, Distance(centre, level.Points[level.Triangles[t][0]]) };
      }
    }
  }

  std::vector<unsigned char> Find()
  {
    const std::vector<int> order = this->FromTheLargest();
    for (int t : order)
    {
      this->Hang(t);
    }
    const std::vector<double> reach = this->ReachOfBranches(order);
    std::vector<unsigned char> stays(this->Circles.size(), 0);
    for (int t : order)
    {
      const int parent = this->Parent[t];
      const bool isRounding = parent != -1 && reach[t] < this->MostRounding(parent);
      stays[t] = !isRounding && (parent < 0 || stays[parent]) ? 1 : 0;
    }
    return stays;
  }

private:
  std::vector<int> FromTheLargest() const
  {
    std::vector<int> order;
    for (std::size_t t = 0; t < this->Circles.size(); ++t)
    {
      if (this->Circles[t].Radius > 0)
      {
        order.push_back(static_cast<int>(t));
      }
    }
    std::sort(order.begin(), order.end(), [&](int a, int b) { return this->ComesBefore(a, b); });
    return order;
  }

  /// Larger, or equal with a smaller number.
  bool ComesBefore(int a, int b) const
  {
    const double radiusA = this->Circles[a].Radius;
    const double radiusB = this->Circles[b].Radius;
    return radiusA != radiusB ? radiusA > radiusB : a < b;
  }

  int RootOf(int t)
  {
    while (this->Root[t] != t)
    {
      this->Root[t] = this->Root[this->Root[t]];
      t = this->Root[t];
    }
    return t;
  }

  /// By how much the circle of t sticks out of that of another one.
  double SticksOut(int t, int other) const
  {
    if (other == BeyondHull)
    {
      return this->SticksIntoHull(t);
    }
    const Circle& a = this->Circles[t];
    const Circle& b = this->Circles[other];
    return std::max(0.0, Distance(a.Centre, b.Centre) + a.Radius - b.Radius);
  }

  /// Beyond the edge of the hull that triangle t has; infinite where it has none.
  double SticksIntoHull(int t) const
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (this->Level.Neighbours[t][k] < 0 && !this->Level.Inside[t])
      {
        const Point2& a = this->Level.Points[this->Level.Triangles[t][(k + 1) % 3]];
        const Point2& b = this->Level.Points[this->Level.Triangles[t][(k + 2) % 3]];
        const Point2& c = this->Circles[t].Centre;
        const double inwards = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        least = std::min(least, this->Circles[t].Radius + inwards / Distance(a, b));
      }
    }
    return least;
  }

  /// All larger circles hang already.
  void Hang(int t)
  {
    this->Root[t] = t;
    this->Parent[t] = std::isfinite(this->SticksIntoHull(t)) ? BeyondHull : -1;
    for (int n : this->Level.Neighbours[t])
    {
      if (n < 0 || this->Root[n] < 0)
      {
        continue;
      }
      if (this->Parent[t] == -1 || this->SticksOut(t, n) < this->SticksOut(t, this->Parent[t]))
      {
        this->Parent[t] = n;
      }
      const int one = this->RootOf(n);
      const int other = this->RootOf(t);
      const bool isOneLarger = this->ComesBefore(one, other);
      const int larger = isOneLarger ? one : other;
      const int smaller = isOneLarger ? other : one;
      this->Root[smaller] = larger;
      if (smaller != larger && smaller != t && this->Parent[smaller] == -1)
      {
        this->Parent[smaller] = larger;
      }
    }
  }

  /// Of every circle by how much its branch sticks out of what it hangs on.
  std::vector<double> ReachOfBranches(const std::vector<int>& order) const
  {
    std::vector<double> reach(this->Circles.size(), 0);
    for (auto t = order.rbegin(); t != order.rend(); ++t)
    {
      const int parent = this->Parent[*t];
      reach[*t] += parent == -1 ? 0 : this->SticksOut(*t, parent);
      if (parent >= 0)
      {
        reach[parent] = std::max(reach[parent], reach[*t]);
      }
    }
    return reach;
  }

  double MostRounding(int larger) const
  {
    return std::min(this->Rounding,
      larger == BeyondHull ? MostOfDiagonal * this->Diagonal
                           : MostOfRadius * this->Circles[larger].Radius);
  }

  const LevelTriangulation& Level;
  double Rounding;
  double Diagonal = 0;
  std::vector<Circle> Circles; ///< a triangle
  std::vector<int> Parent;     ///< of a triangle the one that it hangs on; -1: none
  std::vector<int> Root;       ///< towards the root of its tree; -1 before it hangs, and elsewhere
};

std::vector<Point2> VerticesOf(
  const LevelTriangulation& level, const std::vector<unsigned char>& wanted)
{
  std::vector<Point2> vertices;
  for (std::size_t t = 0; t < wanted.size(); ++t)
  {
    if (wanted[t])
    {
      vertices.push_back(level.VoronoiVertex(static_cast<int>(t)));
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}
}

double UnitOfLevel(const ContourSet& contours, int level)
{
  std::vector<double> units;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> numbers = CoordinatesOf(contours, level, axis);
    if (std::adjacent_find(numbers.begin(), numbers.end(), std::not_equal_to<>()) != numbers.end())
    {
      std::transform(numbers.begin(), numbers.end(), std::back_inserter(units),
        [](double x) { return UnitOf({ x }); });
    }
  }
  if (units.empty())
  {
    return 0;
  }
  const auto coarsest =
    units.begin() + static_cast<std::ptrdiff_t>(FinerNumbers * static_cast<double>(units.size()));
  std::nth_element(units.begin(), coarsest, units.end());
  return *coarsest;
}

std::vector<unsigned char> FindInternalSkeleton(const LevelTriangulation& level, double unit)
{
  return Pruning(level, true, unit).Find();
}

std::vector<Point2> InternalSkeletonVertices(const LevelTriangulation& level, double unit)
{
  return VerticesOf(level, FindInternalSkeleton(level, unit));
}

std::vector<Point2> ExternalSkeletonVertices(const LevelTriangulation& level, double unit)
{
  return VerticesOf(level, Pruning(level, false, unit).Find());
}
}
