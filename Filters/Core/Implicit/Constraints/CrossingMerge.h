// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CrossingMerge.h
 * @brief Points of crossing planes that lie next to one another become one (thesis 9.1).
 */
#ifndef recon_CrossingMerge_h
#define recon_CrossingMerge_h

#include "Implicit/Constraints/VertexMargins.h"

#include <string>
#include <vector>

namespace recon
{
/// Planes whose normals differ by less (sine) count as parallel: their points are never merged.
constexpr double ParallelSine = 1e-2;

/**
 * Groups of points of crossing planes that fit in a box of this part of the contours' bounding box
 * become their centroids, and their margins too.
 *
 * @param distance d, the margin distance. @param report gets a line where any were merged.
 */
std::vector<VertexMargins> MergeAtCrossings(const ContourSet& contours,
  const std::vector<VertexMargins>& margins, double part, double distance,
  std::vector<std::string>& report);
}

#endif
