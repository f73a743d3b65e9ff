// SPDX-License-Identifier: GPL-3.0-or-later
#include "CurveNetwork/PlaneCheck.h"

#include <algorithm>

namespace recon
{
namespace
{
constexpr double FitTolerance = 1e-3;

/// The vertex for which measure is largest.
template <typename Measure>
const Point3& Farthest(const std::vector<Point3>& vertices, Measure measure)
{
  return *std::max_element(vertices.begin(), vertices.end(),
    [&](const Point3& a, const Point3& b) { return measure(a) < measure(b); });
}
}

Vector3 NormalOf(const std::vector<Point3>& vertices, const Vector3& hint)
{
  const Vector3 none{ 0, 0, 1 };
  if (vertices.empty())
  {
    return none;
  }
  // Three vertices far from each other span the plane best.
  const Point3& a = vertices.front();
  const Point3& b = Farthest(vertices, [&a](const Point3& p) { return Norm(p - a); });
  const Point3& c =
    Farthest(vertices, [&a, &b](const Point3& p) { return Norm(Cross(b - a, p - a)); });
  const Vector3 normal = Cross(b - a, c - a);
  const double length = Norm(normal);
  if (!(length > 0))
  {
    return none;
  }
  return (Dot(normal, hint) < 0 ? -1 / length : 1 / length) * normal;
}

PlaneFit CheckPlane(const Vector3& normal, double d, const std::vector<Point3>& vertices)
{
  const double length = Norm(normal);
  if (!(length > 0))
  {
    return PlaneFit::WrongNormal;
  }
  if (vertices.empty())
  {
    return PlaneFit::Fits;
  }
  double low = Dot(normal, vertices.front());
  double high = low;
  double extent = 0;
  for (const Point3& p : vertices)
  {
    low = std::min(low, Dot(normal, p));
    high = std::max(high, Dot(normal, p));
    extent = std::max(extent, Norm(p - vertices.front()));
  }
  const double tolerance = FitTolerance * extent * length;
  if (high - low > tolerance)
  {
    return PlaneFit::WrongNormal;
  }
  const double middle = (low + high) / 2;
  if (std::abs(middle + d) <= tolerance)
  {
    return PlaneFit::Fits;
  }
  return std::abs(middle - d) <= tolerance ? PlaneFit::WrongSign : PlaneFit::WrongOffset;
}
}
