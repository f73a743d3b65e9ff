// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/EdgeRoots.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Regula falsi needs four or five steps; bisection after that ends in any case.
constexpr int MaximumRootSteps = 60;

/// The piece of an edge that holds its root.
struct Bracket
{
  explicit Bracket(const CrossedEdge& edge)
    : Inside(edge.Inside),
      Outside(edge.Outside),
      GA(edge.InsideValue),
      GB(edge.OutsideValue)
  {
    this->Propose(false);
  }

  Point3 Inside;
  Point3 Outside;
  double A = 0; ///< fraction from Inside where g > 0
  double B = 1; ///< and where g <= 0
  double GA;
  double GB;
  int LastSide = 0;
  double At = 0.5;

  Point3 Place(double t) const { return (1 - t) * this->Inside + t * this->Outside; }

  void Propose(bool bisect)
  {
    const double t = (this->A * this->GB - this->B * this->GA) / (this->GB - this->GA);
    const bool usable = !bisect && t >= this->A && t <= this->B;
    this->At = usable ? t : 0.5 * (this->A + this->B);
  }

  /// Takes g at the proposed place (Illinois: an end that stays twice counts half).
  void Take(double g)
  {
    const int side = g > 0 ? 1 : -1;
    if (side > 0)
    {
      this->A = this->At;
      this->GA = g;
      this->GB *= this->LastSide == side ? 0.5 : 1;
    }
    else
    {
      this->B = this->At;
      this->GB = g;
      this->GA *= this->LastSide == side ? 0.5 : 1;
    }
    this->LastSide = side;
  }
};

}

std::vector<Point3> FindRoots(const BoundedField& field, const std::vector<CrossedEdge>& edges,
  double tolerance, Monitor& monitor)
{
  std::vector<Bracket> brackets(edges.begin(), edges.end());
  std::vector<Point3> roots(brackets.size());
  std::vector<std::size_t> active(brackets.size());
  for (std::size_t i = 0; i < active.size(); ++i)
  {
    active[i] = i;
    roots[i] = brackets[i].Place(brackets[i].At);
  }
  for (int step = 0; step < MaximumRootSteps && !active.empty(); ++step)
  {
    monitor.Update(std::min(0.95, 0.2 * step), "finding the surface's points");
    std::vector<Point3> at;
    at.reserve(active.size());
    for (const std::size_t i : active)
    {
      at.push_back(roots[i]);
    }
    const std::vector<double> g = field.Values(at);
    std::vector<std::size_t> still;
    for (std::size_t k = 0; k < active.size(); ++k)
    {
      Bracket& bracket = brackets[active[k]];
      const double length = Norm(bracket.Outside - bracket.Inside);
      const double before = bracket.At;
      bracket.Take(g[k]);
      bracket.Propose(step > MaximumRootSteps / 4);
      const double moved = std::min(std::abs(bracket.At - before), bracket.B - bracket.A);
      if (g[k] == 0 || moved * length <= tolerance)
      {
        roots[active[k]] = bracket.Place(g[k] == 0 ? before : bracket.At);
        continue;
      }
      roots[active[k]] = bracket.Place(bracket.At);
      still.push_back(active[k]);
    }
    active = std::move(still);
  }
  return roots;
}
}
