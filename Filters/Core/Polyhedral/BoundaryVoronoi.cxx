// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/BoundaryVoronoi.h"

#include "Base/DisjointSets.h"
#include "Base/StopSignal.h"
#include "Polyhedral/CrossingOrder.h"
#include "Polyhedral/Elimination.h"
#include "Polyhedral/GapChecks.h"

#include <algorithm>
#include <map>

namespace recon
{
namespace
{
using RegionPair = std::pair<int, int>;

/// A row of T12 that is left out: all of them lie inside contours of either level and are kept.
struct Gap
{
  int Own; ///< level of the Voronoi edge that it lies along
  int Edge;
  int Tetrahedron; ///< before it
  int Cell;        ///< of the other level, in which the row begins
  int Last;        ///< and in which it ends
  RegionPair Regions;
};

/// One set of crossings made into tetrahedra.
class Assembly
{
public:
  Assembly(const JointCells& cells, const SlabJoins& joins, std::vector<JointCrossing> crossings,
    UnsafeEdges& unsafe)
    : Cells(cells),
      Joins(joins),
      Order(cells, std::move(crossings)),
      Unsafe(unsafe)
  {
  }

  SlabTetrahedra Build()
  {
    this->Slab.HasGaps = true;
    AddNodesOfVoronoiVertices(this->Cells, this->Slab);
    this->FirstT12 = this->Slab.NumberOfT1 + this->Slab.NumberOfT2;
    for (const JointCrossing& crossing : this->Order.Crossings())
    {
      this->Slab.Tetrahedra.push_back({ crossing.Corners, { { -1, -1, -1, -1 } }, crossing.Edges,
        SlabTetrahedra::T12, SlabTetrahedra::Kept });
    }
    for (const int own : { 0, 1 })
    {
      const LevelTriangulation& level = this->Cells.LevelAt(own);
      for (int edge = 0; edge < static_cast<int>(3 * level.Triangles.size()); ++edge)
      {
        if (CanonicalEdge(level, edge / 3, edge % 3) == edge)
        {
          this->LinkVoronoiEdge(own, edge);
        }
      }
    }
    return std::move(this->Slab);
  }

  /// Names the pairs of tetrahedra that gaps hold together where they cross. @param slab what was
  /// built, with its Reasons.
  void LinkGaps(SlabTetrahedra& slab) const
  {
    for (const Gap& gap : this->Gaps)
    {
      this->LinkFirst(gap, slab);
    }
    // One crossing a gap nearly always shows what hangs together; where it does not, all are tried.
    DisjointSets pieces = PiecesOf(slab);
    std::map<RegionPair, std::map<int, int>> sizes;
    for (const Gap& gap : this->Gaps)
    {
      ++sizes[gap.Regions][pieces.Find(gap.Tetrahedron)];
    }
    for (const Gap& gap : this->Gaps)
    {
      const auto& of = sizes[gap.Regions];
      const auto largest = std::max_element(
        of.begin(), of.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
      if (pieces.Find(gap.Tetrahedron) != largest->first)
      {
        this->LinkAll(gap, slab);
      }
    }
  }

private:
  /// Base tetrahedron of a triangle, and which of its faces looks along an edge of the triangle.
  int BaseOf(int own, int triangle) const
  {
    return own == 0 ? triangle : this->Slab.NumberOfT1 + triangle;
  }
  static int FaceOfBase(int own, int corner)
  {
    return own == 0 || corner == 0 ? corner : 3 - corner; // T2's corners 1 and 2 are swapped
  }

  /// The face of a T12 that looks back along the Voronoi edge of the level, whose other cell it
  /// leaves: the one with that cell and without the next.
  static int FaceTowards(const SlabTetrahedra::Tetrahedron& t, int own, int cell)
  {
    const int first = own == 0 ? 2 : 0;
    return t.Corners[first] == cell ? first + 1 : first;
  }

  void LinkVoronoiEdge(int own, int edge)
  {
    ThrowIfStopped();
    const VoronoiPath path = ForthAlong(this->Cells.LevelAt(own), own, edge);
    const auto& apices = this->Cells.Apices(own);
    int previous = this->BaseOf(own, path.From);
    int face = FaceOfBase(own, edge % 3);
    int cell = apices[path.From];
    for (const int* i = this->Order.Begin(own, edge); i != this->Order.End(own, edge); ++i)
    {
      const auto cells = CrossingOrder::CellsAt(path, this->Order.Crossings()[*i]);
      const int next = this->FirstT12 + *i;
      const auto& t = this->Slab.Tetrahedra[next];
      this->Link(path, { previous, face, cell }, { next, FaceTowards(t, own, cells[0]), cells[0] });
      previous = next;
      face = FaceTowards(t, own, cells[1]);
      cell = cells[1];
    }
    if (path.To < 0)
    {
      return;
    }
    const auto& back = this->Cells.LevelAt(own).Neighbours[path.To];
    const int corner = back[0] == path.From ? 0 : (back[1] == path.From ? 1 : 2);
    this->Link(path, { previous, face, cell },
      { this->BaseOf(own, path.To), FaceOfBase(own, corner), apices[path.To] });
  }

  /// A tetrahedron on a Voronoi edge, its face along it, and the cell that the face lies in.
  struct Side
  {
    int Tetrahedron;
    int Face;
    int Cell;
  };

  void Link(const VoronoiPath& path, const Side& before, const Side& after)
  {
    const bool adjacent = before.Cell == after.Cell;
    if (!adjacent && !this->IsKeptBetween(path, before, after))
    {
      return;
    }
    this->Slab.Tetrahedra[before.Tetrahedron].Neighbours[before.Face] =
      adjacent ? after.Tetrahedron : SlabTetrahedra::GapTo(after.Tetrahedron);
    this->Slab.Tetrahedra[after.Tetrahedron].Neighbours[after.Face] =
      adjacent ? before.Tetrahedron : SlabTetrahedra::GapTo(before.Tetrahedron);
  }

  int RegionOfOther(const VoronoiPath& path, const JointCrossing& crossing) const
  {
    return RegionAtEdge(this->Cells.LevelAt(1 - path.Own), crossing.Edges[1 - path.Own]);
  }

  /// What is left out between two cells lies inside both contours, or inside one and at no external edge of the other,
  /// and is joined; if not, it lies outside both, or is not joined. Its first and its last tell. Nothing else may be
  /// left out.
  bool IsKeptBetween(const VoronoiPath& path, const Side& before, const Side& after)
  {
    const auto& level = this->Cells.LevelAt(path.Own);
    if (KindOf(level, path.Edge) == EdgeKind::External)
    {
      return false;
    }
    const auto first = this->Leave(path, before.Cell);
    const auto last = this->Leave(Reversed(path), after.Cell);
    if (!first || !last)
    {
      this->Unsafe.Mark(path.Own, path.Edge);
      return false;
    }
    const auto sides = SidesOf(this->Cells, *first);
    const int other = 1 - path.Own;
    const auto isExternal = [&](const JointCrossing& crossing)
    { return KindOf(this->Cells.LevelAt(other), crossing.Edges[other]) == EdgeKind::External; };
    if (sides != SidesOf(this->Cells, *last) ||
      (sides[path.Own] && (isExternal(*first) || isExternal(*last))))
    {
      this->Unsafe.Mark(path.Own, path.Edge);
      return false;
    }
    if (!sides[0] && !sides[1])
    {
      return false;
    }
    const int own = RegionAtEdge(level, path.Edge);
    const int otherRegion = this->RegionOfOther(path, *first);
    if (otherRegion != this->RegionOfOther(path, *last))
    {
      this->Unsafe.Mark(path.Own, path.Edge);
      return false;
    }
    const RegionPair regions =
      path.Own == 0 ? RegionPair{ own, otherRegion } : RegionPair{ otherRegion, own };
    if (!this->Joins.AreJoined(regions.first, regions.second))
    {
      return false;
    }
    this->Slab.GapRegions.insert(regions);
    this->Gaps.push_back(
      { path.Own, path.Edge, before.Tetrahedron, before.Cell, after.Cell, regions });
    return true;
  }

  std::optional<JointCrossing> Leave(const VoronoiPath& path, int cell) const
  {
    const auto& points = this->Cells.LevelAt(path.Own).Points;
    const VoronoiEdgeWalk walk(this->Cells, path.Own, points[path.A], points[path.B]);
    const auto exit = walk.Leave(cell);
    return exit && exit->Cell >= 0 ? std::make_optional(CrossingOf(this->Cells, path, cell, *exit))
                                   : std::nullopt;
  }

  /// The tetrahedron before the gap of the other level's Voronoi edge in which the crossing lies.
  int BeforeInOther(int own, const JointCrossing& crossing) const
  {
    const int edge = crossing.Edges[1 - own];
    const int before = this->Order.Before(1 - own, edge, crossing);
    const int base =
      own == 0 ? this->FirstT12 - static_cast<int>(this->Cells.LevelAt(1).Triangles.size()) : 0;
    return before >= 0 ? this->FirstT12 + before : base + edge / 3;
  }

  void LinkFirst(const Gap& gap, SlabTetrahedra& slab) const
  {
    const VoronoiPath path = ForthAlong(this->Cells.LevelAt(gap.Own), gap.Own, gap.Edge);
    slab.Links.emplace_back(
      gap.Tetrahedron, this->BeforeInOther(gap.Own, *this->Leave(path, gap.Cell)));
  }

  void LinkAll(const Gap& gap, SlabTetrahedra& slab) const
  {
    const VoronoiPath path = ForthAlong(this->Cells.LevelAt(gap.Own), gap.Own, gap.Edge);
    for (int cell = gap.Cell; cell != gap.Last;)
    {
      const auto crossing = this->Leave(path, cell);
      slab.Links.emplace_back(gap.Tetrahedron, this->BeforeInOther(gap.Own, *crossing));
      cell = CrossingOrder::CellsAt(path, *crossing)[1];
    }
  }

  const JointCells& Cells;
  const SlabJoins& Joins;
  CrossingOrder Order;
  UnsafeEdges& Unsafe;
  SlabTetrahedra Slab;
  int FirstT12 = 0;
  std::vector<Gap> Gaps;
};

std::vector<JointCrossing> FindCrossings(
  const JointCells& cells, const VoronoiSections& sections, const UnsafeEdges& unsafe)
{
  std::vector<JointCrossing> crossings;
  for (const int own : { 0, 1 })
  {
    const LevelTriangulation& level = cells.LevelAt(own);
    for (int edge = 0; edge < static_cast<int>(3 * level.Triangles.size()); ++edge)
    {
      if (CanonicalEdge(level, edge / 3, edge % 3) == edge)
      {
        sections.Find(own, edge, unsafe.IsMarked(own, edge), crossings);
      }
    }
  }
  return crossings;
}
}

SlabTetrahedra BuildBoundaryVoronoi(const JointCells& cells, const SlabJoins& joins)
{
  const VoronoiSections sections(cells);
  UnsafeEdges unsafe(cells);
  // Each round marks at least one edge more, and with all of them marked there are no gaps.
  for (;;)
  {
    const std::size_t marked = unsafe.Count();
    Assembly assembly(cells, joins, FindCrossings(cells, sections, unsafe), unsafe);
    SlabTetrahedra slab = assembly.Build();
    if (unsafe.Count() == marked)
    {
      EliminateTetrahedra(cells.LevelAt(0), cells.LevelAt(1), joins, slab);
      CheckGaps(cells, slab, unsafe);
    }
    if (unsafe.Count() == marked)
    {
      assembly.LinkGaps(slab);
      return slab;
    }
  }
}
}
