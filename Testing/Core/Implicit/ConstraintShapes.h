// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ConstraintShapes.h
 * @brief Constraints straight from formulas, three a point, for the solvers' tests.
 */
#ifndef recon_ConstraintShapes_h
#define recon_ConstraintShapes_h

#include "Implicit/Solver/FitImplicitFunction.h"

#include <cmath>

namespace shapes
{
using recon::operator+;
using recon::operator*;
using recon::Point3;
using recon::Vector3;

constexpr double Pi = 3.14159265358979323846;

struct Sample
{
  std::vector<Point3> Points;
  std::vector<double> Values;

  /// A point of the surface and its margins at distance d along the inward normal.
  void Add(const Point3& x, const Vector3& outward, double d)
  {
    this->Points.push_back(x);
    this->Points.push_back(x + (-d) * outward);
    this->Points.push_back(x + d * outward);
    for (const double h : { 0.0, 1.0, -1.0 })
    {
      this->Values.push_back(h);
    }
  }
};

/// A contour of the wavy ball at height z, at angle t, and its normal in the plane.
inline void WavyPoint(double z, double t, Point3& x, Vector3& outward)
{
  const double big = std::sqrt(1 - z * z);
  const double wave =
    1 + 0.12 * std::sin(3 * t + 2 * z) * big + 0.05 * std::cos(5 * t - 4 * z) * big;
  const double slope = 0.36 * std::cos(3 * t + 2 * z) * big - 0.25 * std::sin(5 * t - 4 * z) * big;
  const double r = big * wave;
  const double dr = big * slope;
  const double nx = r * std::cos(t) + dr * std::sin(t);
  const double ny = r * std::sin(t) - dr * std::cos(t);
  x = { r * std::cos(t), r * std::sin(t), z };
  outward = (1 / std::hypot(nx, ny)) * Vector3{ nx, ny, 0 };
}

/// The wavy ball of radius about 1, on parallel slices. uneven: most points crowd in one corner.
inline Sample WavyBall(int slices, int points, double d, bool uneven = false)
{
  Sample sample;
  for (int s = 0; s < slices; ++s)
  {
    double u = (s + 0.5) / slices;
    u = uneven ? u * u * u : u;
    for (int k = 0; k < points; ++k)
    {
      double v = (k + 0.5 * (s % 2)) / points;
      v = uneven ? v * v : v;
      Point3 x;
      Vector3 outward;
      WavyPoint(-0.97 + 1.94 * u, 2 * Pi * v, x, outward);
      sample.Add(x, outward, d);
    }
  }
  return sample;
}

/// Circles of a ball on planes across all three axes: they cross each other on the surface.
inline Sample CrossingPlanes(int slices, int points, double d)
{
  Sample sample;
  for (int a = 0; a < 3; ++a)
  {
    for (int s = 0; s < slices; ++s)
    {
      const double c = -0.9 + 1.8 * (s + 0.5) / slices;
      for (int k = 0; k < points; ++k)
      {
        const double t = 2 * Pi * k / points;
        Vector3 outward{ 0, 0, 0 };
        outward[(a + 1) % 3] = std::cos(t);
        outward[(a + 2) % 3] = std::sin(t);
        Point3 x = std::sqrt(1 - c * c) * outward;
        x[a] = c;
        sample.Add(x, outward, d);
      }
    }
  }
  return sample;
}

/// The two faces of a wavy plate of that thickness.
inline Sample ThinPlate(int side, double thickness, double d)
{
  Sample sample;
  for (int i = 0; i < side; ++i)
  {
    for (int j = 0; j < side; ++j)
    {
      const double x = static_cast<double>(i) / side;
      const double y = static_cast<double>(j) / side;
      const double z = 0.1 * std::sin(6 * x) * std::cos(5 * y);
      sample.Add({ x, y, z + 0.5 * thickness }, { 0, 0, 1 }, d);
      sample.Add({ x, y, z - 0.5 * thickness }, { 0, 0, -1 }, d);
    }
  }
  return sample;
}
}

#endif
