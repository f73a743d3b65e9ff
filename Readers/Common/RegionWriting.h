// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RegionWriting.h
 * @brief What writers share that give each region of a collection a file of its own.
 */
#ifndef recon_RegionWriting_h
#define recon_RegionWriting_h

#include "Base/Monitor.h"
#include "Common/RegionFiles.h"
#include "SurfaceBlocks.h"

#include "vtkPolyData.h"

#include <cstddef>
#include <string>
#include <vector>

namespace recon
{
/**
 * Blocks with a surface; those without triangles are regions of which nothing was made.
 *
 * @throws Error where there is none.
 */
inline std::vector<NamedPolyData> FilledRegions(vtkDataObject* collection)
{
  std::vector<NamedPolyData> filled;
  for (const NamedPolyData& region : ListPolyData(collection))
  {
    if (region.Data->GetNumberOfPolys() > 0)
    {
      filled.push_back(region);
    }
  }
  if (filled.empty())
  {
    throw Error("No block of the collection has a surface to write.");
  }
  return filled;
}

/**
 * Calls write(r, file) for region r of each, with the name that RegionFileNames gives. What is wrong
 * with one region costs that one only.
 *
 * @throws Error at the end, with the names and sentences of those that failed.
 */
template <typename WriteFunction>
void WriteRegionFiles(
  const std::vector<NamedPolyData>& regions, const std::string& path, WriteFunction&& write)
{
  std::vector<std::string> names;
  for (const NamedPolyData& region : regions)
  {
    names.push_back(region.Name);
  }
  const std::vector<std::string> files = RegionFileNames(path, names);
  std::string failed;
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    try
    {
      write(r, files[r]);
    }
    catch (const Error& error)
    {
      failed += (failed.empty() ? "" : " ") + ("\"" + regions[r].Name + "\": " + error.what());
    }
  }
  if (!failed.empty())
  {
    throw Error(failed);
  }
}
}

#endif
