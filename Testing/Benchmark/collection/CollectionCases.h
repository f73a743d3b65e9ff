// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CollectionCases.h
 * @brief The contours of one case of the collection, out of the words that name it.
 *
 * Words are separated by tabs; the first says where contours come from:
 *
 *     cut FILE DIRECTION SLICES SHIFT   a closed mesh (.off) by equally spaced planes; DIRECTION 0 to 2 is an axis, 3 oblique
 *     network FILE SEED                 a closed mesh by three to six planes of any direction
 *     label FILE LABEL AXIS STEP        outlines of the voxels of a label, on each STEP-th slice along an axis
 *     region FILE NUMBER                a region of a file of contours
 *     nested SEED                       a random stack, with random options
 */
#ifndef recon_CollectionCases_h
#define recon_CollectionCases_h

#include "Contours/ContourSet.h"
#include "Contours/ContourSetBuilder.h"
#include "Polyhedral/PolyhedralOptions.h"

#include <string>
#include <vector>

namespace recon::collection
{
struct Case
{
  LoopSoup Soup;
  ContourSetOptions Cleaning;
  PolyhedralOptions Options; ///< the node's defaults, where the case has none of its own
  bool Implicit = false;     ///< planes cross, so it is for the implicit method
  unsigned Seed = 0;
};

/// @throws Error where the words name no case, or a file cannot be read.
Case MakeCase(const std::vector<std::string>& words);

/// Names of the regions of a file of contours.
std::vector<std::string> RegionsOf(const std::string& fileName);
}

#endif
