// SPDX-License-Identifier: GPL-3.0-or-later
#include "Contours/RingPlane.h"

#include <cmath>
#include <cstddef>

namespace recon
{
namespace
{
// A ring whose width is less than this many tolerances does not tell its plane by itself.
constexpr double TrustedWidth = 10;
// More decimals than this are not told apart from coordinates that nobody rounded.
constexpr int MostDecimals = 6;

/// The widest triangle over the ring's longest chord.
Vector3 WidestTriangle(const LoopSoup& soup, const Ring& ring, double& length)
{
  const Point3& o = soup.Points[ring.Points[0]];
  Vector3 chord{ 0, 0, 0 };
  for (int p : ring.Points)
  {
    const Vector3 d = soup.Points[p] - o;
    chord = Norm(d) > Norm(chord) ? d : chord;
  }
  Vector3 widest{ 0, 0, 0 };
  for (int p : ring.Points)
  {
    const Vector3 c = 0.5 * Cross(chord, soup.Points[p] - o);
    widest = Norm(c) > Norm(widest) ? c : widest;
  }
  length = Norm(chord);
  return widest;
}

std::size_t LargestComponent(const Vector3& v)
{
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k)
  {
    largest = std::abs(v[k]) > std::abs(v[largest]) ? k : largest;
  }
  return largest;
}

/// holds(x) for every coordinate of every point of the rings?
template <typename Predicate>
bool ForAllCoordinates(const LoopSoup& soup, const std::vector<Ring>& rings, const Predicate& holds)
{
  for (const Ring& ring : rings)
  {
    for (int p : ring.Points)
    {
      for (double x : soup.Points[p])
      {
        if (!holds(x))
        {
          return false;
        }
      }
    }
  }
  return true;
}
}
Vector3 NewellArea(const LoopSoup& soup, const std::vector<int>& ring)
{
  const Point3& o = soup.Points[ring[0]];
  Vector3 sum{ 0, 0, 0 };
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
  {
    const Vector3 a = soup.Points[ring[i]] - o;
    const Vector3 b = soup.Points[ring[i + 1]] - o;
    sum = sum + 0.5 * Cross(a, b);
  }
  return sum;
}

RingPlane FindRingPlane(const LoopSoup& soup, const Ring& ring, double tolerance)
{
  RingPlane plane;
  const Vector3 widest = WidestTriangle(soup, ring, plane.Length);
  plane.AreaVector = NewellArea(soup, ring.Points);
  if (Norm(plane.AreaVector) < 0.1 * Norm(widest))
  {
    plane.AreaVector = widest;
  }
  plane.HasNormal = Norm(plane.AreaVector) > 0;
  plane.Trusted = Norm(plane.AreaVector) > TrustedWidth * tolerance * plane.Length;
  if (plane.HasNormal)
  {
    plane.Roughness = 0.5 * RangeAlong(soup, ring, CanonicalNormal(plane.AreaVector)).Size();
  }
  return plane;
}

OffsetRange RangeAlong(const LoopSoup& soup, const Ring& ring, const Vector3& normal)
{
  OffsetRange range;
  for (int p : ring.Points)
  {
    range.Add(Dot(normal, soup.Points[p]));
  }
  return range;
}

Vector3 CanonicalNormal(const Vector3& v)
{
  return (v[LargestComponent(v)] < 0 ? -1 / Norm(v) : 1 / Norm(v)) * v;
}

Vector3 NearestAxis(const Vector3& unit)
{
  Vector3 axis{ 0, 0, 0 };
  axis[LargestComponent(unit)] = 1;
  return axis;
}

double CoordinateStep(const LoopSoup& soup, const std::vector<Ring>& rings)
{
  double scale = 10;
  for (int decimals = 1; decimals <= MostDecimals; ++decimals, scale *= 10)
  {
    // A decimal is the double nearest to it.
    if (ForAllCoordinates(
          soup, rings, [scale](double x) { return x == std::round(x * scale) / scale; }))
    {
      return 1 / scale;
    }
  }
  double largest = 0;
  const bool single = ForAllCoordinates(soup, rings,
    [&largest](double x)
    {
      largest = std::max(largest, std::abs(x));
      return x == static_cast<double>(static_cast<float>(x));
    });
  if (!single || largest == 0)
  {
    return 0;
  }
  const auto at = static_cast<float>(largest);
  return static_cast<double>(std::nextafter(at, std::numeric_limits<float>::infinity()) - at);
}
}
