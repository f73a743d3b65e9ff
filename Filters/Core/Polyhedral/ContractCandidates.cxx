// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/ContractCandidates.h"

#include "Base/DisjointSets.h"
#include "Base/Geometry.h"
#include "Polyhedral/DelaunayEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
using Pair = std::pair<int, int>;

/// No contract asks for more at once; each takes as long as there are joins.
constexpr std::size_t MostPartings = 1000;

bool IsCheaper(const ContractDecision& a, const ContractDecision& b)
{
  const auto key = [](const ContractDecision& d)
  { return std::make_tuple(d.Cost, d.Slab, d.Lower, d.Upper, d.Kind); };
  return key(a) < key(b);
}

bool IsCheaperStep(const ContractStep& a, const ContractStep& b)
{
  return IsCheaper(a.front(), b.front());
}

class Finder
{
public:
  Finder(const ContourSet& contours, const PolyhedralStages& stages,
    const std::vector<int>& pieceOfContour)
    : Contours(contours),
      Stages(stages),
      Pieces(pieceOfContour)
  {
  }

  ContractCandidates Find()
  {
    for (std::size_t slab = 0; slab < this->Stages.Slabs.size(); ++slab)
    {
      this->AddMissing(static_cast<int>(slab));
    }
    std::sort(this->Result.Joining.begin(), this->Result.Joining.end(), IsCheaperStep);
    std::sort(this->Result.Looping.begin(), this->Result.Looping.end(), IsCheaperStep);
    this->AddPartings();
    return std::move(this->Result);
  }

private:
  bool IsHole(int contour) const { return this->Contours.Contours[contour].Depth % 2 == 1; }

  /// Kruskal's: the strongest first.
  void AddPartings()
  {
    std::vector<ContractDecision> joined;
    for (const ContourJoin& join : this->Stages.Mapping.Joins)
    {
      if (join.Joined && this->Stages.Mapping.Regions[join.LowerRegion].Solid)
      {
        joined.push_back({ ContractDecision::Part, join.Slab, join.LowerRegion, join.UpperRegion,
          std::max(join.LowerRatio, join.UpperRatio) });
      }
    }
    std::sort(joined.begin(), joined.end(), IsCheaper);
    std::vector<ContractDecision> forest;
    std::vector<ContractDecision> others;
    DisjointSets sets(this->Contours.Contours.size());
    for (auto join = joined.rbegin(); join != joined.rend(); ++join)
    {
      (sets.Find(join->Lower) != sets.Find(join->Upper) ? forest : others).push_back(*join);
      sets.Join(join->Lower, join->Upper);
    }
    for (auto edge = forest.rbegin();
         edge != forest.rend() && this->Result.Parting.size() < MostPartings; ++edge)
    {
      this->Result.Parting.push_back(this->StepOf(*edge, forest, others));
    }
  }

  /// An edge of the forest with all others between its two ends.
  ContractStep StepOf(const ContractDecision& edge, const std::vector<ContractDecision>& forest,
    const std::vector<ContractDecision>& others) const
  {
    DisjointSets sets(this->Contours.Contours.size());
    for (const ContractDecision& other : forest)
    {
      if (IsCheaper(other, edge) || IsCheaper(edge, other))
      {
        sets.Join(other.Lower, other.Upper);
      }
    }
    ContractStep step{ edge };
    const int below = sets.Find(edge.Lower);
    const int above = sets.Find(edge.Upper);
    for (const ContractDecision& other : others)
    {
      const int from = sets.Find(other.Lower);
      const int to = sets.Find(other.Upper);
      if ((from == below && to == above) || (from == above && to == below))
      {
        step.push_back(other);
      }
    }
    return step;
  }

  /// Regions, and walls, that T12 see facing each other.
  void AddMissing(int slab)
  {
    const LevelTriangulation& lower = this->Stages.Levels[slab].Triangulation;
    const LevelTriangulation& upper = this->Stages.Levels[slab + 1].Triangulation;
    const SlabState& state = this->Stages.Slabs[slab];
    std::map<Pair, double> apart;  // regions that are not joined: their distance
    std::map<Pair, double> walled; // walls with solid between them
    for (const SlabTetrahedra::Tetrahedron& t : state.Diagram.Tetrahedra)
    {
      if (t.Node != SlabTetrahedra::T12 || KindOf(lower, t.Origin[0]) == EdgeKind::External ||
        KindOf(upper, t.Origin[1]) == EdgeKind::External)
      {
        continue;
      }
      const Pair regions{ RegionAtEdge(lower, t.Origin[0]), RegionAtEdge(upper, t.Origin[1]) };
      const Pair walls{ ContourAtEdge(lower, t.Origin[0]), ContourAtEdge(upper, t.Origin[1]) };
      if (t.Reason != SlabTetrahedra::Kept)
      {
        this->Shorten(apart, regions, t, lower, upper);
      }
      else if (walls.first >= 0 && walls.second >= 0 &&
        (this->IsHole(walls.first) || this->IsHole(walls.second)))
      {
        this->Shorten(walled, walls, t, lower, upper);
      }
    }
    const std::map<Pair, double> shares = this->SharesOf(slab);
    for (const auto& [pair, distance] : apart)
    {
      const auto share = shares.find(pair);
      if (!this->IsJoined(slab, pair) && !state.Joins.IsGap)
      {
        this->AddMissing(ContractDecision::Join, slab, pair,
          share != shares.end() ? -share->second : distance / state.Thickness);
      }
    }
    for (const auto& [pair, distance] : walled)
    {
      if (state.Joins.Tunnels.count(pair) == 0 && shares.count(pair) == 0)
      {
        this->AddMissing(ContractDecision::Tunnel, slab, pair, distance / state.Thickness);
      }
    }
  }

  void AddMissing(ContractDecision::KindType kind, int slab, const Pair& pair, double cost)
  {
    const bool isOne = this->Pieces[pair.first] == this->Pieces[pair.second];
    (isOne ? this->Result.Looping : this->Result.Joining)
      .push_back({ { kind, slab, pair.first, pair.second, cost } });
  }

  bool IsJoined(int slab, const Pair& pair) const
  {
    return this->Stages.Slabs[slab].Joins.AreJoined(pair.first, pair.second);
  }

  /// Of pairs of solid regions, and of pairs of holes, that overlap: how much of the smaller.
  std::map<Pair, double> SharesOf(int slab) const
  {
    std::map<Pair, double> shares;
    for (const ContourJoin& join : this->Stages.Mapping.Joins)
    {
      if (join.Slab == slab && join.OverlapArea > 0)
      {
        shares[{ join.LowerRegion, join.UpperRegion }] = std::max(join.LowerRatio, join.UpperRatio);
      }
    }
    return shares;
  }

  static void Shorten(std::map<Pair, double>& distances, const Pair& pair,
    const SlabTetrahedra::Tetrahedron& t, const LevelTriangulation& lower,
    const LevelTriangulation& upper)
  {
    const double distance = DistanceOf(t, lower, upper);
    const auto [known, isNew] = distances.emplace(pair, distance);
    known->second = std::min(known->second, distance);
  }

  /// Between the two edges of a T12 in projection; of edges that cross that of their nearest end.
  static double DistanceOf(const SlabTetrahedra::Tetrahedron& t, const LevelTriangulation& lower,
    const LevelTriangulation& upper)
  {
    std::array<Point3, 4> at{};
    for (int k = 0; k < 4; ++k)
    {
      const Point2& p = (k < 2 ? lower : upper).Points[t.Corners[k]];
      at[k] = { p[0], p[1], 0 };
    }
    return std::sqrt(std::min(std::min(SquaredDistanceToSegment(at[0], at[2], at[3]),
                                SquaredDistanceToSegment(at[1], at[2], at[3])),
      std::min(SquaredDistanceToSegment(at[2], at[0], at[1]),
        SquaredDistanceToSegment(at[3], at[0], at[1]))));
  }

  const ContourSet& Contours;
  const PolyhedralStages& Stages;
  const std::vector<int>& Pieces;
  ContractCandidates Result;
};
}

ContractCandidates FindContractCandidates(const ContourSet& contours,
  const PolyhedralStages& stages, const std::vector<int>& pieceOfContour)
{
  return Finder(contours, stages, pieceOfContour).Find();
}
}
