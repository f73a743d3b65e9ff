// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RegionFiles.h
 * @brief Names of files where each region of a collection gets one of its own.
 */
#ifndef recon_RegionFiles_h
#define recon_RegionFiles_h

#include <string>
#include <vector>

namespace recon
{
/**
 * The path itself for one region; for several the region's name before the extension, "heart.brep"
 * becoming "heart-Left_lung.brep". Letters and digits of any alphabet stay, all else becomes one _;
 * where two names are then the same, or differ in case only, the later one gets its number.
 */
std::vector<std::string> RegionFileNames(
  const std::string& path, const std::vector<std::string>& regions);
}

#endif
