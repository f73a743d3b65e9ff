// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ComponentNesting.h
 * @brief The depth of each component of a mesh within others, which tells a cavity from a solid
 * turned inside out.
 */
#ifndef recon_ComponentNesting_h
#define recon_ComponentNesting_h

#include "Mesh/TriangleMesh.h"

#include <vector>

namespace recon
{
/**
 * The number of components around each component, of those for which encloses is true.
 *
 * Even-odd along vertical rays from eight corners of the component (all, where it has few
 * triangles), all decisions exact. A component lies around another where it does around all of these
 * corners that are not on its surface, so components that cross or stand side by side are around
 * neither. Where all of them are on its surface, most of the middles of eight faces decide.
 */
std::vector<int> FindComponentNesting(const TriangleMesh& mesh,
  const std::vector<int>& componentOfTriangle, const std::vector<bool>& encloses);
}

#endif
