// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/Elimination.h"

#include "Polyhedral/DelaunayEdges.h"
#include "Polyhedral/VertexRegions.h"

#include <array>
#include <utility>
#include <vector>

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
    this->FindSolidWays();
    this->DropLooseT12();
    while (this->DropLooseBases())
    {
      // Either may take the support from what the other has kept.
      this->DropLooseT12();
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
    const std::pair<int, int> regions{ RegionAtEdge(this->Level1, t.Origin[0]),
      RegionAtEdge(this->Level2, t.Origin[1]) };
    if (!this->Joins.AreJoined(regions.first, regions.second) ||
      this->Joins.Tunnels.count(
        { ContourAtEdge(this->Level1, t.Origin[0]), ContourAtEdge(this->Level2, t.Origin[1]) }) > 0)
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
    const bool outside = this->Joins.Spanned.count(regions) == 0 &&
      IsNodeOutside(this->Level1, t.Origin[0], u, v) &&
      IsNodeOutside(this->Level2, t.Origin[1], a, b);
    return outside ? SlabTetrahedra::OutsideBothContours : SlabTetrahedra::Kept;
  }

  bool IsKept(int i) const
  {
    return i >= 0 && this->Slab.Tetrahedra[i].Reason == SlabTetrahedra::Kept;
  }

  /// The T12 across a face of a tetrahedron, through a gap as well, or -1 where what is there is none or
  /// not kept.
  int KeptT12Across(int neighbour) const
  {
    const int i = SlabTetrahedra::Beyond(neighbour); // all of a gap is kept
    return this->IsKept(i) && this->Slab.Tetrahedra[i].Node == SlabTetrahedra::T12 ? i : -1;
  }

  /// The face of a T12 through which it is seen from i: one of a pair along a Voronoi edge of a level.
  int FaceTowards(int t12, int i) const
  {
    const auto& neighbours = this->Slab.Tetrahedra[t12].Neighbours;
    int k = 0;
    while (k < 3 && SlabTetrahedra::Beyond(neighbours[k]) != i)
    {
      ++k;
    }
    return k;
  }

  /// The other face along the same Voronoi edge: 0 and 1 lead along one of level 2, 2 and 3 along one
  /// of level 1.
  static int OtherFace(int k) { return k ^ 1; }

  /// Along every Voronoi edge from the kept bases at its ends, as far as T12 are kept.
  void FindSolidWays()
  {
    this->LeadsToSolid.assign(this->Slab.Tetrahedra.size(), { { 0, 0, 0, 0 } });
    const int bases = this->Slab.NumberOfT1 + this->Slab.NumberOfT2;
    for (int base = 0; base < bases; ++base)
    {
      for (int k = 0; k < 3 && this->IsKept(base); ++k)
      {
        this->MarkWay(base, this->Slab.Tetrahedra[base].Neighbours[k], 1);
      }
    }
    for (std::size_t i = 0; i < this->Slab.Tetrahedra.size(); ++i)
    {
      this->DropIfLoose(static_cast<int>(i));
    }
  }

  /// What is reached from i across a face, on along the Voronoi edge: whether it has solid behind it.
  void MarkWay(int i, int neighbour, unsigned char solid)
  {
    int from = i;
    for (int t = this->KeptT12Across(neighbour); t >= 0;)
    {
      const int k = this->FaceTowards(t, from);
      if (this->LeadsToSolid[t][k] == solid)
      {
        return;
      }
      this->LeadsToSolid[t][k] = solid;
      this->Changed.push_back(t);
      from = t;
      t = this->KeptT12Across(this->Slab.Tetrahedra[t].Neighbours[OtherFace(k)]);
    }
  }

  /**
   * Thesis 6.4: a T12 stays where it is solid on level 1 and on level 2 at the same time.
   *
   * Solid on a level means that along its Voronoi edge of that level kept T12 lead to a kept base
   * of it. Each way ends at most once, so this takes as long as there are tetrahedra.
   */
  void DropLooseT12()
  {
    while (!this->Changed.empty() || !this->Dropped.empty())
    {
      while (!this->Changed.empty())
      {
        const int i = this->Changed.back();
        this->Changed.pop_back();
        this->DropIfLoose(i);
      }
      if (!this->Dropped.empty())
      {
        const int i = this->Dropped.back();
        this->Dropped.pop_back();
        for (int neighbour : this->Slab.Tetrahedra[i].Neighbours)
        {
          this->MarkWay(i, neighbour, 0);
        }
      }
    }
  }

  void DropIfLoose(int i)
  {
    const std::array<unsigned char, 4>& leads = this->LeadsToSolid[i];
    Tetrahedron& t = this->Slab.Tetrahedra[i];
    if (t.Node == SlabTetrahedra::T12 && t.Reason == SlabTetrahedra::Kept &&
      !((leads[0] || leads[1]) && (leads[2] || leads[3])))
    {
      t.Reason = SlabTetrahedra::NonSolidConnection;
      this->Dropped.push_back(i);
    }
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
        this->Dropped.push_back(i);
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
  /// Of a T12 and a face, whether kept T12 lead to a kept base on that side.
  std::vector<std::array<unsigned char, 4>> LeadsToSolid;
  std::vector<int> Changed; ///< T12 to be looked at
  std::vector<int> Dropped; ///< whose neighbours do not know it yet
};
}

void EliminateTetrahedra(const LevelTriangulation& level1, const LevelTriangulation& level2,
  const SlabJoins& joins, SlabTetrahedra& slab)
{
  Elimination(level1, level2, joins, slab).Run();
}
}
