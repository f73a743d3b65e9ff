// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MappingGroups.h
 * @brief From decisions to mapping groups, and their filters (thesis 3.2 and 3.3).
 */
#ifndef recon_MappingGroups_h
#define recon_MappingGroups_h

#include "Contours/ContourMapping.h"

#include <vector>

namespace recon
{
/**
 * MG: a group for all regions of a slab that joins link to one another, solid and non-solid apart,
 * and one for every region mapped to Phi. A group holds the walls and the holes of its regions;
 * that of a hole mapped to Phi holds its wall only, since it is that wall which is tiled or
 * ignored.
 *
 * Rule 1 of 3.3.1 has been applied to the joins. Groups that rule 3 tells to ignore are made all
 * the same: see FilterInternalWalls.
 */
std::vector<MappingGroup> FormMappingGroups(
  const ContourMapping& mapping, const ContourSet& contours);

/// Rules 2 and 3 of 3.3.1: without the groups of holes mapped to Phi that face no solid.
std::vector<MappingGroup> FilterInternalWalls(
  const std::vector<MappingGroup>& groups, const ContourMapping& mapping);

/// 3.3.2: in the order of their level, every group keeps what no group before it in its slab has.
std::vector<MappingGroup> FilterRedundantGroups(
  const std::vector<MappingGroup>& groups, const ContourSet& contours);
}

#endif
