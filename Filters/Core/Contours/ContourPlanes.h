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

#include <vector>

namespace recon
{
/// A plane and the numbers of the rings that lie in it.
struct PlaneOfRings
{
  PlanarFrame Frame;
  double Offset = 0; ///< along Frame.Normal; exact where all points agree and the normal is an axis
  std::vector<int> Rings;
};

struct PlaneGrouping
{
  bool Parallel = false; ///< one common normal; offsets increase
  std::vector<PlaneOfRings> Planes;
};

/**
 * Groups rings by plane; rings that fit no plane are named in notes.
 *
 * A ring lies in a plane where all its points are within tolerance of it, whatever normal its own
 * area suggests: the tips of a phantom are rings of almost no area, whose own normal is noise. The
 * common normal is the one that most rings agree on (then the most area), exactly a coordinate axis
 * where that is within tolerance, and otherwise with a positive largest component.
 *
 * @param onlyParallel rings of other directions are left out; otherwise each plane of theirs is a
 * group, in the order of the first ring in it
 * @param tolerance farthest distance of a point from its plane, in the input's units; up to 30
 * times as much, with a sentence in notes, where rings are no flatter in their own planes
 */
PlaneGrouping GroupByPlane(const LoopSoup& soup, const std::vector<Ring>& rings, bool onlyParallel,
  double tolerance, ContourNotes& notes, Monitor& monitor);

/// The frame of PlanarFrame's comment for any unit normal.
PlanarFrame MakeFrame(const Vector3& unitNormal);
}

#endif
