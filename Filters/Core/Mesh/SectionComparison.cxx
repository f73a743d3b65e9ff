// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SectionComparison.h"

#include "Base/Parallel.h"
#include "Base/PointHash.h"
#include "Base/Predicates.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/TriangleTree.h"
#include "Planar/PlanarDifference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace recon
{
namespace
{
/// Levels of one normal, and the triangles that reach each of their planes.
struct LevelGroup
{
  std::vector<int> Levels;
  std::vector<double> Heights;             ///< of every mesh point, along the normal
  std::vector<std::vector<int>> Triangles; ///< a level of the group
};

double LargestCoordinate(const TriangleMesh& mesh)
{
  double largest = 0;
  for (const auto& p : mesh.Points)
  {
    largest = std::max({ largest, std::fabs(p[0]), std::fabs(p[1]), std::fabs(p[2]) });
  }
  return largest;
}

/// How far from its plane a point may be and still lie in it.
std::vector<double> ToleranceOfLevels(
  const TriangleMesh& mesh, const ContourSet& contours, const SectionOptions& options)
{
  const double rounding = options.CoordinateRounding +
    8 * std::numeric_limits<double>::epsilon() * LargestCoordinate(mesh);
  std::vector<double> tolerance(contours.Levels.size(), rounding);
  for (const auto& contour : contours.Contours)
  {
    const Level& level = contours.Levels[contour.Level];
    for (const int p : contour.Points)
    {
      const double off = std::fabs(level.Frame.OffsetOf(contours.Points[p]) - level.Offset);
      tolerance[contour.Level] = std::max(tolerance[contour.Level], off + rounding);
    }
  }
  return tolerance;
}

std::vector<LevelGroup> GroupLevels(const TriangleMesh& mesh, const ContourSet& contours)
{
  std::vector<LevelGroup> groups;
  for (std::size_t l = 0; l < contours.Levels.size(); ++l)
  {
    const PlanarFrame& frame = contours.Levels[l].Frame;
    const auto group = std::find_if(groups.begin(), groups.end(),
      [&](const LevelGroup& g)
      { return contours.Levels[g.Levels.front()].Frame.Normal == frame.Normal; });
    if (group != groups.end())
    {
      group->Levels.push_back(static_cast<int>(l));
      continue;
    }
    groups.emplace_back();
    groups.back().Levels.push_back(static_cast<int>(l));
    for (const auto& p : mesh.Points)
    {
      groups.back().Heights.push_back(frame.OffsetOf(p));
    }
  }
  for (auto& group : groups)
  {
    std::sort(group.Levels.begin(), group.Levels.end(),
      [&](int a, int b) { return contours.Levels[a].Offset < contours.Levels[b].Offset; });
  }
  return groups;
}

void FindTriangles(const TriangleMesh& mesh, const ContourSet& contours,
  const std::vector<double>& tolerance, LevelGroup& group)
{
  const double widest = *std::max_element(tolerance.begin(), tolerance.end());
  group.Triangles.resize(group.Levels.size());
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const auto& corners = mesh.Triangles[t];
    const auto [low, high] = std::minmax(
      { group.Heights[corners[0]], group.Heights[corners[1]], group.Heights[corners[2]] });
    const double from = low - widest;
    const double to = high + widest;
    auto level = std::lower_bound(group.Levels.begin(), group.Levels.end(), from,
      [&](int l, double h) { return contours.Levels[l].Offset < h; });
    for (; level != group.Levels.end() && contours.Levels[*level].Offset <= to; ++level)
    {
      group.Triangles[level - group.Levels.begin()].push_back(static_cast<int>(t));
    }
  }
}

/// A corner of a triangle, seen from the plane.
struct Corner
{
  double Height; ///< above the plane; 0 where it lies in it
  Point2 Planar;
};

/// Where the side from a corner below to one above meets the plane: the same whichever triangle
/// asks.
Point2 Meet(const Corner& below, const Corner& above)
{
  if (below.Height == 0)
  {
    return below.Planar;
  }
  if (above.Height == 0)
  {
    return above.Planar;
  }
  const double t = below.Height / (below.Height - above.Height);
  return { below.Planar[0] + t * (above.Planar[0] - below.Planar[0]),
    below.Planar[1] + t * (above.Planar[1] - below.Planar[1]) };
}

/// The segment that a triangle contributes; a corner in the plane counts as above it, or else as
/// below.
void Cut(const std::array<Corner, 3>& corners, bool inPlaneIsAbove, PlanarRegions::LayerType layer,
  PlanarRegions& regions)
{
  const auto isAbove = [inPlaneIsAbove](const Corner& c)
  { return inPlaneIsAbove ? c.Height >= 0 : c.Height > 0; };
  std::array<Point2, 2> ends{};
  int count = 0;
  for (int k = 0; k < 3; ++k)
  {
    const Corner& a = corners[k];
    const Corner& b = corners[(k + 1) % 3];
    if (isAbove(a) != isAbove(b))
    {
      ends[count++] = isAbove(a) ? Meet(b, a) : Meet(a, b);
    }
  }
  if (count == 2 && ends[0] != ends[1])
  {
    regions.Segments.push_back({ ends[0], ends[1], layer });
  }
}

/// A face in the plane, counterclockwise, whichever way it was.
void AddFace(const std::array<Corner, 3>& corners, PlanarRegions& regions)
{
  const int turn = Orientation2(corners[0].Planar, corners[1].Planar, corners[2].Planar);
  for (int k = 0; k < 3 && turn != 0; ++k)
  {
    const Point2& a = corners[k].Planar;
    const Point2& b = corners[(k + 1) % 3].Planar;
    regions.Segments.push_back({ turn > 0 ? a : b, turn > 0 ? b : a, PlanarRegions::InPlane });
  }
}

/// What one level is compared by.
struct LevelCut
{
  const TriangleMesh& Mesh;
  const std::vector<double>& Heights;
  const std::vector<int>& Triangles;
  const Level& Plane;
  double Tolerance;

  std::array<Corner, 3> CornersOf(int triangle) const
  {
    std::array<Corner, 3> corners{};
    for (int k = 0; k < 3; ++k)
    {
      const int p = this->Mesh.Triangles[triangle][k];
      const double height = this->Heights[p] - this->Plane.Offset;
      corners[k].Height = std::fabs(height) <= this->Tolerance ? 0 : height;
      corners[k].Planar = this->Plane.Frame.ToPlane(this->Mesh.Points[p]);
    }
    return corners;
  }

  void AddTo(PlanarRegions& regions) const
  {
    for (const int t : this->Triangles)
    {
      const auto corners = this->CornersOf(t);
      const bool inPlane =
        corners[0].Height == 0 && corners[1].Height == 0 && corners[2].Height == 0;
      if (inPlane)
      {
        AddFace(corners, regions);
        continue;
      }
      Cut(corners, true, PlanarRegions::Below, regions);
      Cut(corners, false, PlanarRegions::Above, regions);
    }
  }
};

void AddContours(const ContourSet& contours, int level, PlanarRegions& regions)
{
  for (const int c : contours.Levels[level].Contours)
  {
    const auto& points = contours.Contours[c].Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      regions.Segments.push_back({ contours.Planar[points[i]],
        contours.Planar[points[(i + 1) % points.size()]], PlanarRegions::Contour });
    }
  }
}

SectionDifference CompareLevel(const LevelCut& cut, const ContourSet& contours, int level)
{
  PlanarRegions regions;
  cut.AddTo(regions);
  AddContours(contours, level, regions);
  const PlanarDifference measured = MeasurePlanarDifference(regions);
  SectionDifference result;
  result.Level = level;
  result.Offset = contours.Levels[level].Offset;
  result.ContourArea = measured.ContourArea;
  if (!measured.SurfaceIsClosed)
  {
    return result;
  }
  result.SurfaceArea = measured.SurfaceArea;
  result.SymmetricDifference = measured.SymmetricDifference;
  if (measured.ContourArea > 0)
  {
    result.Percent = 100 * measured.SymmetricDifference / measured.ContourArea;
  }
  return result;
}

/// What one contour adds to a ContourDistance; put together in order.
struct DistanceSums
{
  double FarthestVertex = 0;
  double VertexSum = 0;
  double FarthestEdge = 0;
  double EdgeSum = 0; ///< distance times length
  double Length = 0;
  Point3 FarthestVertexAt{ 0, 0, 0 };
  Point3 FarthestEdgeAt{ 0, 0, 0 };
};

/// The triangles that have a corner in a place, as nearly every contour vertex is one.
class CornerTable
{
public:
  explicit CornerTable(const TriangleMesh& mesh) : First(mesh.Points.size() + 1, 0)
  {
    for (const std::array<int, 3>& corners : mesh.Triangles)
    {
      for (const int point : corners)
      {
        ++this->First[static_cast<std::size_t>(point) + 1];
      }
    }
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    this->Triangles.resize(static_cast<std::size_t>(this->First.back()));
    std::vector<int> next(this->First.begin(), this->First.end() - 1);
    this->PointAt.reserve(mesh.Points.size());
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      for (const int point : mesh.Triangles[t])
      {
        const auto number = static_cast<std::size_t>(next[static_cast<std::size_t>(point)]++);
        this->Triangles[number] = static_cast<int>(t);
        this->PointAt.emplace(mesh.Points[static_cast<std::size_t>(point)], point);
      }
    }
  }

  /// Those of one of the points there.
  std::vector<int> At(const Point3& place) const
  {
    const auto found = this->PointAt.find(place);
    if (found == this->PointAt.end())
    {
      return {};
    }
    const auto point = static_cast<std::size_t>(found->second);
    return { this->Triangles.begin() + this->First[point],
      this->Triangles.begin() + this->First[point + 1] };
  }

private:
  std::vector<int> First; ///< of each point, in Triangles
  std::vector<int> Triangles;
  std::unordered_map<Point3, int, PointHash> PointAt;
};

/// Distance to the mesh, of which some triangles are known to be near.
double DistanceFrom(const Point3& p, const TriangleTree& tree, const std::vector<int>& near)
{
  double best = std::numeric_limits<double>::infinity();
  for (const int triangle : near)
  {
    best = std::min(best, tree.SquaredDistanceToTriangle(p, triangle));
  }
  return best > 0 ? std::sqrt(tree.SquaredDistanceTo(p, best)) : 0;
}

DistanceSums MeasureContour(const TriangleTree& tree, const CornerTable& corners,
  const ContourSet& contours, const Contour& contour)
{
  DistanceSums sums;
  for (std::size_t i = 0; i < contour.Points.size(); ++i)
  {
    const Point3& a = contours.Points[contour.Points[i]];
    const Point3& b = contours.Points[contour.Points[(i + 1) % contour.Points.size()]];
    const std::vector<int> near = corners.At(a);
    const double distance = DistanceFrom(a, tree, near);
    sums.VertexSum += distance;
    if (distance >= sums.FarthestVertex)
    {
      sums.FarthestVertex = distance;
      sums.FarthestVertexAt = a;
    }
    const double length = Norm(b - a);
    for (const double t : { 0.25, 0.5, 0.75 })
    {
      const Point3 p = (1 - t) * a + t * b;
      const double off = DistanceFrom(p, tree, near);
      sums.EdgeSum += off * length;
      sums.Length += length;
      if (off >= sums.FarthestEdge)
      {
        sums.FarthestEdge = off;
        sums.FarthestEdgeAt = p;
      }
    }
  }
  return sums;
}
}

std::vector<SectionDifference> CompareSections(const TriangleMesh& mesh, const ContourSet& contours,
  const SectionOptions& options, Monitor& monitor)
{
  constexpr const char* stage = "comparing sections";
  RequireUsable(mesh);
  std::vector<SectionDifference> result(contours.Levels.size());
  if (contours.Levels.empty())
  {
    return result;
  }
  const auto tolerance = ToleranceOfLevels(mesh, contours, options);
  auto groups = GroupLevels(mesh, contours);
  double done = 0;
  for (auto& group : groups)
  {
    monitor.Update(done, stage);
    FindTriangles(mesh, contours, tolerance, group);
    const int count = static_cast<int>(group.Levels.size());
    const auto work = [&](int i)
    {
      const int level = group.Levels[i];
      const LevelCut cut{ mesh, group.Heights, group.Triangles[i], contours.Levels[level],
        tolerance[level] };
      result[level] = CompareLevel(cut, contours, level);
    };
    const double next = done + count / static_cast<double>(result.size());
    ParallelFor(count, options.Threads, work, monitor, { done, std::min(1.0, next), stage });
    done = std::min(1.0, next);
  }
  return result;
}

std::optional<ContourDistance> MeasureContourDistance(const TriangleMesh& mesh,
  const TriangleTree& tree, const ContourSet& contours, int threads, Monitor& monitor)
{
  if (mesh.Triangles.empty() || contours.Contours.empty())
  {
    return std::nullopt;
  }
  const int count = static_cast<int>(contours.Contours.size());
  std::vector<DistanceSums> sums(count);
  const CornerTable corners(mesh);
  ParallelFor(count, threads,
    [&](int c) { sums[c] = MeasureContour(tree, corners, contours, contours.Contours[c]); },
    monitor, { 0, 1, "measuring distances" });
  ContourDistance result;
  double edgeSum = 0, length = 0;
  Point3 vertexAt{}, edgeAt{};
  for (int c = 0; c < count; ++c)
  {
    result.Vertices += static_cast<int>(contours.Contours[c].Points.size());
    result.MeanVertex += sums[c].VertexSum;
    edgeSum += sums[c].EdgeSum;
    length += sums[c].Length;
    if (sums[c].FarthestVertex >= result.FarthestVertex)
    {
      result.FarthestVertex = sums[c].FarthestVertex;
      vertexAt = sums[c].FarthestVertexAt;
    }
    if (sums[c].FarthestEdge >= result.FarthestEdge)
    {
      result.FarthestEdge = sums[c].FarthestEdge;
      edgeAt = sums[c].FarthestEdgeAt;
    }
  }
  result.MeanVertex /= std::max(1, result.Vertices);
  result.MeanEdge = length > 0 ? edgeSum / length : 0;
  result.FarthestAt = result.FarthestVertex >= result.FarthestEdge ? vertexAt : edgeAt;
  return result;
}
}
