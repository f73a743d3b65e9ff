// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourResampling.h
 * @brief Fewer, or more even, points on the same contours: the cost of a fit grows with their
 * number cubed.
 */
#ifndef recon_ContourResampling_h
#define recon_ContourResampling_h

#include "Contours/ContourSet.h"

namespace recon
{
/**
 * Points at about `spacing` along every contour (at least `MinimumPoints`, whatever its size).
 *
 * A contour that would cross itself or another of its level keeps its own points, with a line in
 * Report.
 */
ContourSet ResampleToSpacing(const ContourSet& contours, double spacing);

/// Leaves out points as long as the contour stays within `tolerance` of them (Douglas and Peucker),
/// as above.
ContourSet ResampleToTolerance(const ContourSet& contours, double tolerance);

/**
 * Leaves out points so that those kept stand about `spacing` apart, but for those that the contour
 * needs to stay within `ThinOutTolerance` x spacing of all that are left out. Points never move,
 * and none is added: a contour that is coarser than that stays as it is.
 *
 * Two kept points are nearer than `ClosestPart` x spacing only where the contour turns sharply:
 * nearly coincident points make the system ill-conditioned and tell nothing.
 */
ContourSet ThinOut(const ContourSet& contours, double spacing);

/// What FillLongEdges did.
struct FilledEdges
{
  ContourSet Contours;
  std::size_t Edges = 0;  ///< so many got points
  std::size_t Points = 0; ///< so many
};

/**
 * Puts points, evenly and at most `spacing` apart, on edges longer than `longest` that were drawn
 * straight: much longer than most, or between two corners. At most `mostPoints` of them, by a larger
 * spacing.
 */
FilledEdges FillLongEdges(
  const ContourSet& contours, double longest, double spacing, std::size_t mostPoints);

constexpr double ThinOutTolerance = 0.05; ///< part of the spacing that a contour may move by
constexpr double ClosestPart = 0.05;      ///< part of the spacing that corners keep apart

/// A resampled contour keeps at least this many points where it has them.
constexpr int MinimumPoints = 8;
}

#endif
