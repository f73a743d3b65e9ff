// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/StagesMemory.h"

#include <vector>

namespace recon
{
namespace
{
template <typename T>
std::size_t BytesOf(const std::vector<T>& values)
{
  return values.capacity() * sizeof(T);
}

std::size_t BytesOf(const LevelTriangulation& level)
{
  return BytesOf(level.Points) + BytesOf(level.Source) + BytesOf(level.Kind) +
    BytesOf(level.AskedBy) + BytesOf(level.Triangles) + BytesOf(level.Neighbours) +
    BytesOf(level.EdgeContour) + BytesOf(level.Inside) + BytesOf(level.Region) +
    BytesOf(level.StarTriangle);
}

std::size_t BytesOf(const SlabTetrahedra& slab)
{
  return BytesOf(slab.Tetrahedra) + BytesOf(slab.Links);
}
}

std::size_t BytesOfLevel(const PolyhedralStages& stages, std::size_t level)
{
  const LevelState& of = stages.Levels[level];
  std::size_t bytes = sizeof(LevelState) + BytesOf(of.Triangulation) + BytesOf(of.Covered.Covered) +
    BytesOf(of.Covered.Isolated) + BytesOf(of.Covered.Ends) + BytesOf(of.Lifted.Above) +
    BytesOf(of.Lifted.Below) + BytesOf(of.OutsideAbove) + BytesOf(of.OutsideBelow);
  for (const LevelTriangulation& before : stages.Earlier.Levels[level])
  {
    bytes += sizeof(LevelTriangulation) + BytesOf(before);
  }
  if (level > 0)
  {
    bytes += sizeof(SlabState) + BytesOf(stages.Slabs[level - 1].Diagram);
    for (const EarlierRounds::Slab& before : stages.Earlier.Slabs[level - 1])
    {
      bytes += sizeof(EarlierRounds::Slab) + BytesOf(before.Diagram);
    }
  }
  return bytes;
}

void ForgetBelow(std::size_t level, PolyhedralStages& stages)
{
  for (; stages.Forgotten < level; ++stages.Forgotten)
  {
    const std::size_t i = stages.Forgotten;
    LevelState& of = stages.Levels[i];
    of.Triangulation = {};
    of.Covered = {};
    of.Lifted = {};
    of.OutsideAbove = {};
    of.OutsideBelow = {};
    stages.Earlier.Levels[i] = {};
    if (i > 0)
    {
      stages.Slabs[i - 1].Diagram = {};
      stages.Earlier.Slabs[i - 1] = {};
    }
  }
}
}
