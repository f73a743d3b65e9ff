// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourMeasures.h
 * @brief Boxes, widths and heights of contours and levels.
 */
#ifndef recon_ContourMeasures_h
#define recon_ContourMeasures_h

#include "Base/BoundingBox.h"
#include "Contours/ContourSet.h"

#include <cmath>
#include <vector>

namespace recon
{
/// In the plane of their level, around the contours of those numbers; empty for none.
inline Box2 PlanarBounds(const ContourSet& contours, const std::vector<int>& numbers)
{
  Box2 box;
  for (const int c : numbers)
  {
    for (const int p : contours.Contours[c].Points)
    {
      box.Add(contours.Planar[p]);
    }
  }
  return box;
}

/// Twice the area over the length: the width of what is long and narrow.
inline double MeanWidth(const ContourSet& contours, const Contour& contour)
{
  return 2 * std::abs(contour.SignedArea) / LengthAlong(contours.Points, contour.Points);
}

/// The offset of a plane along a normal that is its own or the opposite one.
inline double OffsetAlong(const Vector3& normal, const Vector3& normalOfPlane, double offset)
{
  return offset * (Dot(normalOfPlane, normal) < 0 ? -1 : 1);
}

inline double HeightOf(const Level& level, const Vector3& normal)
{
  return OffsetAlong(normal, level.Frame.Normal, level.Offset);
}
}

#endif
