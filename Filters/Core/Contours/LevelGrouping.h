// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LevelGrouping.h
 * @brief Which contours of parallel planes are one level: slices that are nearer than a tolerance.
 */
#ifndef recon_LevelGrouping_h
#define recon_LevelGrouping_h

#include "Base/Geometry.h"

#include <cstddef>
#include <vector>

namespace recon
{
/// Levels nearer than this part of their median spacing are one.
constexpr double LevelShare = 0.05;
/// In data of which the unit is known to be the millimetre, never more than this.
constexpr double MostLevelTolerance = 0.1;

/// One contour, as far as its level is concerned.
struct LevelCandidate
{
  double Offset = 0;   ///< middle of its points along the common normal
  double Noise = 0;    ///< how far its points lie off its own plane
  Point2 Low{ 0, 0 };  ///< its bounding box in the plane
  Point2 High{ 0, 0 }; ///< see Low
};

struct LevelGrouping
{
  std::vector<int> LevelOf; ///< a candidate: its level, numbered by increasing offset
  int Count = 0;
  double Tolerance = 0;    ///< levels nearer than this are one
  double Spacing = 0;      ///< median distance of neighbouring levels, 0 for one level
  double WidestMerge = 0;  ///< largest distance of two neighbours of a level; 0: as good as equal
  std::vector<int> Merged; ///< levels whose contours lie farther apart than their noise
  /// Distance to the nearer one of the neighbouring levels; infinite where there is none.
  std::vector<double> Room;
};

/**
 * Groups contours by offset.
 *
 * With a tolerance of 0 it is found from the offsets: the largest part of them is merged for which
 * every merged distance is at most LevelShare of the median of those that are left, so that it does
 * not matter how many contours of a slice lie beside it. The size of the contours plays no part.
 * Two refinements keep what is drawn apart: a group whose inner distances are not small beside those
 * to the groups around it is no level, nor one of three slices of one thing (depths 0, 1, 2, 5, 10,
 * 50, 100, 200 ...), and where more than half of the distances would have to go, the contours must not look like slices of one thing (three
 * stacks far apart are not three levels).
 *
 * @param tolerance distance below which levels are one, or 0
 * @param millimetres the unit is known to be the millimetre, so MostLevelTolerance holds
 */
LevelGrouping GroupLevels(
  const std::vector<LevelCandidate>& candidates, double tolerance, bool millimetres);
}

#endif
