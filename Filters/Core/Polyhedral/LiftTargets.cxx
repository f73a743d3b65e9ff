// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/LiftTargets.h"

#include "Polyhedral/VertexRegions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
/// See EndShare.
constexpr double SlopeOfEnds = 0.5;
constexpr double HighestEnd = 0.5;
constexpr double HighestOutermostEnd = 0.25;

class Targets
{
public:
  Targets(const LiftSide& side, const PolyhedralOptions& options)
    : Side(side),
      Options(options),
      Level(side.Level->Triangulation),
      Regions(Level)
  {
  }

  std::vector<double> Find() const
  {
    std::vector<double> heights(this->Level.Points.size());
    const std::vector<int> triangles = this->TriangleOfRegion();
    for (std::size_t p = 0; p < heights.size(); ++p)
    {
      const double rise = triangles[p] < 0 ? 0 : this->RiseOf(static_cast<int>(p), triangles[p]);
      heights[p] =
        rise == 0 ? std::numeric_limits<double>::quiet_NaN() : this->Side.Level->Offset + rise;
    }
    return heights;
  }

private:
  /// Of every point a triangle of IR at it, or -1 outside and where several regions meet.
  std::vector<int> TriangleOfRegion() const
  {
    std::vector<int> triangles(this->Level.Points.size(), -1);
    for (std::size_t t = 0; t < this->Level.Triangles.size(); ++t)
    {
      for (int p : this->Level.Triangles[t])
      {
        if (this->Level.Inside[t] && !this->Regions.IsTouching(p))
        {
          triangles[p] = static_cast<int>(t);
        }
      }
    }
    return triangles;
  }

  /// Signed, 0 = stays.
  double RiseOf(int point, int triangle) const
  {
    const Coverage& covered = this->Side.Level->Covered;
    const double cap = this->Side.Towards * this->Side.CapThickness;
    if (covered.Isolated[triangle])
    {
      return this->Options.IsolatedContours == PolyhedralOptions::Extrude ? cap / 2 : 0;
    }
    const bool above = this->Side.Towards > 0;
    const int side = above ? LevelTriangulation::LevelAbove : LevelTriangulation::LevelBelow;
    const bool ends = (covered.Ends[triangle] & side) != 0;
    if (ends && this->Options.EndCaps == PolyhedralOptions::HalfSlice)
    {
      return cap / 2;
    }
    if (this->Level.Kind[point] != LevelTriangulation::Internal)
    {
      return 0;
    }
    const bool tapered = PolyhedralOptions::IsRounded(this->Options.EndCaps);
    if (ends)
    {
      return tapered ? this->RiseOfEnd(point, triangle) : 0;
    }
    const bool cover = (this->Level.AskedBy[point] & LevelTriangulation::Cover) != 0;
    const auto& outside = above ? this->Side.Level->OutsideAbove : this->Side.Level->OutsideBelow;
    const bool passedOver = this->Options.LiftInternalPoints && outside[point];
    if (!cover && !passedOver)
    {
      return 0;
    }
    const double dA = (*this->Side.Level->Distance)(this->Level.Points[point]);
    const double dB = (*this->Side.Neighbour->Distance)(this->Level.Points[point]);
    const double between = dA / (dA + dB);
    return (this->Side.Neighbour->Offset - this->Side.Level->Offset) *
      (tapered && passedOver ? std::max(between, this->ShareOfEnd(point)) : between);
  }

  double RiseOfEnd(int point, int triangle) const
  {
    if (this->Side.Shapes)
    {
      const auto shape = this->Side.Shapes->find(this->Level.Region[triangle]);
      if (shape != this->Side.Shapes->end())
      {
        return this->Side.Towards *
          shape->second.HeightAt((*this->Side.Level->Distance)(this->Level.Points[point]));
      }
    }
    return this->Side.Towards * this->Side.CapThickness * this->ShareOfEnd(point);
  }

  double ShareOfEnd(int point) const
  {
    const Point2& p = this->Level.Points[point];
    const auto* behind = this->Side.Behind ? this->Side.Behind->Distance.get() : nullptr;
    return EndShare(p, (*this->Side.Level->Distance)(p), behind, !this->Side.Neighbour);
  }

  const LiftSide& Side;
  const PolyhedralOptions& Options;
  const LevelTriangulation& Level;
  VertexRegions Regions;
};
}

double HighestShareOfEnd(bool beyondOutermostLevel)
{
  return beyondOutermostLevel ? HighestOutermostEnd : HighestEnd;
}

double EndShare(const Point2& point, double distance, const PlanarContourDistance* behind,
  bool beyondOutermostLevel)
{
  const double highest = HighestShareOfEnd(beyondOutermostLevel);
  // Without a level behind a wall of one in one, in slabs, is as good a guess as any.
  const double inset = behind ? (*behind)(point)-distance : distance;
  return inset * highest <= SlopeOfEnds * distance ? highest : SlopeOfEnds * distance / inset;
}

std::vector<double> FindLiftTargets(const LiftSide& side, const PolyhedralOptions& options)
{
  return Targets(side, options).Find();
}
}
