// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LeftOutSlices.h
 * @brief Which margins are nearer to slices that they have not seen?
 */
#ifndef recon_LeftOutSlices_h
#define recon_LeftOutSlices_h

#include "Implicit/Constraints/MarginFit.h"

#include <cstddef>
#include <vector>

namespace recon
{
/// What margins can be, other than in the contours' planes with their distance in these.
enum class MarginWay
{
  Turned,  ///< half way to the normals of a first fit (RefinedMargins.h)
  Valued,  ///< in the planes, valued by those normals
  Reaching ///< in the planes, reaching across steps (ConstraintOptions::ReachAcrossSteps)
};

/// How far margins turn that are judged by left-out slices. Measured on sets with a reference
/// surface: eight_15 .00178 in the planes, .00115 at .15, .00099 at .3, .00098 at .5, .00122 all
/// the way (mean distance).
constexpr double TurnedPart = 0.5;

/// A vote of vertices, not a mean: where nothing predicts the surface, at branchings, all ways miss
/// by anything.
struct SliceVotes
{
  std::size_t Better = 0; ///< vertices that the way predicts better than margins in the planes
  std::size_t All = 0;    ///< that either predicts better

  bool Pass() const { return 2 * this->Better >= this->All; }
};

/**
 * @class LeftOutSlices
 * @brief Leaves out every third level in turn, fits the others with margins in their planes, and
 * compares with that what other margins make of the levels left out.
 *
 * The first and the last level stay: beyond them nothing can be predicted.
 */
class LeftOutSlices
{
public:
  /// At least so many levels are needed to leave some out.
  static constexpr std::size_t LeastLevels = 6;

  /**
   * Fits margins in the planes. @param contours as they will be fitted; outlive this, as do the
   * options. @throws Error, Aborted
   */
  LeftOutSlices(const ContourSet& contours, const ConstraintOptions& constraintOptions,
    const FunctionOptions& functionOptions, Monitor& monitor);

  /// @throws Error, Aborted
  SliceVotes Judge(MarginWay way, Monitor& monitor) const;

private:
  struct Turn
  {
    ContourSet Seen;
    ContourSet Unseen;
    MarginFit First;
    std::vector<double> Misses; ///< its distances from the vertices of Unseen
  };

  std::vector<double> MissesOf(const Turn& turn, MarginWay way, Monitor& monitor) const;

  ConstraintOptions Constraints;
  FunctionOptions Function;
  double Tie = 0;
  std::vector<Turn> Turns;
};
}

#endif
