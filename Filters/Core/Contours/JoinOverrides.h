// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file JoinOverrides.h
 * @brief Joins that a user forces or forbids, checked and sorted by slab.
 */
#ifndef recon_JoinOverrides_h
#define recon_JoinOverrides_h

#include "Contours/ContourMapping.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// What a user wants of pairs of regions, lower first.
struct JoinOverrides
{
  /// Of a slab: pair of walls -> true: force, false: forbid.
  using Pairs = std::map<std::pair<int, int>, bool>;
  std::vector<Pairs> OfSlab;
  std::vector<std::string> Report; ///< a sentence for every pair that cannot be followed
};

JoinOverrides ResolveOverrides(const ContourSet& contours, const ContourMappingOptions& options);
}

#endif
