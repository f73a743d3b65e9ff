// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file FaceGroups.h
 * @brief Which piece of solid, and which group of the mapping, each face of the surface belongs to.
 */
#ifndef recon_FaceGroups_h
#define recon_FaceGroups_h

#include "Contours/ContourMapping.h"
#include "Polyhedral/LevelState.h"
#include "Polyhedral/SolidBoundary.h"
#include "Polyhedral/SolidComplex.h"

#include <vector>

namespace recon
{
/// Of every cell the number of its piece: cells that hang together within a slab, numbered in the
/// order of the cells.
std::vector<int> FindPieces(const SolidComplex& solid);

/// Finds the groups of faces of parts of the stack.
class FaceGroups
{
public:
  /// Both must outlive this.
  FaceGroups(const ContourSet& contours, const ContourMapping& mapping);

  /**
   * Of every face the group of the mapping, as numbered there: that of the contours whose vertices
   * its corners are, or else that of most such corners of its piece. -1 where there is no mapping
   * (Proximity), beyond the first and the last level, and for contours that are in no group.
   *
   * @param pieces what FindPieces found
   */
  std::vector<int> Find(const std::vector<LevelState>& levels, const SolidComplex& solid,
    const SolidBoundary& boundary, const std::vector<int>& pieces) const;

private:
  const ContourSet& Contours;
  bool IsEmpty;           ///< there are no groups
  std::vector<int> Below; ///< of a contour: its group in the slab below its level
  std::vector<int> Above;
};
}

#endif
