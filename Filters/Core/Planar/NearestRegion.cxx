// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/NearestRegion.h"

#include "Base/BoundingBox.h"
#include "Planar/EdgeTree.h"

#include <cstddef>

namespace recon
{
namespace
{
class Finder
{
public:
  Finder(const ContourSet& set, const ContourRegion& region)
    : Set(set),
      Around(this->BoxOf(region.Wall)),
      Borders(this->BordersOf(region))
  {
  }

  /// No more than `reach`, which is returned where the region is farther away.
  double DistanceTo(const ContourRegion& other, double reach) const
  {
    if (!this->BoxOf(other.Wall).Grown(reach).Meets(this->Around))
    {
      return reach;
    }
    for (const PlanarSegment& border : this->BordersOf(other))
    {
      reach = this->Borders.DistanceWithin(border, reach);
    }
    return reach;
  }

private:
  const Point2& At(int p) const { return this->Set.Planar[p]; }

  Box2 BoxOf(int contour) const
  {
    Box2 box;
    for (int p : this->Set.Contours[contour].Points)
    {
      box.Add(this->At(p));
    }
    return box;
  }

  std::vector<PlanarSegment> BordersOf(const ContourRegion& region) const
  {
    std::vector<int> contours = region.Holes;
    contours.push_back(region.Wall);
    std::vector<PlanarSegment> borders;
    for (int c : contours)
    {
      const std::vector<int>& p = this->Set.Contours[c].Points;
      for (std::size_t i = 0; i < p.size(); ++i)
      {
        borders.push_back({ this->At(p[i]), this->At(p[(i + 1) % p.size()]) });
      }
    }
    return borders;
  }

  const ContourSet& Set;
  Box2 Around;
  EdgeTree Borders;
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
    if (!regions[wall].Solid)
    {
      continue;
    }
    const double distance = finder.DistanceTo(regions[wall], reach);
    if (distance < reach)
    {
      reach = distance;
      nearest = NearestRegion{ wall, distance };
    }
  }
  return nearest;
}
}
