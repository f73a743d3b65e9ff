// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/ContourTips.h"

#include "Base/BoundingBox.h"
#include "Base/Median.h"
#include "Contours/ContourMeasures.h"
#include "Planar/PlanarEdges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace recon
{
namespace
{
/// w is below this part of the distance to the wall of the section beside it. A cap that is round
/// from there on is then lower than 1% of the gap: the contour is the end of the solid.
constexpr double TipSlenderness = 0.1;
/// Depth in the section beside a tip, as a part of the gap, from which the surface lies flat there.
constexpr double FlatSlope = 0.5;
/// Levels whose normals agree at least this much (cosine) count as parallel.
constexpr double ParallelCosine = 0.9;
/// Vertices looked at for the gap: it is a median, which a sample tells as well.
constexpr std::size_t GapSamples = 200;

/// What a contour meets on one side: the nearest level, how far, and how deep it is inside there.
struct Side
{
  double Gap = std::numeric_limits<double>::infinity();
  int Level = -1;
  double Depth = -std::numeric_limits<double>::infinity(); ///< negative = outside
};

class TipFinder
{
public:
  explicit TipFinder(const ContourSet& contours) : Contours(contours) {}

  ContourTip At(const Contour& contour)
  {
    if (contour.Depth % 2 != 0)
    {
      return {};
    }
    const double width = MeanWidth(this->Contours, contour);
    Side up = this->Nearest(contour, 1);
    Side down = this->Nearest(contour, -1);
    const double widest = TipSlenderness * this->Diagonal;
    if ((up.Level < 0 && down.Level < 0) || (this->Diagonal > 0 && width > widest))
    {
      return {};
    }
    this->Measure(contour, 1, up);
    this->Measure(contour, -1, down);
    // A section whose wall passes through the contour counts as met.
    const bool above = up.Depth > -width;
    const bool below = down.Depth > -width;
    const Side& solid = above ? up : down;
    if (above == below || width >= TipSlenderness * std::hypot(solid.Depth, solid.Gap))
    {
      return {};
    }
    return { above ? 1 : -1, solid.Depth >= FlatSlope * solid.Gap };
  }

  double Diagonal = 0;

private:
  /// The nearest level beyond all of the contour.
  Side Nearest(const Contour& contour, int sign) const
  {
    Side side;
    const Vector3& normal = this->Contours.Levels[contour.Level].Frame.Normal;
    const Point3& p = this->Contours.Points[contour.Points.front()];
    for (int l = 0; l < static_cast<int>(this->Contours.Levels.size()); ++l)
    {
      const Level& level = this->Contours.Levels[l];
      const double cosine = Dot(level.Frame.Normal, normal);
      if (l == contour.Level || std::abs(cosine) < ParallelCosine)
      {
        continue;
      }
      const double gap = sign * (level.Offset - Dot(level.Frame.Normal, p)) / cosine;
      if (gap > 0 && gap < side.Gap)
      {
        side.Gap = gap;
        side.Level = l;
      }
    }
    return side;
  }

  /// The largest depth of the contour's vertices, seen along the normal, in that level's section.
  void Measure(const Contour& contour, int sign, Side& side)
  {
    if (side.Level < 0)
    {
      return;
    }
    const Vector3& normal = this->Contours.Levels[contour.Level].Frame.Normal;
    const PlanarEdges& section = this->Section(side.Level);
    for (const int v : contour.Points)
    {
      const Point3 p = this->Contours.Points[v] + (sign * side.Gap) * normal;
      const Point2 at = this->Contours.Levels[side.Level].Frame.ToPlane(p);
      // No vertex is left out: -1 is none.
      const double distance = section.DistanceToOthers(-1, at, std::numeric_limits<double>::max());
      const bool inside = section.SideOf(at) != PlanarEdges::Outside;
      side.Depth = std::max(side.Depth, inside ? distance : -distance);
    }
  }

  const PlanarEdges& Section(int level)
  {
    const auto found = this->Sections.find(level);
    return found != this->Sections.end()
      ? found->second
      : this->Sections.emplace(level, PlanarEdges(this->Contours, level)).first->second;
  }

  const ContourSet& Contours;
  std::map<int, PlanarEdges> Sections;
};

double DiagonalOf(const ContourSet& contours)
{
  Box3 box;
  for (const Contour& contour : contours.Contours)
  {
    for (const int p : contour.Points)
    {
      box.Add(contours.Points[p]);
    }
  }
  return box.Diagonal();
}
}

std::vector<ContourTip> FindTips(const ContourSet& contours)
{
  std::vector<ContourTip> tips;
  if (contours.Contours.empty())
  {
    return tips;
  }
  TipFinder finder(contours);
  finder.Diagonal = DiagonalOf(contours);
  for (const Contour& contour : contours.Contours)
  {
    tips.push_back(finder.At(contour));
  }
  return tips;
}

double TypicalGap(const ContourSet& contours)
{
  std::vector<std::pair<int, Point3>> vertices; // level, place
  for (const Contour& contour : contours.Contours)
  {
    for (const int p : contour.Points)
    {
      vertices.emplace_back(contour.Level, contours.Points[p]);
    }
  }
  const std::size_t step = std::max<std::size_t>(1, vertices.size() / GapSamples);
  std::vector<double> gaps;
  for (std::size_t i = 0; i < vertices.size(); i += step)
  {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [level, place] : vertices)
    {
      least =
        level == vertices[i].first ? least : std::min(least, Norm(place - vertices[i].second));
    }
    gaps.push_back(least);
  }
  const double middle = Median(gaps);
  return std::isfinite(middle) ? middle : 0;
}
}
