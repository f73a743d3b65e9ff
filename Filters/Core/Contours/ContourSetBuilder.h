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
struct ContourSetOptions
{
  /// true: one common normal is wanted (PSM); contours of other planes are left out with a line in
  /// Report. false: planes of any orientation (ISM); each plane becomes a level with a frame of its
  /// own.
  bool Parallel = true;
  /// Points closer than this fraction of the bounding box's diagonal count as one plane's. Where
  /// the contours themselves are less flat, up to 30 times as much is allowed, with a line in
  /// Report.
  double PlaneTolerance = 1e-5;
  /// In the plane of a level, points and edges that are nearer than this become one before anything
  /// else, and slivers that are narrower vanish; in the units of the input. 0: automatic, a ten
  /// millionth of each contour's diagonal (SnapTolerance.h). Outlines that are stored twice on a
  /// level with other decimals, or traced twice, are one contour at any setting (LoopTwins.h). What
  /// either changes has a line in Report; what has no such defect keeps every bit.
  double SnapTolerance = 0;
  /// Levels with a chain that is ExclusiveOr go by EvenOdd whatever this says, with a line in
  /// Report where it says otherwise. What was found is in Level::HoleNote.
  HoleRule Holes = HoleRule::Automatic;
};

/**
 * Chain, close, clean, resolve and nest (thesis 2.1 and 3.1).
 *
 * @throws Error where not one usable contour is left; the sentence says why.
 */
ContourSet BuildContourSet(
  const LoopSoup& soup, const ContourSetOptions& options, Monitor& monitor);
}

#endif
