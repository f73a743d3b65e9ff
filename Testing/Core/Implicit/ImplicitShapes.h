// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ImplicitShapes.h
 * @brief Contour sets of shapes whose volume is known, for the implicit method's tests.
 */
#ifndef recon_ImplicitShapes_h
#define recon_ImplicitShapes_h

#include "HandMadeContours.h"

namespace handmade
{
constexpr double Pi = 3.14159265358979323846;

/// Slices of a sphere, the first and last a little inside the poles.
inline ContourSet SphereSlices(const Point3& centre, double radius, int slices, int points)
{
  Maker maker;
  for (int i = 0; i < slices; ++i)
  {
    const double z = radius * (-0.95 + 1.9 * i / (slices - 1));
    const int level = maker.AddLevel({ 0, 0, 1 }, centre[2] + z);
    // FrameOf's axes for z are not x and y: make the circle in space.
    std::vector<Point3> loop;
    const double r = std::sqrt(radius * radius - z * z);
    for (int k = 0; k < points; ++k)
    {
      const double a = 2 * Pi * k / points;
      loop.push_back({ centre[0] + r * std::cos(a), centre[1] + r * std::sin(a), centre[2] + z });
    }
    maker.AddContour(level, loop);
  }
  return maker.Finish();
}

/// Slices across a torus about the y axis: one contour, then two, then one again.
inline ContourSet TorusSlices(double ring, double tube, int slices, int points)
{
  Maker maker;
  const double reach = 0.97 * (ring + tube);
  for (int i = 0; i < slices; ++i)
  {
    const double z = -reach + 2 * reach * i / (slices - 1);
    const int level = maker.AddLevel({ 0, 0, 1 }, z);
    if (std::abs(z) >= ring - tube)
    {
      // One oval: by x, with y from (sqrt(x^2 + z^2) - ring)^2 + y^2 = tube^2.
      const double widest = std::sqrt(std::pow(ring + tube, 2) - z * z);
      std::vector<Point3> loop;
      for (int k = 0; k < 2 * points; ++k)
      {
        const double a = Pi * k / points;
        const double x = widest * std::cos(a);
        const double y2 = tube * tube - std::pow(std::hypot(x, z) - ring, 2);
        loop.push_back({ x, (std::sin(a) < 0 ? -1 : 1) * std::sqrt(std::max(0.0, y2)), z });
      }
      maker.AddContour(level, loop);
      continue;
    }
    for (const double sign : { -1.0, 1.0 })
    {
      std::vector<Point3> loop;
      for (int k = 0; k < points; ++k)
      {
        const double a = 2 * Pi * k / points;
        const double y = tube * std::sin(a);
        const double rho = ring + tube * std::cos(a);
        loop.push_back({ sign * std::sqrt(rho * rho - z * z), y, z });
      }
      maker.AddContour(level, loop);
    }
  }
  return maker.Finish();
}
}

#endif
