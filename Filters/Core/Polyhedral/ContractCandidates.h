// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContractCandidates.h
 * @brief What could be joined, parted or opened between adjacent levels, and what it should change.
 *
 * Joined regions are the edges of a graph of all regions. A spanning forest of the strongest holds
 * pieces together. Regions that face each other and are not joined, and walls of holes that face what is
 * not solid through solid, are edges that could be added: of two pieces they make one, of one piece a
 * handle.
 */
#ifndef recon_ContractCandidates_h
#define recon_ContractCandidates_h

#include "Contours/ContractDecision.h"
#include "Polyhedral/PolyhedralStages.h"

#include <vector>

namespace recon
{
/// What belongs together: an edge of the forest, and those that would hold its two parts together
/// without it.
using ContractStep = std::vector<ContractDecision>;

struct ContractCandidates
{
  /// Each the cheapest first, in an order that depends on the stages alone.
  std::vector<ContractStep> Joining; ///< should make one piece of two
  std::vector<ContractStep> Looping; ///< should make a handle
  std::vector<ContractStep> Parting; ///< should make two pieces of one
};

/// @param stages with all tetrahedra, and a mapping
/// @param pieceOfContour of every contour a piece of the surface that it lies on
ContractCandidates FindContractCandidates(const ContourSet& contours,
  const PolyhedralStages& stages, const std::vector<int>& pieceOfContour);
}

#endif
