// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourSetBuilder.h
 * @brief From contours as they arrive to a ContourSet that the methods can trust.
 */
#ifndef recon_ContourSetBuilder_h
#define recon_ContourSetBuilder_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"

namespace recon
{
/// What becomes of lines that are open by more than the distance of their points.
enum class OpenLineRule
{
  LeaveOut, ///< with a line in Report
  Chord,    ///< closed by a straight line
  Border ///< closed along the border of the rectangle around all contours of the plane's direction
};

struct ContourSetOptions
{
  /// true: one common normal is wanted (PSM); contours of other planes are left out with a line in
  /// Report. false: planes of any orientation (ISM); each plane becomes a level with a frame of its
  /// own.
  bool Parallel = true;
  /**
   * Levels nearer than this, in the input's units, are one; 0 finds the distance from the contours:
   * 5% of the median distance of neighbouring levels, and at most 0.1 where the unit is known to be
   * the millimetre (LoopSoup::Millimetres). What was merged has a line in Report. The size of the
   * contours plays no part: slices may be as near as they like, if they are evenly so.
   *
   * A contour may be off the plane of its level by as much, too. It may always be off by a fifth of
   * the distance to the next level, if its plane is within three degrees of the common one, and by
   * what its rounded coordinates show, with a line in Report; so a larger value keeps contours that
   * were left out as not planar or tilted, and a smaller one never loses any.
   *
   * Levels that an earlier filter found (LoopSoup::Levels) stay as they are whatever this says.
   *
   * Nothing above a tenth of the distance of the levels makes sense. Up to now the value was a
   * fraction of the bounding box's diagonal, 1e-5 by default: stored values of that kind merge next
   * to nothing.
   */
  double PlaneTolerance = 0;
  /// In the plane of a level, points and edges that are nearer than this become one before anything
  /// else, and slivers that are narrower vanish; in the units of the input. 0: automatic, a ten
  /// millionth of each contour's diagonal (SnapTolerance.h). Outlines that are stored twice on a
  /// level with other decimals, or traced twice, are one contour at any setting (LoopTwins.h). What
  /// either changes has a line in Report; what has no such defect keeps every bit.
  double SnapTolerance = 0;
  /// Levels with a chain that is ExclusiveOr go by EvenOdd whatever this says, with a line in
  /// Report where it says otherwise. What was found is in Level::HoleNote.
  HoleRule Holes = HoleRule::Automatic;
  /// Isolines that leave their window are meant to be closed along its border, drawings with a gap
  /// by a straight line. Border takes parallel planes only. Lines whose ends are no farther apart
  /// than their points are always closed.
  OpenLineRule OpenLines = OpenLineRule::LeaveOut;
};

/**
 * Chain, close, clean, resolve and nest (thesis 2.1 and 3.1).
 *
 * Where more than half of the contours are open and left out, or lie in other planes than the rest,
 * ContourSet::Warning says so.
 *
 * @throws NothingToDo where there are open lines only; Error where not one usable contour is left
 * for other reasons; the sentence says why.
 */
ContourSet BuildContourSet(
  const LoopSoup& soup, const ContourSetOptions& options, Monitor& monitor);
}

#endif
