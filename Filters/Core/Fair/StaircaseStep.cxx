// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/StaircaseStep.h"

#include <cmath>

namespace recon
{
namespace
{
/// Sine of a turn that is a corner, and of one that is none (a point along an edge).
constexpr double Corner = 0.4;
constexpr double Straight = 0.05;
/// Contours follow pixels where so large a part of all corners and curves turns left and right by turns.
constexpr double StaircasePart = 0.25;

/// The sine of the turn at b.
double TurnAt(const Point2& a, const Point2& b, const Point2& c)
{
  const double ux = b[0] - a[0];
  const double uy = b[1] - a[1];
  const double vx = c[0] - b[0];
  const double vy = c[1] - b[1];
  const double lengths = std::hypot(ux, uy) * std::hypot(vx, vy);
  return lengths > 0 ? (ux * vy - uy * vx) / lengths : 0;
}

/// Without points along edges.
std::vector<Point2> CornersOf(const ContourSet& contours, const Contour& contour)
{
  std::vector<Point2> corners;
  const std::size_t count = contour.Points.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto at = [&](std::size_t k) { return contours.Planar[contour.Points[k % count]]; };
    if (std::abs(TurnAt(at(i + count - 1), at(i), at(i + 1))) > Straight)
    {
      corners.push_back(at(i));
    }
  }
  return corners;
}
}

double StaircaseStep(const ContourSet& contours)
{
  std::vector<double> steps;
  std::size_t all = 0;
  for (const Contour& contour : contours.Contours)
  {
    const std::vector<Point2> corners = CornersOf(contours, contour);
    const std::size_t count = corners.size();
    all += count;
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto at = [&](std::size_t k) { return corners[k % count]; };
      const double here = TurnAt(at(i + count - 1), at(i), at(i + 1));
      const double next = TurnAt(at(i), at(i + 1), at(i + 2));
      if (here * next < 0 && std::abs(here) > Corner && std::abs(next) > Corner)
      {
        steps.push_back(Distance(at(i), at(i + 1)));
      }
    }
  }
  return steps.size() > StaircasePart * static_cast<double>(all) ? Median(steps) : 0;
}
}
