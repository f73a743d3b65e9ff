// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file JointCells.h
 * @brief The Voronoi diagrams of a slab's two levels laid over each other, before any crossing is
 * known.
 */
#ifndef recon_JointCells_h
#define recon_JointCells_h

#include "Polyhedral/JointVoronoiPredicates.h"
#include "Polyhedral/VertexStars.h"

#include <array>
#include <vector>

namespace recon
{
/// The lower level is number 0, the upper one number 1.
class JointCells
{
public:
  JointCells(const LevelTriangulation& lower, const LevelTriangulation& upper);

  const LevelTriangulation& LevelAt(int level) const { return *this->Levels[level]; }
  const VertexStars& Stars(int level) const { return this->AllStars[level]; }
  const CircumcentreDistance& Distance(int level) const { return this->Distances[level]; }
  /// Of every triangle of the level its apex: the vertex of the other level that is nearest to its
  /// circumcentre.
  const std::vector<int>& Apices(int level) const { return this->AllApices[level]; }

private:
  std::array<const LevelTriangulation*, 2> Levels;
  std::array<VertexStars, 2> AllStars;
  std::array<CircumcentreDistance, 2> Distances;
  std::array<std::vector<int>, 2> AllApices;
};
}

#endif
