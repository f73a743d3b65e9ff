// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/SolidComplex.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
using Cell = SolidComplex::Cell;

/// A face of the complex: opposite vertex Face of cell Cell, or none.
struct Side
{
  int Cell = -1;
  int Face = -1;
};

class Builder
{
public:
  Builder(const std::vector<LevelState>& levels, const std::vector<SlabState>& slabs,
    const SlabRange& range)
    : Levels(levels),
      Slabs(slabs),
      Range(range)
  {
    this->Complex.Slabs = range;
  }

  SolidComplex Build()
  {
    this->AddPlanarVertices();
    this->ReserveCells();
    // By level: the faces that the solid shows to the plane from above and from below.
    const int levels = this->Range.End - this->Range.First + 1;
    std::vector<std::vector<Side>> above(levels);
    std::vector<std::vector<Side>> below(levels);
    for (int i = 0; i < levels; ++i)
    {
      const std::size_t count = this->LevelOf(i).Triangulation.Triangles.size();
      above[i].resize(count);
      below[i].resize(count);
    }
    for (int i = 0; i + 1 < levels; ++i)
    {
      this->AddSlab(this->Range.First + i, above[i], below[i + 1]);
    }
    this->Complex.FirstCell.push_back(static_cast<int>(this->Complex.Cells.size()));
    const int last = static_cast<int>(this->Slabs.size());
    const bool hasFirst = this->Range.First == 0;
    const bool hasLast = this->Range.End == last;
    if (hasFirst)
    {
      this->FillGap(
        -1, 0, this->AddLiftedVertices(0, this->Levels[0].Lifted.Below), nullptr, below.front());
    }
    if (hasLast)
    {
      this->FillGap(last, last, this->AddLiftedVertices(last, this->Levels[last].Lifted.Above),
        nullptr, above.back());
    }
    // What lies beyond the planes of a part's first and last level is not known.
    for (int i = hasFirst ? 0 : 1; i < (hasLast ? levels : levels - 1); ++i)
    {
      this->JoinAcrossPlane(this->Range.First + i, above[i], below[i]);
    }
    return std::move(this->Complex);
  }

private:
  /// Those between the levels and those that lift; the few others find room as vectors make it.
  void ReserveCells()
  {
    std::size_t kept = 0;
    for (int slab = this->Range.First; slab < this->Range.End; ++slab)
    {
      const auto& tetrahedra = this->Slabs[slab].Diagram.Tetrahedra;
      kept += std::count_if(tetrahedra.begin(), tetrahedra.end(),
        [](const auto& t) { return t.Reason == SlabTetrahedra::Kept; });
    }
    for (int level = this->Range.First; level <= this->Range.End; ++level)
    {
      const LevelState& of = this->Levels[level];
      kept += CountLiftedCorners(of.Triangulation, of.Lifted.Below) +
        CountLiftedCorners(of.Triangulation, of.Lifted.Above);
    }
    this->Complex.Cells.reserve(kept + kept / 64);
  }

  /// Each gets a cell.
  static std::size_t CountLiftedCorners(
    const LevelTriangulation& level, const std::vector<double>& heights)
  {
    std::size_t count = 0;
    for (std::size_t t = 0; t < level.Triangles.size() && !heights.empty(); ++t)
    {
      const auto& corners = level.Triangles[t];
      count += level.Inside[t]
        ? std::count_if(corners.begin(), corners.end(),
            [&](std::size_t p) { return p < heights.size() && !std::isnan(heights[p]); })
        : 0;
    }
    return count;
  }

  const LevelState& LevelOf(int i) const { return this->Levels[this->Range.First + i]; }

  /// Of a point of a level of the range, in its plane.
  int VertexOf(int level, int point) const
  {
    return this->FirstVertex[level - this->Range.First] + point;
  }

  void AddPlanarVertices()
  {
    for (int level = this->Range.First; level <= this->Range.End; ++level)
    {
      const auto& points = this->Levels[level].Triangulation.Points;
      this->FirstVertex.push_back(static_cast<int>(this->Complex.Vertices.size()));
      for (std::size_t p = 0; p < points.size(); ++p)
      {
        this->Complex.Vertices.push_back(
          { points[p], this->Levels[level].Offset, level, static_cast<int>(p), false });
      }
    }
  }

  /// The vertices of a level as one of its slabs sees them: lifted copies where there are any.
  std::vector<int> AddLiftedVertices(int level, const std::vector<double>& heights)
  {
    const auto& points = this->Levels[level].Triangulation.Points;
    std::vector<int> seen(points.size());
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      seen[p] = this->VertexOf(level, static_cast<int>(p));
      if (p < heights.size() && !std::isnan(heights[p]))
      {
        seen[p] = static_cast<int>(this->Complex.Vertices.size());
        this->Complex.Vertices.push_back(
          { points[p], heights[p], level, static_cast<int>(p), true });
      }
    }
    return seen;
  }

  void AddSlab(int slab, std::vector<Side>& aboveLower, std::vector<Side>& belowUpper)
  {
    this->Complex.FirstCell.push_back(static_cast<int>(this->Complex.Cells.size()));
    this->Lower.push_back(this->AddLiftedVertices(slab, this->Levels[slab].Lifted.Above));
    this->Upper.push_back(this->AddLiftedVertices(slab + 1, this->Levels[slab + 1].Lifted.Below));
    const std::vector<int>& lower = this->Lower.back();
    const std::vector<int>& upper = this->Upper.back();
    const auto& tetrahedra = this->Slabs[slab].Diagram.Tetrahedra;

    std::vector<int> cellOf(tetrahedra.size(), -1);
    int next = static_cast<int>(this->Complex.Cells.size());
    for (std::size_t i = 0; i < tetrahedra.size(); ++i)
    {
      cellOf[i] = tetrahedra[i].Reason == SlabTetrahedra::Kept ? next++ : -1;
    }
    for (const auto& t : tetrahedra)
    {
      if (t.Reason != SlabTetrahedra::Kept)
      {
        continue;
      }
      Cell cell{ {}, {}, slab, SolidComplex::BetweenLevels };
      for (int k = 0; k < 4; ++k)
      {
        cell.Vertices[k] =
          SlabTetrahedra::OnLevel2(t, k) ? upper[t.Corners[k]] : lower[t.Corners[k]];
        cell.Neighbours[k] = NeighbourOf(t.Neighbours[k], cellOf);
      }
      this->Complex.Cells.push_back(cell);
    }
    for (const auto& link : this->Slabs[slab].Diagram.Links)
    {
      this->Complex.Links.emplace_back(cellOf[link.first], cellOf[link.second]);
    }
    const int firstT2 = this->Slabs[slab].Diagram.NumberOfT1;
    this->FillGap(slab, slab, lower, cellOf.data(), aboveLower);
    this->FillGap(slab, slab + 1, upper, cellOf.data() + firstT2, belowUpper);
  }

  /// The same neighbour by number of its cell.
  static int NeighbourOf(int tetrahedron, const std::vector<int>& cellOf)
  {
    if (SlabTetrahedra::IsGap(tetrahedron))
    {
      return SlabTetrahedra::GapTo(cellOf[SlabTetrahedra::Beyond(tetrahedron)]);
    }
    return tetrahedron < 0 ? -1 : cellOf[tetrahedron];
  }

  /**
   * Fill the space between the plane of a level and its lifted triangles in one slab.
   *
   * baseCells: of every triangle its T1 (or T2) cell or -1; null beyond the first and last level.
   * sides: receives what the plane sees.
   * A triangle grows one tetrahedron for each lifted corner, in the order of the point numbers, so
   * that triangles that share an edge agree on the faces above it.
   */
  void FillGap(int slab, int level, const std::vector<int>& seen, const int* baseCells,
    std::vector<Side>& sides)
  {
    const auto& triangulation = this->Levels[level].Triangulation;
    const bool upwards = slab == level;
    const int count = static_cast<int>(triangulation.Triangles.size());
    // Of every corner of every triangle the cell that lifts it, or -1.
    std::vector<std::array<int, 3>> lifting(count, { { -1, -1, -1 } });
    for (int t = 0; t < count; ++t)
    {
      if (triangulation.Inside[t])
      {
        this->AddGapCells(
          slab, level, t, seen, upwards, lifting[t], sides[t], baseCells ? baseCells[t] : -1);
      }
    }
    for (int t = 0; t < count; ++t)
    {
      for (int lifted = 0; lifted < 3; ++lifted)
      {
        for (int other = 0; other < 3 && lifting[t][lifted] >= 0; ++other)
        {
          if (other != lifted)
          {
            this->JoinSideways(triangulation, t, lifted, other, upwards, lifting);
          }
        }
      }
    }
  }

  SolidComplex::PartType PartOf(int level, int t, bool upwards) const
  {
    const int side = upwards ? LevelTriangulation::LevelAbove : LevelTriangulation::LevelBelow;
    if (this->Levels[level].Covered.Isolated[t])
    {
      return SolidComplex::Isolated;
    }
    return this->Levels[level].Covered.Ends[t] & side ? SolidComplex::EndCap
                                                      : SolidComplex::BetweenLevels;
  }

  /// A triangle of IR belongs to the solid's closure but for isolated regions that are dropped.
  bool MustCover(int level, int t) const
  {
    return this->Levels[level].Triangulation.Inside[t] && this->Levels[level].Covered.MustCover(t);
  }

  /// Position in a gap cell of corner k of its triangle: one below the plane is the mirror image.
  static int GapCorner(int k, bool upwards) { return upwards || k == 0 ? k : 3 - k; }

  void AddGapCells(int slab, int level, int t, const std::vector<int>& seen, bool upwards,
    std::array<int, 3>& lifting, Side& side, int baseCell)
  {
    const auto& corners = this->Levels[level].Triangulation.Triangles[t];
    std::array<int, 3> current{};
    std::array<int, 3> order{ { 0, 1, 2 } };
    std::sort(order.begin(), order.end(), [&](int i, int j) { return corners[i] < corners[j]; });
    for (int k = 0; k < 3; ++k)
    {
      current[k] = this->VertexOf(level, corners[k]);
    }
    Side open; // the face of the last cell that looks away from the plane
    for (int k : order)
    {
      const int copy = seen[corners[k]];
      if (copy == current[k])
      {
        continue;
      }
      Cell cell{ {}, { { -1, -1, -1, -1 } }, slab, this->PartOf(level, t, upwards) };
      for (int j = 0; j < 3; ++j)
      {
        cell.Vertices[GapCorner(j, upwards)] = current[j];
      }
      cell.Vertices[3] = copy;
      const int added = static_cast<int>(this->Complex.Cells.size());
      this->Complex.Cells.push_back(cell);
      if (open.Cell < 0)
      {
        side = { added, 3 };
      }
      else
      {
        this->Join(open, { added, 3 });
      }
      open = { added, GapCorner(k, upwards) };
      lifting[k] = added;
      current[k] = copy;
    }
    if (baseCell < 0)
    {
      return;
    }
    if (open.Cell < 0)
    {
      side = { baseCell, 3 };
    }
    else
    {
      this->Join(open, { baseCell, 3 });
    }
  }

  /// The upright face of the cell that lifts a corner, opposite another corner of its triangle, is
  /// shared with the cell that lifts the same point in the triangle across that edge.
  void JoinSideways(const LevelTriangulation& triangulation, int t, int lifted, int other,
    bool upwards, const std::vector<std::array<int, 3>>& lifting)
  {
    const int neighbour = triangulation.Neighbours[t][other];
    if (neighbour < 0)
    {
      return; // an upright wall on the hull
    }
    const int point = triangulation.Triangles[t][lifted];
    const auto& corners = triangulation.Triangles[neighbour];
    const int same = corners[0] == point ? 0 : (corners[1] == point ? 1 : 2);
    this->Complex.Cells[lifting[t][lifted]].Neighbours[GapCorner(other, upwards)] =
      lifting[neighbour][same];
  }

  void Join(const Side& a, const Side& b)
  {
    this->Complex.Cells[a.Cell].Neighbours[a.Face] = b.Cell;
    this->Complex.Cells[b.Cell].Neighbours[b.Face] = a.Cell;
  }

  void JoinAcrossPlane(int level, const std::vector<Side>& above, const std::vector<Side>& below)
  {
    for (std::size_t t = 0; t < above.size(); ++t)
    {
      if (above[t].Cell >= 0 && below[t].Cell >= 0)
      {
        this->Join(above[t], below[t]);
      }
      else if (above[t].Cell < 0 && below[t].Cell < 0 &&
        this->MustCover(level, static_cast<int>(t)))
      {
        this->AddPyramid(level, static_cast<int>(t));
      }
    }
  }

  /// Its tip lies on the line from the triangle's centroid to the apex of the tetrahedron there, so
  /// it is inside; as high as the triangle is wide, at most a quarter of the slab.
  void AddPyramid(int level, int t)
  {
    const bool upwards = level < static_cast<int>(this->Slabs.size());
    const int slab = upwards ? level : level - 1;
    const auto& tetrahedra = this->Slabs[slab].Diagram.Tetrahedra;
    const int apex = upwards
      ? this->Upper[slab - this->Range.First][tetrahedra[t].Corners[3]]
      : this->Lower[slab - this->Range.First]
                   [tetrahedra[this->Slabs[slab].Diagram.NumberOfT1 + t].Corners[3]];
    const auto& top = this->Complex.Vertices[apex];
    const auto& triangulation = this->Levels[level].Triangulation;
    const auto& corners = triangulation.Triangles[t];
    const auto part = this->Levels[level].Covered.Isolated[t] ? SolidComplex::Isolated
                                                              : SolidComplex::BetweenLevels;
    Cell cell{ {}, { { -1, -1, -1, -1 } }, slab, part };
    Point2 centroid{ { 0, 0 } };
    for (int k = 0; k < 3; ++k)
    {
      const Point2& p = triangulation.Points[corners[k]];
      centroid = { centroid[0] + p[0] / 3, centroid[1] + p[1] / 3 };
      cell.Vertices[GapCorner(k, upwards)] = this->VertexOf(level, corners[k]);
    }
    const double rise = top.Height - this->Levels[level].Offset;
    const double share = std::min(0.25, Inradius(triangulation, corners) / std::abs(rise));
    cell.Vertices[3] = static_cast<int>(this->Complex.Vertices.size());
    this->Complex.Vertices.push_back({ { centroid[0] + share * (top.Planar[0] - centroid[0]),
                                         centroid[1] + share * (top.Planar[1] - centroid[1]) },
      this->Levels[level].Offset + share * rise, level, -1, true });
    this->Complex.Cells.push_back(cell);
  }

  static double Inradius(const LevelTriangulation& level, const std::array<int, 3>& corners)
  {
    double perimeter = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Point2& p = level.Points[corners[k]];
      const Point2& q = level.Points[corners[(k + 1) % 3]];
      perimeter += std::hypot(q[0] - p[0], q[1] - p[1]);
    }
    const Point2& a = level.Points[corners[0]];
    const Point2& b = level.Points[corners[1]];
    const Point2& c = level.Points[corners[2]];
    const double twiceArea = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return twiceArea / perimeter;
  }

  const std::vector<LevelState>& Levels;
  const std::vector<SlabState>& Slabs;
  const SlabRange Range;
  std::vector<int> FirstVertex; ///< by level of the range
  std::vector<std::vector<int>>
    Lower; ///< by slab of the range: vertices of its lower level as the slab sees them
  std::vector<std::vector<int>> Upper; ///< the same of its upper level
  SolidComplex Complex;
};
}

SolidComplex BuildSolidComplex(
  const std::vector<LevelState>& levels, const std::vector<SlabState>& slabs)
{
  return BuildSolidComplex(levels, slabs, { 0, static_cast<int>(slabs.size()) });
}

SolidComplex BuildSolidComplex(const std::vector<LevelState>& levels,
  const std::vector<SlabState>& slabs, const SlabRange& range)
{
  return Builder(levels, slabs, range).Build();
}
}
