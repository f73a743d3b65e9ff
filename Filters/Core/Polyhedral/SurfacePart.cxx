// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/SurfacePart.h"

#include <algorithm>
#include <map>
#include <utility>

namespace recon
{
namespace
{
/// Where a vertex stands among all of a stack: those in planes by level, then those that slabs lifted, below the first
/// level and above the last one, tips of pyramids.
std::uint64_t OrderOf(const PolyhedralStages& stages, const SolidComplex::Vertex& vertex)
{
  enum : std::uint64_t
  {
    InPlane,
    InSlab,
    BelowFirst,
    AboveLast,
    Tip
  };
  const auto order = [](std::uint64_t kind, int number, std::uint64_t local)
  { return kind << 61 | static_cast<std::uint64_t>(number) << 32 | local; };
  const auto local = static_cast<std::uint32_t>(vertex.Local);
  if (!vertex.Lifted)
  {
    return order(InPlane, vertex.Level, local);
  }
  if (vertex.Local < 0)
  {
    return order(Tip, vertex.Level, 0);
  }
  const bool up = vertex.Height > stages.Levels[vertex.Level].Offset;
  const int slab = up ? vertex.Level : vertex.Level - 1;
  if (slab < 0 || slab == static_cast<int>(stages.Slabs.size()))
  {
    return order(slab < 0 ? BelowFirst : AboveLast, 0, local);
  }
  constexpr std::uint64_t ofUpperLevel = std::uint64_t{ 1 } << 31;
  return order(InSlab, slab, up ? local : local | ofUpperLevel);
}

/// Where points of space are, and what they are.
class PointReader
{
public:
  PointReader(const ContourSet& contours, const PolyhedralStages& stages)
    : Contours(contours),
      Stages(stages),
      Round(contours.Levels[0].Grid > 0 || !stages.Alignment.IsEmpty())
  {
  }

  PointOnSurface Read(const SolidComplex::Vertex& vertex) const
  {
    const Point3 position = this->PositionOf(vertex);
    const bool isExact = vertex.Local >= 0 && !this->Round &&
      position == this->Contours.Levels[0].Frame.ToSpace(vertex.Planar, vertex.Height);
    return { position, this->KindOf(vertex), isExact };
  }

  Point3 PositionOf(const SolidComplex::Vertex& vertex) const
  {
    const int source =
      vertex.Lifted ? -1 : this->Stages.Levels[vertex.Level].Triangulation.Source[vertex.Local];
    return source >= 0
      ? this->Contours.Points[source]
      : this->Contours.Levels[0].Frame.ToSpace(
          this->Stages.Alignment.Undo(vertex.Planar, vertex.Height), vertex.Height);
  }

private:
  /// A lifted copy of a contour point is not the contour's.
  int KindOf(const SolidComplex::Vertex& vertex) const
  {
    return vertex.Lifted ? static_cast<int>(LevelTriangulation::Internal)
                         : this->Stages.Levels[vertex.Level].Triangulation.Kind[vertex.Local];
  }

  const ContourSet& Contours;
  const PolyhedralStages& Stages;
  const bool
    Round; ///< points of space differ from those in whose coordinates the topology was decided
};

void ReadPoints(const ContourSet& contours, const PolyhedralStages& stages, SurfacePart& part)
{
  const PointReader reader(contours, stages);
  const auto& vertices = part.Solid.Vertices;
  part.Points.reserve(part.Boundary.Points.size());
  std::map<std::pair<std::uint64_t, std::uint64_t>, int> seen;
  for (const SolidBoundary::Point& point : part.Boundary.Points)
  {
    const SolidComplex::Vertex& vertex = vertices[point.Vertex];
    if (point.OtherVertex < 0)
    {
      part.Points.push_back(reader.Read(vertex));
      continue;
    }
    const SolidComplex::Vertex& other = vertices[point.OtherVertex];
    part.Points.push_back({ 0.5 * (reader.PositionOf(vertex) + reader.PositionOf(other)),
      LevelTriangulation::Internal, false });
    const std::pair<std::uint64_t, std::uint64_t> ends =
      std::minmax({ OrderOf(stages, vertex), OrderOf(stages, other) });
    part.Halved.emplace_back(ends.first, ends.second, seen[ends]++);
  }
}
}

std::size_t SurfacePart::FirstFaceOf(int cell) const
{
  const auto& faces = this->Boundary.Faces;
  const auto found = std::partition_point(faces.begin(), faces.begin() + this->Boundary.WholeFaces,
    [&](const SolidBoundary::Face& face) { return face.Cell < cell; });
  return static_cast<std::size_t>(found - faces.begin());
}

SurfacePart BuildSurfacePart(const ContourSet& contours, const PolyhedralStages& stages,
  const FaceGroups& groups, const SlabRange& slabs)
{
  SurfacePart part;
  part.Slabs = slabs;
  const int count = static_cast<int>(stages.Slabs.size());
  part.Solid = BuildSolidComplex(
    stages.Levels, stages.Slabs, { std::max(0, slabs.First - 1), std::min(count, slabs.End + 1) });
  part.Boundary = ExtractSolidBoundary(part.Solid);
  part.Pieces = FindPieces(part.Solid);
  part.Groups = groups.Find(stages.Levels, part.Solid, part.Boundary, part.Pieces);
  ReadPoints(contours, stages, part);
  return part;
}

bool LiesInPlane(const SurfacePart& part, const std::array<int, 3>& face)
{
  const auto vertexOf = [&](int point) -> const SolidComplex::Vertex&
  { return part.Solid.Vertices[part.Boundary.Points[point].Vertex]; };
  const int level = vertexOf(face[0]).Level;
  return std::all_of(face.begin(), face.end(),
    [&](int point) { return !vertexOf(point).Lifted && vertexOf(point).Level == level; });
}

double VolumeOf(const SolidComplex& solid, const SolidComplex::Cell& cell)
{
  const auto at = [&](int k)
  {
    const auto& v = solid.Vertices[cell.Vertices[k]];
    return Point3{ v.Planar[0], v.Planar[1], v.Height };
  };
  return Dot(at(1) - at(0), Cross(at(2) - at(0), at(3) - at(0))) / 6;
}
}
