// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/NearConstraints.h"

#include "Base/BoundingBox.h"
#include "Base/PointGrid.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace recon
{
namespace
{
/// Of the margin distance.
constexpr double Tolerance = 1e-5;
/// Where a margin distance is so small that even it would be too near, all cannot be left out.
constexpr double MostOfMargin = 0.25;

/// Which constraints stay where they are, decided in turn.
class Choice
{
public:
  Choice(const std::vector<Point3>& points, double apart)
    : Kept(points.size(), 0),
      Points(points),
      Grid(points, apart),
      Apart(apart)
  {
  }

  /// The nearest one that stays, or -1: then this one does.
  int Decide(std::size_t i)
  {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    this->Grid.ForNear(this->Points[i], this->Apart,
      [&](int j, double r2)
      {
        if (this->Kept[j] && std::make_pair(r2, j) < std::make_pair(least, nearest))
        {
          least = r2;
          nearest = j;
        }
      });
    this->Kept[i] = nearest < 0 ? 1 : 0;
    return nearest;
  }

  std::vector<char> Kept;

private:
  const std::vector<Point3> Points;
  const PointGrid Grid;
  double Apart;
};

template <typename Value>
void KeepOnly(const std::vector<char>& kept, std::vector<Value>& values)
{
  std::size_t next = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (kept[i])
    {
      values[next++] = values[i];
    }
  }
  values.resize(next);
}

std::string Sentence(std::size_t count, const char* what, double apart)
{
  char distance[32];
  std::snprintf(distance, sizeof distance, "%.3g", apart);
  return std::to_string(count) + what + " nearer than " + distance +
    ", which a fit in double precision cannot tell apart.";
}
}

double LeastDistanceApart(const ConstraintSet& set)
{
  if (set.Points.empty() || !(set.MarginDistance > 0))
  {
    return 0;
  }
  const double s = 0.5 * Box3::Around(set.Points).Diagonal();
  const double d = set.MarginDistance / s;
  const double t = std::sqrt(4 * std::numeric_limits<double>::epsilon() / (Tolerance * d));
  return std::min(t, MostOfMargin * d) * s;
}

void ResolveNearConstraints(ConstraintSet& set)
{
  const double apart = LeastDistanceApart(set);
  if (!(apart > 0))
  {
    return;
  }
  Choice choice(set.Points, apart);
  std::vector<char> stays(set.Points.size(), 1);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < set.Points.size(); ++i)
  {
    const int near = set.Kind[i] == ConstraintSet::Boundary ? choice.Decide(i) : -1;
    if (near >= 0 && set.Points[near] != set.Points[i])
    {
      set.Points[i] = set.Points[near];
      ++moved;
    }
  }
  std::size_t leftOut = 0;
  for (std::size_t i = 0; i < set.Points.size(); ++i)
  {
    if (set.Kind[i] != ConstraintSet::Boundary && choice.Decide(i) >= 0)
    {
      stays[i] = 0;
      ++leftOut;
    }
  }
  if (moved > 0)
  {
    set.Report.push_back(Sentence(moved, " contour points took the place of another one", apart));
  }
  if (leftOut > 0)
  {
    set.Report.push_back(
      Sentence(leftOut, " margin points were left out, because another constraint is", apart));
  }
  set.LeftOut += leftOut;
  KeepOnly(stays, set.Points);
  KeepOnly(stays, set.Values);
  KeepOnly(stays, set.Kind);
  KeepOnly(stays, set.Contour);
}
}
