// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/NearestRegion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace recon
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

struct Box
{
  Point2 Low{ { INFINITY, INFINITY } };
  Point2 High{ { -INFINITY, -INFINITY } };

  void Add(const Point2& p)
  {
    for (std::size_t k = 0; k < 2; ++k)
    {
      this->Low[k] = std::min(this->Low[k], p[k]);
      this->High[k] = std::max(this->High[k], p[k]);
    }
  }

  bool IsWithin(double reach, const Box& other) const
  {
    return this->Low[0] - other.High[0] < reach && other.Low[0] - this->High[0] < reach &&
      this->Low[1] - other.High[1] < reach && other.Low[1] - this->High[1] < reach;
  }
};

class Finder
{
public:
  Finder(const ContourSet& set, const ContourRegion& region) : Set(set), Region(region)
  {
    this->Around = this->BoxOf(region.Wall);
  }

  /// No more than `reach`, which is returned where the region is farther away.
  double DistanceTo(const ContourRegion& other, double reach) const
  {
    if (!this->BoxOf(other.Wall).IsWithin(reach, this->Around))
    {
      return reach;
    }
    double distance = reach;
    for (int own : this->BordersOf(this->Region))
    {
      for (int border : this->BordersOf(other))
      {
        distance = std::min(distance, this->DistanceBetween(own, border, distance));
      }
    }
    return distance;
  }

private:
  const Point2& At(int p) const { return this->Set.Planar[Index(p)]; }
  const std::vector<int>& PointsOf(int contour) const
  {
    return this->Set.Contours[Index(contour)].Points;
  }

  static std::vector<int> BordersOf(const ContourRegion& region)
  {
    std::vector<int> borders = region.Holes;
    borders.push_back(region.Wall);
    return borders;
  }

  Box BoxOf(int contour) const
  {
    Box box;
    for (int p : this->PointsOf(contour))
    {
      box.Add(this->At(p));
    }
    return box;
  }

  /// Of contours that do not cross: of a vertex of the one from an edge of the other.
  double DistanceBetween(int contour, int other, double reach) const
  {
    return std::min(
      this->VerticesToEdges(contour, other, reach), this->VerticesToEdges(other, contour, reach));
  }

  double VerticesToEdges(int vertices, int edges, double reach) const
  {
    const Box box = this->BoxOf(vertices);
    const std::vector<int>& p = this->PointsOf(edges);
    double nearest = reach;
    for (std::size_t i = 0; i < p.size(); ++i)
    {
      const Point2& a = this->At(p[i]);
      const Point2& b = this->At(p[(i + 1) % p.size()]);
      Box edge;
      edge.Add(a);
      edge.Add(b);
      if (edge.IsWithin(nearest, box))
      {
        for (int v : this->PointsOf(vertices))
        {
          nearest = std::min(nearest, ToEdge(this->At(v), a, b));
        }
      }
    }
    return nearest;
  }

  static double ToEdge(const Point2& p, const Point2& a, const Point2& b)
  {
    const Point2 along{ { b[0] - a[0], b[1] - a[1] } };
    const double length2 = along[0] * along[0] + along[1] * along[1];
    const double t = ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / length2;
    const double at = std::clamp(t, 0.0, 1.0);
    return std::hypot(p[0] - a[0] - at * along[0], p[1] - a[1] - at * along[1]);
  }

  const ContourSet& Set;
  const ContourRegion& Region;
  Box Around;
};
}

std::optional<NearestRegion> FindNearestRegion(const ContourSet& contours,
  const ContourRegion& region, const std::vector<ContourRegion>& regions, const Level& level,
  double reach)
{
  const Finder finder(contours, region);
  std::optional<NearestRegion> nearest;
  for (int wall : level.Contours)
  {
    if (!regions[Index(wall)].Solid)
    {
      continue;
    }
    const double distance = finder.DistanceTo(regions[Index(wall)], reach);
    if (distance < reach)
    {
      reach = distance;
      nearest = NearestRegion{ wall, distance };
    }
  }
  return nearest;
}
}
