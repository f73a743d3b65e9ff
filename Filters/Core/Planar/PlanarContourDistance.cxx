// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/PlanarContourDistance.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <vector>

namespace recon
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Edge = Kernel::Segment_3;
using Primitive = CGAL::AABB_segment_primitive<Kernel, std::vector<Edge>::const_iterator>;

Kernel::Point_3 At(const Point2& p)
{
  return { p[0], p[1], 0 };
}
}

struct PlanarContourDistance::Implementation
{
  std::vector<Edge> Edges;
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;
};

PlanarContourDistance::PlanarContourDistance(const LevelTriangulation& level)
  : Impl(std::make_unique<Implementation>())
{
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (level.EdgeContour[t][k] >= 0 && level.Inside[t])
      {
        const auto& corners = level.Triangles[t];
        this->Impl->Edges.emplace_back(
          At(level.Points[corners[(k + 1) % 3]]), At(level.Points[corners[(k + 2) % 3]]));
      }
    }
  }
  this->Impl->Tree.rebuild(this->Impl->Edges.begin(), this->Impl->Edges.end());
  this->Impl->Tree
    .build(); // now, as the first of several threads to ask must not be the one to build
}

PlanarContourDistance::~PlanarContourDistance() = default;

double PlanarContourDistance::operator()(const Point2& p) const
{
  return std::sqrt(this->Impl->Tree.squared_distance(At(p)));
}
}
