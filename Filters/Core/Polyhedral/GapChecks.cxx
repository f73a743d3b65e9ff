// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/GapChecks.h"

#include <algorithm>
#include <cstdint>

namespace recon
{
namespace
{
using Tetrahedron = SlabTetrahedra::Tetrahedron;

/// A face of the boundary at an edge between the levels.
struct FaceAtEdge
{
  std::uint64_t Edge;
  int Tetrahedron;
  int Face;
};

class Check
{
public:
  Check(const JointCells& cells, const SlabTetrahedra& slab, UnsafeEdges& unsafe)
    : Cells(cells),
      Slab(slab),
      Unsafe(unsafe)
  {
  }

  void Run()
  {
    for (int t = 0; t < static_cast<int>(this->Slab.Tetrahedra.size()); ++t)
    {
      for (int k = 0; k < 4; ++k)
      {
        const int neighbour = this->At(t).Neighbours[k];
        if (SlabTetrahedra::IsGap(neighbour) &&
          !(this->IsKept(t) && this->IsKept(SlabTetrahedra::Beyond(neighbour))))
        {
          this->Mark(t, k);
        }
      }
    }
    this->TurnAroundSharedEdges();
  }

private:
  const Tetrahedron& At(int t) const { return this->Slab.Tetrahedra[t]; }
  bool IsKept(int t) const { return t >= 0 && this->At(t).Reason == SlabTetrahedra::Kept; }

  /// The Voronoi edge along which face k of a tetrahedron looks.
  void Mark(int t, int k)
  {
    const Tetrahedron& tetrahedron = this->At(t);
    if (tetrahedron.Node == SlabTetrahedra::T12)
    {
      this->Unsafe.Mark(k < 2 ? 1 : 0, tetrahedron.Origin[k < 2 ? 1 : 0]);
      return;
    }
    const int level = tetrahedron.Node == SlabTetrahedra::T1 ? 0 : 1;
    const int corner = level == 0 || k == 0 ? k : 3 - k; // T2's corners 1 and 2 are swapped
    this->Unsafe.Mark(
      level, CanonicalEdge(this->Cells.LevelAt(level), tetrahedron.Origin[0], corner));
  }

  bool IsBoundary(int t, int k) const
  {
    const int neighbour = this->At(t).Neighbours[k];
    const bool inPlane = this->At(t).Node != SlabTetrahedra::T12 && k == 3;
    return !inPlane && !SlabTetrahedra::IsGap(neighbour) && !this->IsKept(neighbour);
  }

  std::uint64_t EdgeOf(int t, int i, int j) const
  {
    const int lower = SlabTetrahedra::OnLevel2(this->At(t), i) ? j : i;
    const int upper = lower == i ? j : i;
    return (static_cast<std::uint64_t>(this->At(t).Corners[lower]) << 32) |
      static_cast<std::uint32_t>(this->At(t).Corners[upper]);
  }

  /// Calls visit(i, j) for the corners of face k that are on different levels.
  template <typename Visit>
  void ForEdgesBetweenLevels(int t, int k, const Visit& visit) const
  {
    for (int i = 0; i < 4; ++i)
    {
      for (int j = i + 1; j < 4; ++j)
      {
        if (i != k && j != k &&
          SlabTetrahedra::OnLevel2(this->At(t), i) != SlabTetrahedra::OnLevel2(this->At(t), j))
        {
          visit(i, j);
        }
      }
    }
  }

  void TurnAroundSharedEdges()
  {
    std::vector<FaceAtEdge> faces;
    for (int t = 0; t < static_cast<int>(this->Slab.Tetrahedra.size()); ++t)
    {
      for (int k = 0; k < 4 && this->IsKept(t); ++k)
      {
        if (this->IsBoundary(t, k))
        {
          this->ForEdgesBetweenLevels(t, k,
            [&](int i, int j) {
              faces.push_back({ this->EdgeOf(t, i, j), t, k });
            });
        }
      }
    }
    std::sort(faces.begin(), faces.end(),
      [](const FaceAtEdge& a, const FaceAtEdge& b) { return a.Edge < b.Edge; });
    for (std::size_t from = 0; from < faces.size();)
    {
      std::size_t to = from;
      while (to < faces.size() && faces[to].Edge == faces[from].Edge)
      {
        ++to;
      }
      for (std::size_t i = from; i < to && to - from > 2; ++i)
      {
        this->TurnFrom(faces[i]);
      }
      from = to;
    }
  }

  /// Marks the first gap that comes in the way to the next face of the boundary.
  void TurnFrom(const FaceAtEdge& face)
  {
    const int lower = static_cast<int>(face.Edge >> 32);
    const int upper = static_cast<int>(face.Edge & 0xffffffffu);
    int t = face.Tetrahedron;
    int entered = face.Face;
    for (;;)
    {
      int leave = 0;
      while (leave < 3 && (leave == entered || this->IsEnd(t, leave, lower, upper)))
      {
        ++leave;
      }
      const int next = this->At(t).Neighbours[leave];
      if (SlabTetrahedra::IsGap(next))
      {
        this->Mark(t, leave);
        return;
      }
      if (!this->IsKept(next))
      {
        return;
      }
      const auto& back = this->At(next).Neighbours;
      entered = static_cast<int>(std::find(back.begin(), back.end(), t) - back.begin());
      t = next;
    }
  }

  bool IsEnd(int t, int k, int lower, int upper) const
  {
    return this->At(t).Corners[k] == (SlabTetrahedra::OnLevel2(this->At(t), k) ? upper : lower);
  }

  const JointCells& Cells;
  const SlabTetrahedra& Slab;
  UnsafeEdges& Unsafe;
};
}

void CheckGaps(const JointCells& cells, const SlabTetrahedra& slab, UnsafeEdges& unsafe)
{
  Check(cells, slab, unsafe).Run();
}

DisjointSets PiecesOf(const SlabTetrahedra& slab)
{
  const auto isKept = [&](int t)
  { return t >= 0 && slab.Tetrahedra[t].Reason == SlabTetrahedra::Kept; };
  DisjointSets pieces(slab.Tetrahedra.size());
  for (int t = 0; t < static_cast<int>(slab.Tetrahedra.size()); ++t)
  {
    for (int k = 0; k < 4 && isKept(t); ++k)
    {
      const int other = SlabTetrahedra::Beyond(slab.Tetrahedra[t].Neighbours[k]);
      if (isKept(other))
      {
        pieces.Join(t, other);
      }
    }
  }
  for (const auto& link : slab.Links)
  {
    pieces.Join(link.first, link.second);
  }
  return pieces;
}
}
