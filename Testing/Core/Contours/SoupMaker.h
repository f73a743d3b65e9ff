// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SoupMaker.h
 * @brief Contours as tests need them: loops in a plane, given by coordinates.
 */
#ifndef recon_SoupMaker_h
#define recon_SoupMaker_h

#include "Contours/ContourSetBuilder.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace recon::testing
{
/// Collects chains; Source is the number of the chain.
class SoupMaker
{
public:
  LoopSoup Soup;

  int AddPoint(const Point3& p)
  {
    this->Soup.Points.push_back(p);
    return static_cast<int>(this->Soup.Points.size()) - 1;
  }

  SoupMaker& Chain(const std::vector<Point3>& points, bool closed)
  {
    LoopSoup::Chain chain;
    chain.Closed = closed;
    chain.Source = static_cast<int>(this->Soup.Chains.size());
    for (const Point3& p : points)
    {
      chain.Points.push_back(this->AddPoint(p));
    }
    this->Soup.Chains.push_back(std::move(chain));
    return *this;
  }

  /// A closed loop at height z.
  SoupMaker& Loop(const std::vector<Point2>& points, double z = 0)
  {
    return this->Chain(Lift(points, z), true);
  }

  /// The edges of a closed loop as two-point segments, shuffled and turned at random, points not
  /// shared.
  SoupMaker& Segments(const std::vector<Point3>& loop, unsigned seed)
  {
    std::mt19937 random(seed);
    std::vector<std::vector<Point3>> edges;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      edges.push_back({ loop[i], loop[(i + 1) % loop.size()] });
      if (random() % 2 == 0)
      {
        std::swap(edges.back()[0], edges.back()[1]);
      }
    }
    std::shuffle(edges.begin(), edges.end(), random);
    for (const std::vector<Point3>& edge : edges)
    {
      this->Chain(edge, false);
    }
    return *this;
  }

  ContourSet Build(bool parallel = true, double tolerance = 0,
    OpenLineRule openLines = OpenLineRule::LeaveOut) const
  {
    ContourSetOptions options;
    options.OpenLines = openLines;
    options.Parallel = parallel;
    options.PlaneTolerance = tolerance;
    Monitor monitor;
    return BuildContourSet(this->Soup, options, monitor);
  }

  static std::vector<Point3> Lift(const std::vector<Point2>& points, double z)
  {
    std::vector<Point3> lifted;
    for (const Point2& p : points)
    {
      lifted.push_back({ p[0], p[1], z });
    }
    return lifted;
  }
};

/// Counterclockwise, from the lower left corner.
inline std::vector<Point2> Rectangle(double x0, double y0, double x1, double y1)
{
  return { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
}

inline std::vector<Point2> Circle(double x, double y, double radius, int count)
{
  std::vector<Point2> points;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2 * 3.14159265358979323846 * i / count;
    points.push_back({ x + radius * std::cos(angle), y + radius * std::sin(angle) });
  }
  return points;
}
}

#endif
