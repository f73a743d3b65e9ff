// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourMapping.h
 * @brief Which regions of adjacent levels belong together (2D shape similarity, thesis chapter 3).
 *
 * Notation (thesis 3.1 to 3.3):
 *   SR, NSR        solid and non-solid regions of a level: a wall with the walls directly inside it
 *   mg, MG         mapping group: regions of two adjacent levels whose projections overlap; all of
 *                  them
 *   Phi            the empty region, partner of a region that has no other
 *   threshold      share of the smaller region's area that two regions must have in common
 */
#ifndef recon_ContourMapping_h
#define recon_ContourMapping_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "Contours/ContractDecision.h"
#include "Planar/RegionOverlaps.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace recon
{
/// Share of a slab's thickness below which regions that do not overlap are as good as touching.
constexpr double TouchingShare = 0.1;

/**
 * Gaps of up to this many spacings are bridged: a few slices that were skipped where little changes
 * (drawing tools interpolate them, and the widest gap within one shape of the sets at hand is 3
 * spacings). What is farther apart is two shapes of one name, such as lymph nodes, or two ends of a
 * stack whose middle is missing, and a bridge would be invented.
 */
constexpr double DefaultMaximumGap = 5;

struct ContourMappingOptions
{
  /// Two solid (or two non-solid) regions are joined where they share more than this part of the
  /// smaller.
  double OverlapThreshold = 0.1;
  /// Pairs of contours (ContourId, either order) whose regions are joined whatever the overlap.
  std::vector<std::pair<int, int>> ForcedJoins;
  /// Pairs of contours whose regions are not joined whatever the overlap; forbidding wins over
  /// forcing.
  std::vector<std::pair<int, int>> ForbiddenJoins;
  /// What a contract on pieces and handles decides (TopologyContract.h); overrides win over it.
  std::vector<ContractDecision> Contract;
  double MaximumGap = DefaultMaximumGap; ///< see FindLevelGaps; forced joins bridge gaps, too
  int Threads = 0;
};

/// A region of a level: inside Wall and outside Holes (the walls directly inside it).
struct ContourRegion
{
  int Level = -1;
  int Wall = -1;          ///< contour around it
  std::vector<int> Holes; ///< contours directly inside it
  bool Solid = true;      ///< thesis: SR; false: NSR
  double Area = 0;        ///< square units, exact polygon area with holes
};

/// One decision: a row of the joins table.
struct ContourJoin
{
  enum RuleType
  {
    ByOverlap,    ///< the overlap decided, either way
    Forced,       ///< by ForcedJoins
    Forbidden,    ///< by ForbiddenJoins
    GapTooWide,   ///< by MaximumGap
    NoPartner,    ///< mapped to Phi
    InternalWall, ///< one of the three rules of 3.3.1
    ByDistance,   ///< overlaps nothing above or below, but as good as touches
    ByContract    ///< as the expected pieces and handles ask for it, in whole or at a place
  };

  int Slab = -1;
  int LowerRegion = -1; ///< index into ContourMapping::Regions, or -1: Phi
  int UpperRegion = -1;
  double OverlapArea = 0; ///< square units
  double LowerRatio = 0;  ///< OverlapArea / area of the lower region
  double UpperRatio = 0;
  RuleType Rule = ByOverlap;
  double Distance = 0;      ///< in projection, where Rule is ByDistance
  int InternalWallRule = 0; ///< 1, 2 or 3 of 3.3.1 where Rule is InternalWall
  int TunnelTo =
    -1; ///< contour of the other level to which the contract opens the hole without partner
  bool Joined = false;
  std::string Words; ///< one sentence that a physicist reads
};

/// mg: contours of two adjacent levels that one skin joins, after the filters of 3.3.
struct MappingGroup
{
  int Slab = -1;
  std::vector<int> LowerContours;
  std::vector<int> UpperContours;
};

struct ContourMapping
{
  std::vector<ContourRegion> Regions;
  /// Of every contour: the region directly inside it (whose Wall it is).
  std::vector<int> RegionInside;
  /// By slab; in a slab solid pairs, non-solid pairs, then what is mapped to Phi.
  std::vector<ContourJoin> Joins;
  /// By slab; every contour is in at most one group of the slab below it, and of that above.
  std::vector<MappingGroup> Groups;
  std::vector<unsigned char> IsGap;                 ///< a slab: MaximumGap forbids to bridge it
  std::vector<std::vector<RegionOverlap>> Overlaps; ///< by slab; what takes longest to find
  /// A sentence for every override that cannot be followed, and why.
  std::vector<std::string> Report;
};

/// By slab, of those whose levels were mapped before; empty: none were.
using KnownOverlaps = std::vector<std::optional<std::vector<RegionOverlap>>>;

/**
 * Overlaps, decisions, groups and their filters (thesis 3.2, 3.3).
 *
 * One more rule than the thesis has: a solid region that overlaps no solid region above or below is
 * joined to the nearest one of these, if that is nearer in projection than TouchingShare of the
 * slab's thickness. The tip of a shape whose side is perpendicular to the planes is a sliver that
 * rounding and sampling put beside the contour it belongs to, and to leave it out would lose it. A
 * finger that ends overlaps its own finger, so it is never joined to another by this rule.
 *
 * An override names two contours of adjacent levels, both outer walls (the solid regions inside
 * them are meant) or both walls of holes (the holes are meant).
 *
 * @throws Error where the set is not Parallel or an option is out of range; Aborted.
 */
ContourMapping BuildContourMapping(const ContourSet& contours, const ContourMappingOptions& options,
  Monitor& monitor, const KnownOverlaps& known = {});
}

#endif
