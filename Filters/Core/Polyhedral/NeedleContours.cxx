// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/NeedleContours.h"

#include "Base/Text.h"
#include "Contours/ContourMeasures.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>

namespace recon
{
namespace
{
/// Share of the diagonal of a level; a hundred times what is snapped together by default.
constexpr double WidestNeedle = 1e-5;

Point3 InPlane(const Point2& p)
{
  return { p[0], p[1], 0 };
}

double SquaredDistance(const ContourSet& contours, int contour, const Point2& place)
{
  const std::vector<int>& points = contours.Contours[contour].Points;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    least = std::min(least,
      SquaredDistanceToSegment(InPlane(place), InPlane(contours.Planar[points[i]]),
        InPlane(contours.Planar[points[(i + 1) % points.size()]])));
  }
  return least;
}

bool LiesWithin(const ContourSet& contours, int contour, int around)
{
  while (contour >= 0 && contour != around)
  {
    contour = contours.Contours[contour].Parent;
  }
  return contour == around;
}
}

std::vector<int> FindNeedle(
  const ContourSet& contours, const std::vector<int>& among, const Point2& place)
{
  const double widest = WidestNeedle * PlanarBounds(contours, among).Diagonal();
  double least = std::numeric_limits<double>::infinity();
  int needle = -1;
  for (int c : among)
  {
    const double distance = MeanWidth(contours, contours.Contours[c]) < widest
      ? SquaredDistance(contours, c, place)
      : std::numeric_limits<double>::infinity();
    if (distance < least)
    {
      least = distance;
      needle = c;
    }
  }
  std::vector<int> found;
  std::copy_if(among.begin(), among.end(), std::back_inserter(found),
    [&](int c) { return needle >= 0 && LiesWithin(contours, c, needle); });
  return found;
}

std::string DescribeNeedle(const ContourSet& contours, int contour)
{
  const Contour& c = contours.Contours[contour];
  return "Contour " + std::to_string(contour) + " (level " + std::to_string(c.Level) + ", offset " +
    Text(contours.Levels[c.Level].Offset) + ", " + Counted(c.Points.size(), "point") +
    "): left out, as it is only " + Text(MeanWidth(contours, c)) +
    " wide and runs so near to others that their edges would take more points than any surface is "
    "worth; merge there what is narrower than the contours are accurate.";
}
}
