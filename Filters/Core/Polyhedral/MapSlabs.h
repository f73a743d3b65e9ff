// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MapSlabs.h
 * @brief Which regions the slabs may join: mapping, overrides and gaps (thesis chapter 3).
 */
#ifndef recon_MapSlabs_h
#define recon_MapSlabs_h

#include "Base/Monitor.h"
#include "Contours/ContourMapping.h"
#include "Polyhedral/PolyhedralOptions.h"
#include "Polyhedral/SlabState.h"

#include <string>
#include <vector>

namespace recon
{
/// What the surface's options say of the mapping.
ContourMappingOptions MappingOptionsOf(const PolyhedralOptions& options);

/**
 * Sets Joins of every slab, whose Thickness is known, and tells in report of the gaps.
 *
 * The mapping returned is empty where neither Overlap nor an override asks for one.
 */
ContourMapping MapSlabs(const ContourSet& contours, const PolyhedralOptions& options,
  std::vector<SlabState>& slabs, std::vector<std::string>& report, Monitor& monitor,
  const KnownOverlaps& known = {});
}

#endif
