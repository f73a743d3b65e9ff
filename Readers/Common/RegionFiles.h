// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RegionFiles.h
 * @brief Names of files where each region of a collection gets one of its own.
 */
#ifndef recon_RegionFiles_h
#define recon_RegionFiles_h

#include "Base/Monitor.h"

#include <cstddef>
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

/**
 * Calls write(r, file) for region r of each, with the name that RegionFileNames gives. What is wrong
 * with one region costs that one only.
 *
 * @throws Error at the end, with the names and sentences of those that failed.
 */
template <typename WriteFunction>
void WriteRegionFiles(
  const std::vector<std::string>& regions, const std::string& path, WriteFunction&& write)
{
  const std::vector<std::string> files = RegionFileNames(path, regions);
  std::string failed;
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    try
    {
      write(r, files[r]);
    }
    catch (const Error& error)
    {
      failed += (failed.empty() ? "" : " ") + ("\"" + regions[r] + "\": " + error.what());
    }
  }
  if (!failed.empty())
  {
    throw Error(failed);
  }
}
}

#endif
