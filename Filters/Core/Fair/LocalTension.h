// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LocalTension.h
 * @brief How much tension a fair surface has where.
 */
#ifndef recon_LocalTension_h
#define recon_LocalTension_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/// The tension before it is known how much the surface bends.
constexpr double FirstTension = 0.1;

/**
 * A tension a point: little where the surface bends as much as slices can show; much where it bends
 * within less than their distance, where a thin plate swings too far, and where the polyhedral surface is
 * flat, which swings out beside its edges.
 *
 * @param rest how much the polyhedral surface bends at each point, by the slices' distance
 * @param bends the same of a fair surface, see FairSystem::BendOf
 * @param edges to the slices' distance, over which bends are evened out
 */
std::vector<double> TensionByBend(const TriangleMesh& mesh, const std::vector<double>& rest,
  const std::vector<double>& bends, double edges);
}

#endif
