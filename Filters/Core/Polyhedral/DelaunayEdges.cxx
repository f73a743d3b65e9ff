// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/DelaunayEdges.h"

#include "Polyhedral/JointVoronoiPredicates.h"

namespace recon
{
EdgeKind KindOf(const LevelTriangulation& level, int edge)
{
  const int triangle = edge / 3;
  if (level.EdgeContour[triangle][edge % 3] >= 0)
  {
    return EdgeKind::Contour;
  }
  return level.Inside[triangle] ? EdgeKind::Internal : EdgeKind::External;
}

int ContourAtEdge(const LevelTriangulation& level, int edge)
{
  return level.EdgeContour[edge / 3][edge % 3];
}

int RegionAtEdge(const LevelTriangulation& level, int edge)
{
  const int region = level.Region[edge / 3];
  return region >= 0 ? region : level.Region[level.Neighbours[edge / 3][edge % 3]];
}

bool IsNodeOutside(const LevelTriangulation& level, int edge, const Point2& u, const Point2& v)
{
  const auto& corners = level.Triangles[edge / 3];
  const Point2& p = level.Points[corners[(edge + 1) % 3]];
  const Point2& q = level.Points[corners[(edge + 2) % 3]];
  const int side = SideOfNode(p, q, u, v);
  return level.Inside[edge / 3] ? side < 0 : side > 0;
}
}
