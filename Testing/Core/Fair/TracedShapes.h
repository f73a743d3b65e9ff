// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TracedShapes.h
 * @brief Contours as they are traced on the raster of an image.
 */
#ifndef recon_Testing_TracedShapes_h
#define recon_Testing_TracedShapes_h

#include "Base/Geometry.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace recon::testing
{
/// Where the circle crosses the lines of a raster; each place moved along its line by up to `unsteady`.
inline std::vector<Point2> Traced(double radius, double pitch, double unsteady, unsigned seed = 1)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> error(-unsteady, unsteady);
  std::vector<std::pair<double, Point2>> places;
  for (double line = pitch * std::ceil(-radius / pitch); line < radius; line += pitch)
  {
    const double half = std::sqrt(radius * radius - line * line);
    for (const double side : { -half, half })
    {
      places.push_back({ std::atan2(side, line), { line, side + error(random) } });
      places.push_back({ std::atan2(line, side), { side + error(random), line } });
    }
  }
  std::sort(places.begin(), places.end());
  std::vector<Point2> ring;
  for (const auto& [angle, place] : places)
  {
    if (ring.empty() || Distance(ring.back(), place) > 1e-3)
    {
      ring.push_back(place);
    }
  }
  return ring;
}
}

#endif
