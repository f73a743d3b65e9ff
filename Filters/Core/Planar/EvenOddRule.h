// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EvenOddRule.h
 * @brief Loops of one level that touch, overlap or cross, made simple by the even-odd rule, or by
 * the winding rule.
 */
#ifndef recon_EvenOddRule_h
#define recon_EvenOddRule_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"

#include <cstddef>
#include <vector>

namespace recon
{
/// What became of loops that touched one another or themselves.
struct EvenOddCluster
{
  std::vector<int> Loops;    ///< numbers of the loops as they came
  std::vector<int> Vanished; ///< those of which no edge is left
  std::size_t Crossings = 0; ///< pairs of edges that crossed
  std::size_t OnEdge = 0;    ///< points found on another edge, within the tolerance
  std::size_t Cancelled = 0; ///< edges walked an even number of times
  std::size_t Shared = 0;    ///< points passed more than once
  std::size_t Merged = 0;    ///< points that another stands for, as it is within the tolerance
  double Moved = 0;          ///< the farthest of them from the one that stands for it
  double Tolerance = 0;      ///< the largest of its loops: what is nearer was one place
  std::size_t Results = 0;   ///< loops that came out
  bool Changed = false;      ///< false: they only touch in points, and are as they were
  const char* Rule = "even-odd";
};

struct EvenOddResult
{
  struct Loop
  {
    std::vector<int> Points;
    int Origin = -1; ///< the first of the loops as they came that it has an edge of
  };
  std::vector<Loop> Loops; ///< simple; they do not cross and meet in points only; sorted by Origin
  std::vector<EvenOddCluster> Clusters;
  std::vector<int> Swallowed; ///< winding rule: loops that touch none, with solid on both sides
};

/**
 * Inside is where a ray to infinity crosses the loops an odd number of times.
 *
 * Loops without trouble are kept as they are. The others are snapped and split where they meet
 * (Arrangement.h), edges walked an even number of times go (bridges of keyholes, spikes, common
 * borders, slivers below the tolerance), and the rest is traced around the inside. A crossing is
 * computed exactly and rounded once; what the rounding disturbs is found and split again, so that
 * the result is exact for the coordinates that it has.
 *
 * @param points of the level, with distinct coordinates; crossings are appended
 * @param loops neighbours differ, at least 3 points each
 * @param snapTolerance what is nearer is one place; 0: as SnapTolerance.h says
 * @throws Error where the rounding of crossings does not come to rest
 */
EvenOddResult ApplyEvenOddRule(std::vector<Point2>& points,
  const std::vector<std::vector<int>>& loops, double snapTolerance = 0);

/**
 * The same, where inside is where the loops wind around a nonzero number of times, each in its own
 * direction: loops within loops of the same direction go.
 */
EvenOddResult ApplyWindingRule(std::vector<Point2>& points,
  const std::vector<std::vector<int>>& loops, double snapTolerance = 0);
}

#endif
