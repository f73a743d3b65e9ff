// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SlabJoins.h
 * @brief Which regions of two adjacent levels may be joined by solid.
 *
 * Mapping groups are one more reason to drop a tetrahedron, not separate runs: the skins of two
 * groups never cross, because all tetrahedra are of one complex.
 */
#ifndef recon_SlabJoins_h
#define recon_SlabJoins_h

#include <set>
#include <utility>

namespace recon
{
/// Regions are named by their outer wall's ContourId.
struct SlabJoins
{
  bool IsGap = false;       ///< wider than MaximumGap allows: only forced joins bridge it
  bool AllByDefault = true; ///< whether pairs that Exceptions does not name are joined
  std::set<std::pair<int, int>> Exceptions; ///< (region of level 1, region of level 2)
  /// Of those that are joined: also across what lies outside the contours of both.
  std::set<std::pair<int, int>> Spanned;
  /// (contour of level 1, contour of level 2): no solid is spanned between them, so that what lies
  /// beyond the one is joined to what lies beyond the other.
  std::set<std::pair<int, int>> Tunnels;

  bool AreJoined(int region1, int region2) const
  {
    return this->AllByDefault != (this->Exceptions.count({ region1, region2 }) > 0);
  }

  /// Whether a contract (TopologyContract.h) asks for more than which regions are joined.
  bool HasContract() const { return !this->Spanned.empty() || !this->Tunnels.empty(); }
};
}

#endif
