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
/// A line for every join that was asked for and that no tetrahedron makes.
void ReportJoinsNotMade(const ContourMapping& mapping, const std::vector<LevelState>& levels,
  const std::vector<SlabState>& slabs, std::vector<std::string>& report);

/// A line for every contour of isolated regions, unless these are extruded.
void ReportContoursLeftOut(const ContourSet& contours, const std::vector<LevelState>& levels,
  const PolyhedralOptions& options, std::vector<std::string>& report);

/// Contours of which not one point is a point of the surface.
std::size_t CountLeftOut(const ContourSet& contours, const TriangleMesh& mesh);

/// Nothing is ever an empty surface without an error. @throws Error with the last line of report.
void CheckNotEmpty(const TriangleMesh& mesh, const std::vector<std::string>& report);

/// A line for the levels that have no condition 2 (LevelTriangulation.h).
void ReportLevelsWithoutCondition2(
  const std::vector<LevelState>& levels, std::vector<std::string>& report);
}

#endif
