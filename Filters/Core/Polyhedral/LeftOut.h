// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LeftOut.h
 * @brief Tells of what was drawn or asked for and is not part of the surface, or less than usual.
 */
#ifndef recon_LeftOut_h
#define recon_LeftOut_h

#include "Contours/ContourMapping.h"
#include "Mesh/TriangleMesh.h"
#include "Polyhedral/LevelState.h"
#include "Polyhedral/PolyhedralOptions.h"
#include "Polyhedral/SlabState.h"

#include <cstddef>
#include <string>
#include <vector>

namespace recon
{
/**
 * What the stages have to say, collected level by level and slab by slab, as they may be gone at the end.
 */
class StageReport
{
public:
  /// Contours and options must outlive this.
  StageReport(
    const ContourSet& contours, const PolyhedralOptions& options, const ContourMapping& mapping);

  /// Levels and slabs that are finished, in their order.
  void AddLevel(const LevelState& level);
  void AddSlab(
    int slab, const LevelState& lower, const LevelState& upper, const SlabTetrahedra& diagram);

  /// Lines on needles that were given up, on levels without condition 2 (LevelTriangulation.h), on every join that
  /// was asked for and that no tetrahedron makes, and on every contour of isolated regions, unless these are extruded.
  void Write(std::vector<std::string>& report) const;

private:
  struct ForcedJoin
  {
    int Slab;
    int Lower; ///< outer wall of the region
    int Upper;
    bool Made;
  };

  const ContourSet& Contours;
  const PolyhedralOptions& Options;
  std::vector<std::string> Needles;
  std::vector<std::string> WithoutCondition2;
  std::vector<ForcedJoin> Forced;
  std::vector<unsigned char> Bounds; ///< by contour what it bounds, see LeftOut.cxx
};

/// Contours of which not one point is a point of the surface.
std::size_t CountLeftOut(const ContourSet& contours, const TriangleMesh& mesh);

/// Nothing is ever an empty surface without an error. @throws Error with the last line of report.
void CheckNotEmpty(const TriangleMesh& mesh, const std::vector<std::string>& report);
}

#endif
