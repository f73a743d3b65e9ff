// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContourFile.h
 * @brief What the contour readers hand on: loops as they stand in the file, and what was odd.
 */
#ifndef recon_ContourFile_h
#define recon_ContourFile_h

#include "Contours/ContourSet.h"

#include <string>
#include <vector>

namespace recon
{
struct ContourFile
{
  LoopSoup Soup;
  std::vector<std::string> Report; ///< a sentence for everything odd that was read around
};
}

#endif
