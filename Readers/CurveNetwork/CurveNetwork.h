// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CurveNetwork.h
 * @brief Cross-sections with materials, as the parsers of .csl and .contour files hand them on.
 *
 * Vertices are those of the file, whatever its planes say; a plane that does not fit is told in the
 * report.
 */
#ifndef recon_CurveNetwork_h
#define recon_CurveNetwork_h

#include "Contours/ContourSet.h"

#include <string>
#include <vector>

namespace recon
{
/// The boundary of one material's region in every plane.
struct MaterialContours
{
  int Label = 0;
  LoopSoup Soup;
  std::vector<int> Planes; ///< of each chain, from 0 in the order of the file
};

struct CurveNetwork
{
  std::vector<MaterialContours> Materials; ///< by increasing label
  std::vector<std::string> Report;         ///< a sentence for everything odd that was read around
};
}

#endif
