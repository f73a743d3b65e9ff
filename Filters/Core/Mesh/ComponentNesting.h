// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ComponentNesting.h
 * @brief Which components of a mesh lie inside others: what tells a cavity from a solid turned
 * inside out.
 */
#ifndef recon_ComponentNesting_h
#define recon_ComponentNesting_h

#include "TriangleMesh.h"

#include <vector>

namespace recon
{
/**
 * A component: the number of other components for which encloses is true that lie around it.
 *
 * Even-odd along a vertical ray from one point of the component, all decisions exact. Where that
 * point lies on another component, up to seven others are tried.
 */
std::vector<int> FindComponentNesting(const TriangleMesh& mesh,
  const std::vector<int>& componentOfTriangle, const std::vector<bool>& encloses);
}

#endif
