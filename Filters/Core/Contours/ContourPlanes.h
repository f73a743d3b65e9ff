// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourPlanes.h
 * @brief The planes that rings lie in, and the rings of every plane (thesis 2.1).
 */
#ifndef recon_ContourPlanes_h
#define recon_ContourPlanes_h

#include "Base/Monitor.h"
#include "Contours/ContourChaining.h"
#include "Contours/ContourNotes.h"

#include <string>
#include <vector>

namespace recon
{
/// A plane and the numbers of the rings that lie in it.
struct PlaneOfRings
{
  PlanarFrame Frame;
  double Offset = 0; ///< along Frame.Normal; exact where all points agree and the normal is an axis
  double Thickness = 0; ///< farthest distance of a point from the plane
  std::vector<int> Rings;
};

struct PlaneGrouping
{
  bool Parallel = false; ///< one common normal; offsets increase
  std::vector<PlaneOfRings> Planes;
  std::string Warning; ///< see ContourSet::Warning
};

struct PlaneOptions
{
  /// Rings of other directions are left out; otherwise each plane of theirs is a group, in the
  /// order of the first ring in it.
  bool OnlyParallel = true;
  double Tolerance = 0; ///< as ContourSetOptions::PlaneTolerance
  double Size = 0;      ///< diagonal of the bounding box
};

/**
 * Groups rings by plane; rings that fit no plane are named in notes.
 *
 * A ring lies in a plane where all its points are within tolerance of it, whatever normal its own
 * area suggests: the tips of a phantom are rings of almost no area, whose own normal is noise. The
 * common normal is the one that most rings agree on (then the most area), exactly a coordinate axis
 * where that is within tolerance, and otherwise with a positive largest component.
 *
 * How far a ring may be off its plane: 1e-5 of the diagonal or the caller's tolerance, more where
 * the rings show that their coordinates were rounded (30 times as much, or two steps of the
 * rounding), and in any case a fifth of the distance to the next level, if the rings' own planes are
 * within three degrees of the common one. Anything above the first is told in one sentence of
 * notes.
 *
 * Which parallel rings are one level: GroupLevels. Where the soup says of all rings in which level
 * they are, and they still lie there, those levels are kept.
 */
PlaneGrouping GroupByPlane(const LoopSoup& soup, const std::vector<Ring>& rings,
  const PlaneOptions& options, ContourNotes& notes, Monitor& monitor);
}

#endif
