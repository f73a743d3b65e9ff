// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TopologyContract.h
 * @brief Pieces and handles by contract: the cheapest changes of what is joined that meet them.
 *
 * How many pieces and handles a shape has is often known (a bone is one piece), where slices do not
 * show what holds it together between them. The solid is built, its pieces and handles are counted
 * (components and Euler number of its boundary), and of the kind that is wanting the cheapest candidates
 * (ContractCandidates.h) are decided, until the count is what was asked for. Each is kept only if it
 * changes the count as it should, so what came out is known, not hoped for. Handles too many are left:
 * SectionCuts.h takes the cheapest off the finished surface.
 */
#ifndef recon_TopologyContract_h
#define recon_TopologyContract_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Contours/ContractDecision.h"
#include "Mesh/PiecesAndHandles.h"
#include "Polyhedral/PolyhedralOptions.h"

#include <string>
#include <vector>

namespace recon
{
struct MetContract
{
  std::vector<ContractDecision> Decisions; ///< Join, Part and Tunnel
  PiecesAndHandles Untold;                 ///< what came out without them
  bool IsExhausted = false;                ///< more surfaces would have been needed than are tried
};

/// Whether the options ask for a number of pieces or handles.
bool AsksForTopology(const PolyhedralOptions& options);

/// @throws Error where a number cannot be asked for, and as BuildPolyhedralStages does; Aborted.
MetContract MeetContract(
  const ContourSet& contours, const PolyhedralOptions& options, Monitor& monitor);

/// How many handles of a surface are to be cut off.
int HandlesTooMany(const PolyhedralOptions& options, const PiecesAndHandles& found);

/// A sentence: asked, got, by what, and, where it is not what was asked for, why.
std::string DescribeContract(const ContourSet& contours, const PolyhedralOptions& options,
  const MetContract& met, const std::vector<ContractDecision>& decisions,
  const PiecesAndHandles& found);
}

#endif
