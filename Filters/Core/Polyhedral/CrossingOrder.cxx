// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/CrossingOrder.h"

#include "Base/StopSignal.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace recon
{
CrossingOrder::CrossingOrder(const JointCells& cells, std::vector<JointCrossing> crossings)
  : Cells(cells),
    Sorted(std::move(crossings))
{
  const std::vector<int> order = this->SortAlong(0);
  std::vector<JointCrossing> sorted;
  for (const int i : order)
  {
    // Repetitions have the same place, so they lie side by side.
    if (sorted.empty() || sorted.back().Edges != this->Sorted[i].Edges)
    {
      sorted.push_back(this->Sorted[i]);
    }
  }
  this->Sorted = std::move(sorted);
  for (const int level : { 0, 1 })
  {
    this->Numbers[level] = this->SortAlong(level);
  }
}

const int* CrossingOrder::Begin(int level, int edge) const
{
  return this->Numbers[level].data() + this->First[level][edge];
}

const int* CrossingOrder::End(int level, int edge) const
{
  return this->Numbers[level].data() + this->First[level][edge + 1];
}

int CrossingOrder::Before(int level, int edge, const JointCrossing& crossing) const
{
  const int* begin = this->Begin(level, edge);
  const VoronoiPath path = ForthAlong(this->Cells.LevelAt(level), level, edge);
  const int* found = std::partition_point(begin, this->End(level, edge),
    [&](int i) { return this->IsBefore(path, this->Sorted[i], crossing); });
  return found == begin ? -1 : *(found - 1);
}

std::array<int, 2> CrossingOrder::CellsAt(const VoronoiPath& path, const JointCrossing& crossing)
{
  const auto& c = crossing.Corners;
  if (path.Own == 0)
  {
    return { { c[2], c[3] } };
  }
  // Seen from below, edges of level 2 cross those of level 1 the other way.
  const bool same = path.B == c[2];
  return { { c[same ? 0 : 1], c[same ? 1 : 0] } };
}

bool CrossingOrder::IsBefore(
  const VoronoiPath& path, const JointCrossing& p, const JointCrossing& q) const
{
  if (p.Edges[1 - path.Own] == q.Edges[1 - path.Own])
  {
    return false; // the same twice
  }
  const auto& own = this->Cells.LevelAt(path.Own).Points;
  const auto& other = this->Cells.LevelAt(1 - path.Own).Points;
  const auto at = [&](const JointCrossing& crossing)
  {
    const auto cells = CellsAt(path, crossing);
    return CellCrossing{ other[cells[0]], other[cells[1]] };
  };
  return CompareAlongBisector(own[path.A], own[path.B], path.Own == 0, at(p), at(q)) < 0;
}

/// Numbers by edge, then along it. Sets First.
std::vector<int> CrossingOrder::SortAlong(int level)
{
  auto& first = this->First[level];
  first.assign(3 * this->Cells.LevelAt(level).Triangles.size() + 1, 0);
  for (const JointCrossing& crossing : this->Sorted)
  {
    ++first[crossing.Edges[level] + 1];
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<int> numbers(this->Sorted.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int i = 0; i < static_cast<int>(this->Sorted.size()); ++i)
  {
    numbers[next[this->Sorted[i].Edges[level]]++] = i;
  }
  for (int edge = 0; edge + 1 < static_cast<int>(first.size()); ++edge)
  {
    if (first[edge + 1] - first[edge] < 2)
    {
      continue;
    }
    ThrowIfStopped();
    const VoronoiPath path = ForthAlong(this->Cells.LevelAt(level), level, edge);
    std::sort(numbers.begin() + first[edge], numbers.begin() + first[edge + 1],
      [&](int i, int j) { return this->IsBefore(path, this->Sorted[i], this->Sorted[j]); });
  }
  return numbers;
}
}
