// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/Elimination.h"

#include "Polyhedral/DelaunayEdges.h"
#include "Polyhedral/VertexRegions.h"

namespace recon
{
namespace
{
using Tetrahedron = SlabTetrahedra::Tetrahedron;

class Elimination
{
public:
  Elimination(const LevelTriangulation& level1, const LevelTriangulation& level2,
    const SlabJoins& joins, SlabTetrahedra& slab)
    : Level1(level1),
      Level2(level2),
      Joins(joins),
      Slab(slab),
      Regions1(level1),
      Regions2(level2)
  {
  }

  void Run()
  {
    for (Tetrahedron& t : this->Slab.Tetrahedra)
    {
      t.Reason = t.Node == SlabTetrahedra::T12 ? this->ReasonOfT12(t) : this->ReasonOfBase(t);
    }
    while (this->DropLooseT12() || this->DropLooseBases())
    {
      // Either may take the support from what the other has kept.
    }
  }

private:
  SlabTetrahedra::ReasonType ReasonOfBase(const Tetrahedron& t) const
  {
    const auto& level = t.Node == SlabTetrahedra::T1 ? this->Level1 : this->Level2;
    if (!level.Inside[t.Origin[0]])
    {
      return SlabTetrahedra::ExternalEdge;
    }
    const int base = level.Region[t.Origin[0]];
    const bool joined = t.Node == SlabTetrahedra::T1
      ? this->Regions2.AnyOf(t.Corners[3], [&](int r) { return this->Joins.AreJoined(base, r); })
      : this->Regions1.AnyOf(t.Corners[3], [&](int r) { return this->Joins.AreJoined(r, base); });
    return joined ? SlabTetrahedra::Kept : SlabTetrahedra::NotJoined;
  }

  SlabTetrahedra::ReasonType ReasonOfT12(const Tetrahedron& t) const
  {
    const EdgeKind kind1 = KindOf(this->Level1, t.Origin[0]);
    const EdgeKind kind2 = KindOf(this->Level2, t.Origin[1]);
    if (kind1 == EdgeKind::External || kind2 == EdgeKind::External)
    {
      return SlabTetrahedra::ExternalEdge;
    }
    if (!this->Joins.AreJoined(
          RegionAtEdge(this->Level1, t.Origin[0]), RegionAtEdge(this->Level2, t.Origin[1])))
    {
      return SlabTetrahedra::NotJoined;
    }
    if (kind1 == EdgeKind::Internal || kind2 == EdgeKind::Internal)
    {
      return SlabTetrahedra::Kept;
    }
    const Point2& a = this->Level1.Points[t.Corners[0]];
    const Point2& b = this->Level1.Points[t.Corners[1]];
    const Point2& u = this->Level2.Points[t.Corners[2]];
    const Point2& v = this->Level2.Points[t.Corners[3]];
    const bool outside = IsNodeOutside(this->Level1, t.Origin[0], u, v) &&
      IsNodeOutside(this->Level2, t.Origin[1], a, b);
    return outside ? SlabTetrahedra::OutsideBothContours : SlabTetrahedra::Kept;
  }

  bool IsKept(int i) const
  {
    return i >= 0 && this->Slab.Tetrahedra[i].Reason == SlabTetrahedra::Kept;
  }

  /**
   * Thesis 6.4: a T12 stays where it is solid on level 1 and on level 2 at the same time.
   *
   * Solid on a level means that along its Voronoi edge of that level kept T12 lead to a kept base
   * of it.
   */
  bool DropLooseT12()
  {
    const std::vector<unsigned char> solid1 = this->SolidOn(SlabTetrahedra::T1, { 2, 3 });
    const std::vector<unsigned char> solid2 = this->SolidOn(SlabTetrahedra::T2, { 0, 1 });
    bool dropped = false;
    for (std::size_t i = 0; i < this->Slab.Tetrahedra.size(); ++i)
    {
      Tetrahedron& t = this->Slab.Tetrahedra[i];
      if (t.Node == SlabTetrahedra::T12 && t.Reason == SlabTetrahedra::Kept &&
        !(solid1[i] && solid2[i]))
      {
        t.Reason = SlabTetrahedra::NonSolidConnection;
        dropped = true;
      }
    }
    return dropped;
  }

  /// Flood from the kept bases of a level through the faces that run along its Voronoi edges.
  std::vector<unsigned char> SolidOn(
    SlabTetrahedra::NodeType base, const std::array<int, 2>& faces) const
  {
    std::vector<unsigned char> reached(this->Slab.Tetrahedra.size(), 0);
    std::vector<int> stack;
    const auto visit = [&](int neighbour)
    {
      const int i = SlabTetrahedra::Beyond(neighbour); // all of a gap is kept
      if (this->IsKept(i) && !reached[i] && this->Slab.Tetrahedra[i].Node == SlabTetrahedra::T12)
      {
        reached[i] = 1;
        stack.push_back(i);
      }
    };
    const int begin = base == SlabTetrahedra::T1 ? 0 : this->Slab.NumberOfT1;
    const int end =
      begin + (base == SlabTetrahedra::T1 ? this->Slab.NumberOfT1 : this->Slab.NumberOfT2);
    for (int i = begin; i < end; ++i)
    {
      if (this->IsKept(i))
      {
        for (int k = 0; k < 3; ++k)
        {
          visit(this->Slab.Tetrahedra[i].Neighbours[k]);
        }
      }
    }
    while (!stack.empty())
    {
      const Tetrahedron& t = this->Slab.Tetrahedra[stack.back()];
      stack.pop_back();
      visit(t.Neighbours[faces[0]]);
      visit(t.Neighbours[faces[1]]);
    }
    return reached;
  }

  /// Thesis 5.5: connected T1 (or T2) nodes without a kept T12 touch the other level in one point.
  bool DropLooseBases()
  {
    const int bases = this->Slab.NumberOfT1 + this->Slab.NumberOfT2;
    std::vector<unsigned char> supported(bases, 0);
    std::vector<int> stack;
    for (int i = 0; i < bases; ++i)
    {
      for (int k = 0; k < 3 && this->IsKept(i) && !supported[i]; ++k)
      {
        const int neighbour = this->Slab.Tetrahedra[i].Neighbours[k];
        if (SlabTetrahedra::IsGap(neighbour) || (this->IsKept(neighbour) && neighbour >= bases))
        {
          supported[i] = 1;
          stack.push_back(i);
        }
      }
    }
    while (!stack.empty())
    {
      const Tetrahedron& t = this->Slab.Tetrahedra[stack.back()];
      stack.pop_back();
      for (int neighbour : t.Neighbours)
      {
        if (this->IsKept(neighbour) && neighbour < bases && !supported[neighbour])
        {
          supported[neighbour] = 1;
          stack.push_back(neighbour);
        }
      }
    }
    bool dropped = false;
    for (int i = 0; i < bases; ++i)
    {
      if (this->IsKept(i) && !supported[i])
      {
        this->Slab.Tetrahedra[i].Reason = SlabTetrahedra::NonSolidConnection;
        dropped = true;
      }
    }
    return dropped;
  }

  const LevelTriangulation& Level1;
  const LevelTriangulation& Level2;
  const SlabJoins& Joins;
  SlabTetrahedra& Slab;
  VertexRegions Regions1;
  VertexRegions Regions2;
};
}

void EliminateTetrahedra(const LevelTriangulation& level1, const LevelTriangulation& level2,
  const SlabJoins& joins, SlabTetrahedra& slab)
{
  Elimination(level1, level2, joins, slab).Run();
}
}
