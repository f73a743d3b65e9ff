// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/SurfacePlaces.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Cosine with the asked normal below which a triangle is of another sheet.
constexpr double OtherSheet = -0.3;
/// Of the radius, how far around a point is looked first.
constexpr double FirstReach = 1.0 / 16;

Vector3 Unit(const Vector3& v)
{
  const double length = Norm(v);
  return length > 0 ? (1 / length) * v : Vector3{ 0, 0, 0 };
}

/// The place on a side nearest to p: the corners' shares of it, and the squared distance.
std::pair<double, double> NearestOfSide(const Point3& p, const Point3& a, const Point3& b)
{
  const Vector3 side = b - a;
  const double square = Dot(side, side);
  const double t = square > 0 ? std::clamp(Dot(p - a, side) / square, 0.0, 1.0) : 0.0;
  const Vector3 rest = p - (a + t * side);
  return { t, Dot(rest, rest) };
}
}

SurfacePlace NearestOfTriangle(const Point3& p, const Point3& a, const Point3& b, const Point3& c)
{
  SurfacePlace place;
  // Of a corner the distance is 0, not the rounding of its height.
  if (p == a || p == b || p == c)
  {
    place.Shares = { p == a ? 1.0 : 0.0, p != a && p == b ? 1.0 : 0.0,
      p != a && p != b ? 1.0 : 0.0 };
    return place;
  }
  const Vector3 normal = Cross(b - a, c - a);
  const double square = Dot(normal, normal);
  if (square > 0)
  {
    const double u = Dot(Cross(c - b, p - b), normal) / square;
    const double v = Dot(Cross(a - c, p - c), normal) / square;
    const double w = 1 - u - v;
    if (u >= 0 && v >= 0 && w >= 0)
    {
      place.Shares = { u, v, w };
      place.Distance = std::abs(Dot(p - a, normal)) / std::sqrt(square);
      return place;
    }
  }
  const std::array<const Point3*, 3> corners{ &a, &b, &c };
  double least = -1;
  for (int k = 0; k < 3; ++k)
  {
    const auto [t, distance] = NearestOfSide(p, *corners[k], *corners[(k + 1) % 3]);
    if (least < 0 || distance < least)
    {
      least = distance;
      place.Shares = { 0, 0, 0 };
      place.Shares[k] = 1 - t;
      place.Shares[(k + 1) % 3] = t;
    }
  }
  place.Distance = std::sqrt(least);
  return place;
}

std::vector<Vector3> PointNormals(const TriangleMesh& mesh)
{
  std::vector<Vector3> normals(mesh.Points.size(), { 0, 0, 0 });
  for (const auto& t : mesh.Triangles)
  {
    const Vector3 normal =
      Unit(Cross(mesh.Points[t[1]] - mesh.Points[t[0]], mesh.Points[t[2]] - mesh.Points[t[0]]));
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 u = mesh.Points[t[(k + 1) % 3]] - mesh.Points[t[k]];
      const Vector3 v = mesh.Points[t[(k + 2) % 3]] - mesh.Points[t[k]];
      normals[t[k]] = normals[t[k]] + std::atan2(Norm(Cross(u, v)), Dot(u, v)) * normal;
    }
  }
  std::transform(normals.begin(), normals.end(), normals.begin(), Unit);
  return normals;
}

SurfacePlaces::SurfacePlaces(const TriangleMesh& mesh)
  : Mesh(mesh),
    Tree(mesh),
    Normals(PointNormals(mesh))
{
  for (const auto& t : mesh.Triangles)
  {
    this->Facing.push_back(
      Unit(Cross(mesh.Points[t[1]] - mesh.Points[t[0]], mesh.Points[t[2]] - mesh.Points[t[0]])));
  }
}

SurfacePlace SurfacePlaces::Nearest(
  const Point3& p, const Vector3& normal, double radius, int guess) const
{
  SurfacePlace best;
  best.Distance = radius;
  const auto look = [&](int t)
  {
    if (Dot(this->Facing[t], normal) >= OtherSheet)
    {
      const auto& corners = this->Mesh.Triangles[t];
      SurfacePlace place = NearestOfTriangle(p, this->Mesh.Points[corners[0]],
        this->Mesh.Points[corners[1]], this->Mesh.Points[corners[2]]);
      const bool first =
        place.Distance == best.Distance && (best.Triangle < 0 || t < best.Triangle);
      if (place.Distance < best.Distance || first)
      {
        best = place;
        best.Triangle = t;
      }
    }
  };
  if (guess >= 0)
  {
    look(guess);
  }
  // Outward in steps, as most points are near the surface; no farther than what is known already.
  for (double reach = FirstReach * radius;; reach *= 4)
  {
    const double within = std::min(reach, best.Distance);
    this->Tree.VisitMeeting(Box3(p, p).Grown(within), look);
    if (best.Distance <= within)
    {
      return best;
    }
  }
}

Vector3 SurfacePlaces::NormalAt(const SurfacePlace& place) const
{
  const auto& t = this->Mesh.Triangles[place.Triangle];
  return Unit(place.Shares[0] * this->Normals[t[0]] +
    (place.Shares[1] * this->Normals[t[1]] + place.Shares[2] * this->Normals[t[2]]));
}
}
