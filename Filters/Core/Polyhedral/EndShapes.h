// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EndShapes.h
 * @brief How extrapolated ends rise over their last sections: what the sections before tell.
 *
 * The area of a section goes on along the parabola of the three before (SectionStack.h). So high
 * above the last section as that is A, the end has the shape of the last section shrunk evenly to
 * A: its part that is farther than some distance from the contours. Of a ball that is the ball.
 */
#ifndef recon_EndShapes_h
#define recon_EndShapes_h

#include "Base/Monitor.h"
#include "Contours/SectionStack.h"
#include "Polyhedral/LevelState.h"
#include "Polyhedral/PolyhedralOptions.h"

#include <map>
#include <optional>
#include <vector>

namespace recon
{
/// Of one region on one side.
class EndShape
{
public:
  /// @param end how high it is @param rooms distances from the contours of points spread evenly over
  /// the region, at least one
  EndShape(const SectionParabola& sections, double end, std::vector<double> rooms);

  /// Above the plane of the level, where the contours of the level are that far.
  double HeightAt(double distance) const;

private:
  SectionParabola Sections;
  double End;
  std::vector<double> Rooms; ///< ascending
};

/// By the outer wall of the region (a contour).
using EndShapesOfLevel = std::map<int, EndShape>;

/**
 * @class EndShapes
 * @brief What the sections of a stack tell of its ends.
 */
class EndShapes
{
public:
  /// @param mapping of the contours; empty: it is made, as Overlap would @throws Aborted
  EndShapes(const ContourSet& contours, const ContourMapping& mapping,
    const PolyhedralOptions& options, Monitor& monitor);

  /// Of the regions of a level that end on that side (1 above, -1 below) and have sections before;
  /// the level's Distance and Covered are known.
  EndShapesOfLevel Find(const LevelState& state, int level, int step) const;

private:
  double EndOf(const SectionParabola& sections, int level, int step) const;

  const int LevelCount;
  const ContourMapping Mapping;
  const LevelGaps Gaps;
  const SectionStack Stack;
};
}

#endif
