// SPDX-License-Identifier: GPL-3.0-or-later
#include "Planar/HoleRule.h"

#include "Planar/NestingForest.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace recon
{
namespace
{
/// Outer walls counterclockwise, holes clockwise.
void Orient(const std::vector<Point2>& points, std::vector<std::vector<int>>& loops)
{
  for (std::vector<int>& loop : loops)
  {
    if (SignedAreaOf(points, loop) < 0)
    {
      std::reverse(loop.begin(), loop.end());
    }
  }
  const NestingForest forest = BuildNestingForest(points, loops);
  for (std::size_t l = 0; l < loops.size(); ++l)
  {
    if (forest.Depth[l] % 2 == 1)
    {
      std::reverse(loops[l].begin(), loops[l].end());
    }
  }
}

/// Every loop by itself, then the union.
class Keyholes
{
public:
  Keyholes(
    std::vector<Point2>& points, const std::vector<std::vector<int>>& loops, double snapTolerance)
    : Points(points),
      SnapTolerance(snapTolerance)
  {
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
      this->AddArea(loops[l], static_cast<int>(l));
    }
  }

  EvenOddResult Unite()
  {
    EvenOddResult united = ApplyWindingRule(this->Points, this->Pieces, this->SnapTolerance);
    for (EvenOddResult::Loop& loop : united.Loops)
    {
      loop.Origin = this->Owners[loop.Origin];
    }
    for (EvenOddCluster& cluster : united.Clusters)
    {
      this->NameOwners(cluster.Loops);
      this->NameOwners(cluster.Vanished);
      this->Clusters.push_back(std::move(cluster));
    }
    this->NameOwners(united.Swallowed);
    united.Clusters = std::move(this->Clusters);
    return united;
  }

private:
  void AddArea(const std::vector<int>& loop, int owner)
  {
    EvenOddResult area = ApplyEvenOddRule(this->Points, { loop }, this->SnapTolerance);
    for (EvenOddCluster& cluster : area.Clusters)
    {
      this->NameAll(cluster.Loops, owner);
      this->NameAll(cluster.Vanished, owner);
      this->Clusters.push_back(std::move(cluster));
    }
    std::vector<std::vector<int>> pieces;
    for (EvenOddResult::Loop& piece : area.Loops)
    {
      pieces.push_back(std::move(piece.Points));
    }
    Orient(this->Points, pieces);
    this->Owners.insert(this->Owners.end(), pieces.size(), owner);
    std::move(pieces.begin(), pieces.end(), std::back_inserter(this->Pieces));
  }

  static void NameAll(std::vector<int>& loops, int owner)
  {
    std::fill(loops.begin(), loops.end(), owner);
  }

  /// Pieces become the loops that they came from.
  void NameOwners(std::vector<int>& pieces) const
  {
    for (int& piece : pieces)
    {
      piece = this->Owners[piece];
    }
    std::sort(pieces.begin(), pieces.end());
    pieces.erase(std::unique(pieces.begin(), pieces.end()), pieces.end());
  }

  std::vector<Point2>& Points;
  double SnapTolerance;
  std::vector<std::vector<int>> Pieces;
  std::vector<int> Owners;
  std::vector<EvenOddCluster> Clusters;
};
}

EvenOddResult ApplyHoleRule(std::vector<Point2>& points, const std::vector<std::vector<int>>& loops,
  HoleRule rule, double snapTolerance)
{
  switch (rule)
  {
    case HoleRule::Winding:
      return ApplyWindingRule(points, loops, snapTolerance);
    case HoleRule::Keyhole:
      return Keyholes(points, loops, snapTolerance).Unite();
    case HoleRule::Automatic:
    case HoleRule::EvenOdd:
      break;
  }
  return ApplyEvenOddRule(points, loops, snapTolerance);
}

const char* NameOf(HoleRule rule)
{
  switch (rule)
  {
    case HoleRule::Winding:
      return "winding";
    case HoleRule::Keyhole:
      return "keyhole";
    case HoleRule::Automatic:
    case HoleRule::EvenOdd:
      break;
  }
  return "even-odd";
}
}
