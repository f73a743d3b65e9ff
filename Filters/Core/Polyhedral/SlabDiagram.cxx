// SPDX-License-Identifier: GPL-3.0-or-later
#include "Polyhedral/SlabDiagram.h"

#include "Polyhedral/BoundaryVoronoi.h"
#include "Polyhedral/Elimination.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace recon
{
namespace
{
/// Drawn contours have at most a few T12 a triangle; with more than this it is quicker, and takes
/// far less memory, to make those at the boundary only.
constexpr std::size_t MostT12ATriangle = 8;
}

SlabTetrahedra BuildSlabDiagram(const LevelTriangulation& lower, const LevelTriangulation& upper,
  const SlabJoins& joins, TetrahedraWanted wanted)
{
  const JointCells cells(lower, upper);
  const bool mayHaveGaps =
    wanted != TetrahedraWanted::All && lower.IsGabriel && upper.IsGabriel && !joins.HasContract();
  std::size_t most = std::numeric_limits<std::size_t>::max();
  if (mayHaveGaps)
  {
    most = wanted == TetrahedraWanted::BoundaryOnly
      ? 0
      : MostT12ATriangle * (lower.Triangles.size() + upper.Triangles.size());
  }
  std::optional<SlabTetrahedra> all =
    most > 0 ? BuildJointVoronoi(cells, most) : std::optional<SlabTetrahedra>();
  if (!all)
  {
    return BuildBoundaryVoronoi(cells, joins);
  }
  EliminateTetrahedra(lower, upper, joins, *all);
  return std::move(*all);
}
}
