// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LevelState.h
 * @brief Everything that the method knows of one level, as it grows from stage to stage.
 */
#ifndef recon_LevelState_h
#define recon_LevelState_h

#include "Planar/PlanarContourDistance.h"
#include "Polyhedral/Coverage.h"
#include "Polyhedral/LevelTriangulation.h"

#include <memory>
#include <vector>

namespace recon
{
struct LevelState
{
  double Offset = 0;                               ///< of its plane along the common normal
  std::unique_ptr<LevelTriangulator> Triangulator; ///< null once all its points are in
  LevelTriangulation Triangulation;                ///< of the triangulator's last Finish()
  bool Changed = true;                             ///< Triangulation is new in this round of slabs
  std::unique_ptr<PlanarContourDistance> Distance;
  std::vector<int> Needles;             ///< contours that were given up, see LevelTriangulator
  std::vector<Point2> InternalSkeleton; ///< empty where partial ends are not rounded off
  Coverage Covered;
  LiftedHeights Lifted;
  /// Of every point whether it is internal and lies outside the contours of the level above and of
  /// the one below; 0 where there is no such level.
  std::vector<unsigned char> OutsideAbove;
  std::vector<unsigned char> OutsideBelow;
};
}

#endif
