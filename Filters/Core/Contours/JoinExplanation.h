// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file JoinExplanation.h
 * @brief Decisions of the mapping, worded for people.
 */
#ifndef recon_JoinExplanation_h
#define recon_JoinExplanation_h

#include "Contours/ContourMapping.h"

#include <string>

namespace recon
{
/// What a sentence needs beside the decision itself.
struct JoinContext
{
  double Threshold = 0;
  double Gap = 0;         ///< thickness of the slab, in the input's units
  double Spacing = 0;     ///< thickness of the slabs beside it, see LevelGaps::Usual
  double MaximumGap = 0;  ///< in multiples of Spacing
  double FacingSolid = 0; ///< share of a hole without partner that faces solid
  bool TooWide = false;   ///< the slab is thicker than MaximumGap allows
};

/// "z = 45" where the levels are perpendicular to z, "offset = 45" where they are tilted.
std::string PlaceOf(const Level& level);

/// One sentence: which contours, joined or not, and why.
std::string DescribeJoin(const ContourSet& contours, const ContourMapping& mapping,
  const ContourJoin& join, const JoinContext& context);

/// What decided, in a word or two: "Overlap", "Gap too wide", "Internal wall 2".
std::string RuleName(const ContourJoin& join);

/// The contours around a region: its wall, then the walls directly inside it; empty for region -1.
std::string RegionContours(const ContourMapping& mapping, int region);
}

#endif
