// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContractMapping.h
 * @brief The mapping of contours with what a contract on pieces and handles decides.
 */
#ifndef recon_ContractMapping_h
#define recon_ContractMapping_h

#include "Base/Monitor.h"
#include "Contours/ContourMapping.h"
#include "Contours/LevelAlignment.h"

namespace recon
{
struct TopologyAsked
{
  int Pieces = -1;  ///< see PolyhedralOptions::ExpectedPieces
  int Handles = -1; ///< see PolyhedralOptions::ExpectedHandles
};

struct ContractMapping
{
  ContourMapping Mapping;
  /// The joins of Mapping, and a row for every place between two levels that is cut or filled.
  ContourMapping WithCuts;
};

/**
 * As Polyhedral Surface with the defaults that users meet does, so that both come to the same decisions.
 *
 * Report of either begins with that of the alignment. Where nothing is asked for, no surface is made.
 *
 * @throws as BuildContourMapping and BuildPolyhedralSurface do
 */
ContractMapping MapByContract(const ContourSet& contours, const ContourMappingOptions& options,
  LevelAlignmentMode align, const TopologyAsked& asked, Monitor& monitor);
}

#endif
