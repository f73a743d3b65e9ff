// SPDX-License-Identifier: GPL-3.0-or-later
// What lies nearer than the tolerance becomes one, in bounded time, and nothing else moves.
#include "Core/Contours/ContourInvariants.h"
#include "Core/Contours/SoupMaker.h"
#include "Planar/Arrangement.h"
#include "Planar/EdgeTree.h"
#include "Planar/SnapTolerance.h"

using namespace recon;
using namespace recon::testing;

namespace
{
/// Loops with points of equal coordinates made one.
struct Plane
{
  std::vector<Point2> Points;
  std::vector<std::vector<int>> Loops;

  void Add(const std::vector<Point2>& loop)
  {
    std::vector<int> numbers;
    for (const Point2& p : loop)
    {
      const auto [at, isNew] = this->Known.emplace(p, static_cast<int>(this->Points.size()));
      if (isNew)
      {
        this->Points.push_back(p);
      }
      if (numbers.empty() || numbers.back() != at->second)
      {
        numbers.push_back(at->second);
      }
    }
    while (numbers.size() > 1 && numbers.front() == numbers.back())
    {
      numbers.pop_back();
    }
    if (numbers.size() >= 3)
    {
      this->Loops.push_back(numbers);
    }
  }

  std::vector<PlanarEdge> Edges() const
  {
    std::vector<PlanarEdge> edges;
    for (std::size_t l = 0; l < this->Loops.size(); ++l)
    {
      const std::vector<int>& p = this->Loops[l];
      for (std::size_t i = 0; i < p.size(); ++i)
      {
        edges.push_back({ p[i], p[(i + 1) % p.size()], static_cast<int>(l) });
      }
    }
    return edges;
  }

  std::map<Point2, int> Known;
};

EdgeTree TreeOf(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
{
  std::vector<PlanarSegment> segments;
  for (const PlanarEdge& e : edges)
  {
    segments.push_back({ points[At(e.A)], points[At(e.B)] });
  }
  return EdgeTree(std::move(segments));
}

/// By a plain look at all of them.
double NearestThatAreNotOne(const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
{
  std::set<int> used;
  for (const PlanarEdge& e : edges)
  {
    used.insert({ e.A, e.B });
  }
  double nearest = HUGE_VAL;
  for (int p : used)
  {
    for (const PlanarEdge& e : edges)
    {
      if (e.A != p && e.B != p)
      {
        nearest =
          std::min(nearest, DistanceToSegment(points[At(p)], { points[At(e.A)], points[At(e.B)] }));
      }
    }
  }
  return nearest;
}

void ExpectCrossingsOnlyAtEnds(
  const std::vector<Point2>& points, const std::vector<PlanarEdge>& edges)
{
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Point2& a = points[At(edges[i].A)];
      const Point2& b = points[At(edges[i].B)];
      const Point2& c = points[At(edges[j].A)];
      const Point2& d = points[At(edges[j].B)];
      ASSERT_FALSE(Orientation2(a, b, c) * Orientation2(a, b, d) < 0 &&
        Orientation2(c, d, a) * Orientation2(c, d, b) < 0)
        << "edges " << i << " and " << j;
    }
  }
}

class Wild
{
public:
  explicit Wild(unsigned seed) : Random(seed) {}

  double Uniform(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Random);
  }
  int Below(int n) { return static_cast<int>(this->Random() % static_cast<unsigned>(n)); }

  /// A polygon, and itself again a little off.
  void AddTwins(Plane& plane, double off)
  {
    const std::vector<Point2> loop = this->Polygon();
    std::vector<Point2> again;
    for (const Point2& p : loop)
    {
      again.push_back({ p[0] + this->Uniform(-off, off), p[1] + this->Uniform(-off, off) });
    }
    plane.Add(loop);
    plane.Add(again);
  }

  void AddSliver(Plane& plane, double width)
  {
    const Point2 a{ this->Uniform(0, 1), this->Uniform(0, 1) };
    const Point2 b{ this->Uniform(0, 1), this->Uniform(0, 1) };
    const double t = this->Uniform(-0.5, 1.5);
    plane.Add({ a, b,
      { a[0] + t * (b[0] - a[0]) + this->Uniform(-width, width),
        a[1] + t * (b[1] - a[1]) + this->Uniform(-width, width) } });
  }

  /// There and back beside itself.
  void AddNearParallels(Plane& plane, double width)
  {
    const Point2 a{ this->Uniform(0, 1), this->Uniform(0, 1) };
    const Point2 b{ this->Uniform(0, 1), this->Uniform(0, 1) };
    plane.Add({ a, b, { b[0] + this->Uniform(-width, width), b[1] + this->Uniform(-width, width) },
      { a[0] + this->Uniform(-width, width), a[1] + this->Uniform(-width, width) } });
  }

  /// Many turns that lie a pitch apart, and straight back to the start.
  void AddSpiral(Plane& plane, double pitch)
  {
    std::vector<Point2> loop;
    const int corners = 3 + this->Below(5);
    for (int i = 0; i < 6 * corners; ++i)
    {
      const double angle = 2 * 3.14159265358979323846 * i / corners;
      const double radius = 0.3 + pitch * i / corners;
      loop.push_back({ 0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle) });
    }
    plane.Add(loop);
  }

  std::vector<Point2> Polygon()
  {
    std::vector<Point2> loop;
    const int count = 3 + this->Below(6);
    for (int i = 0; i < count; ++i)
    {
      loop.push_back({ this->Uniform(0, 1), this->Uniform(0, 1) });
    }
    return loop;
  }

private:
  std::mt19937 Random;
};

TEST(Arrangement, PropertyOfRandomDegeneratePlanes)
{
  for (unsigned seed = 1; seed <= 400; ++seed)
  {
    Wild wild(seed);
    Plane plane;
    // From far below the tolerance to far above, and about as much.
    const double tolerance = 1e-5;
    const double size = tolerance * std::pow(10.0, wild.Uniform(-6, 3));
    for (int shapes = 1 + wild.Below(4); shapes > 0; --shapes)
    {
      switch (wild.Below(4))
      {
        case 0:
          wild.AddTwins(plane, size);
          break;
        case 1:
          wild.AddSliver(plane, size);
          break;
        case 2:
          wild.AddNearParallels(plane, size);
          break;
        default:
          wild.AddSpiral(plane, size);
      }
    }
    const std::vector<Point2> given = plane.Points;
    const EdgeTree before = TreeOf(given, plane.Edges());
    Arrangement arrangement(plane.Points, plane.Edges(),
      std::vector<double>(plane.Loops.size(), tolerance), Arrangement::SumType::Parity);
    ASSERT_NO_THROW(arrangement.Resolve()) << "seed " << seed;

    const std::vector<PlanarEdge>& edges = arrangement.Edges();
    ExpectCrossingsOnlyAtEnds(plane.Points, edges);
    ASSERT_GT(NearestThatAreNotOne(plane.Points, edges), 0.999 * tolerance) << "seed " << seed;
    // What was given stays, to the last bit.
    ASSERT_TRUE(std::equal(given.begin(), given.end(), plane.Points.begin())) << "seed " << seed;
    // And so does the inside, but beside what was snapped.
    const EdgeTree after = TreeOf(plane.Points, edges);
    for (int k = 0; k < 100; ++k)
    {
      const Point2 p{ wild.Uniform(-0.1, 1.1), wild.Uniform(-0.1, 1.1) };
      if (before.DistanceWithin(p, 1) > 20 * tolerance)
      {
        ASSERT_EQ(before.SideOf(p), after.SideOf(p))
          << "seed " << seed << " at " << p[0] << " " << p[1];
      }
    }
  }
}

TEST(Arrangement, WhatIsInOrderKeepsItsEdges)
{
  Plane plane;
  plane.Add(Circle(0, 0, 10, 400));
  plane.Add(Circle(0, 0, 9.999, 400));
  const std::vector<PlanarEdge> edges = plane.Edges();
  Arrangement arrangement(plane.Points, edges, SnapTolerances(plane.Points, plane.Loops, 0),
    Arrangement::SumType::Parity);
  arrangement.Resolve();
  ASSERT_EQ(arrangement.Edges().size(), edges.size());
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    EXPECT_EQ(arrangement.Edges()[e].A, edges[e].A);
    EXPECT_EQ(arrangement.Edges()[e].B, edges[e].B);
  }
  EXPECT_FALSE(arrangement.HasConflict(0));
}

TEST(Arrangement, AFinelySampledLineDoesNotShrinkToAPoint)
{
  // A circle of points that are each nearer to the next than the tolerance.
  Plane plane;
  plane.Add(Circle(0, 0, 1, 10000));
  Arrangement arrangement(plane.Points, plane.Edges(), { 0.01 }, Arrangement::SumType::Parity);
  arrangement.Resolve();
  EXPECT_GT(arrangement.Edges().size(), 300u);
  EXPECT_LT(arrangement.Edges().size(), 640u);
  EXPECT_EQ(TreeOf(plane.Points, arrangement.Edges()).SideOf({ 0.1, 0.1 }), EdgeTree::Inside);
  EXPECT_LE(arrangement.FindingsOf(0).Moved, 0.01);
}

TEST(Arrangement, EqualEdgesCountByParityOrByWeight)
{
  for (bool weight : { false, true })
  {
    Plane plane;
    plane.Add(Rectangle(0, 0, 1, 1));
    plane.Add(Rectangle(0, 0, 1, 1));
    Arrangement arrangement(plane.Points, plane.Edges(), { 1e-9, 1e-9 },
      weight ? Arrangement::SumType::Weight : Arrangement::SumType::Parity);
    arrangement.Resolve();
    ASSERT_EQ(arrangement.Edges().size(), weight ? 4u : 0u);
    EXPECT_EQ(arrangement.SetOf(0), arrangement.SetOf(1));
    if (weight)
    {
      EXPECT_EQ(arrangement.Edges()[0].Weight, 2);
    }
  }
}

TEST(Arrangement, AScribbleIsRefusedInASentence)
{
  // A star of 4001 points whose edges all cross one another: 8 million crossings.
  constexpr int n = 4001;
  std::vector<Point2> star;
  for (int i = 0; i < n; ++i)
  {
    const double angle = 2 * 3.14159265358979323846 * (static_cast<double>(i) * (n / 2) / n);
    star.push_back({ std::cos(angle), std::sin(angle) });
  }
  Plane plane;
  plane.Add(star);
  Arrangement arrangement(plane.Points, plane.Edges(), { 1e-9 }, Arrangement::SumType::Parity);
  EXPECT_THROW(arrangement.Resolve(), Error);
}
}
