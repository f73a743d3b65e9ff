// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralOptions.h
 * @brief What may be chosen about the Polyhedral Surface Method.
 */
#ifndef recon_PolyhedralOptions_h
#define recon_PolyhedralOptions_h

#include "Contours/ContourMapping.h"
#include "Contours/ContractDecision.h"
#include "Contours/LevelAlignment.h"

#include <utility>
#include <vector>

namespace recon
{
/// The defaults are the thesis's own method, with flat ends; those of the filter that users meet
/// are what comes nearest to the truth.
struct PolyhedralOptions
{
  enum MappingType
  {
    Proximity = 0, ///< the Voronoi diagrams alone decide what is joined
    Overlap = 1 ///< only regions that overlap by more than OverlapThreshold are (thesis chapter 3)
  };
  enum EndCapsType
  {
    Flat = 0,        ///< in the plane of the contour: no volume added
    HalfSlice = 1,   ///< half a slice straight on, as planning systems count volumes
    Tapered = 2,     ///< rounded off: see EndShare and PartialEnds.h
    NoCaps = 3,      ///< left open: the surface is then not closed
    Extrapolated = 4 ///< as the sections before tell, rounded like these: see EndShapes.h
  };
  enum IsolatedContoursType
  {
    Drop = 0,   ///< left out, with a line in Report
    Extrude = 1 ///< half a slice each way
  };

  /// Whether such ends are rounded off, with points of their own, which parts that end get, too.
  static bool IsRounded(EndCapsType ends) { return ends == Tapered || ends == Extrapolated; }

  bool InternalPoints = true;     ///< thesis 5.3
  bool LiftInternalPoints = true; ///< thesis 6.2
  MappingType Mapping = Proximity;
  double OverlapThreshold = 0.1;                   ///< share of the smaller region, in [0, 1)
  std::vector<std::pair<int, int>> ForcedJoins;    ///< pairs of ContourId on adjacent levels
  std::vector<std::pair<int, int>> ForbiddenJoins; ///< wins over ForcedJoins
  int ExpectedPieces = -1;  ///< closed sheets of the surface, walls of cavities, too; -1: any
  int ExpectedHandles = -1; ///< of the whole surface; -1: any
  /// What these two come to (TopologyContract.h), followed beside the mapping.
  std::vector<ContractDecision> Contract;
  /// Slabs thicker than this many times those beside them are not bridged; 0 = all are.
  double MaximumGap = DefaultMaximumGap;
  LevelAlignmentMode AlignLevels = LevelAlignmentMode::Off; ///< of oblique shapes
  EndCapsType EndCaps = Flat;
  IsolatedContoursType IsolatedContours = Drop;
  /// Where sheets touch in a point or an edge they are drawn apart by this part of the median edge
  /// length; 0 = they keep points of their own in one place.
  double PinchGap = 0;
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
};
}

#endif
