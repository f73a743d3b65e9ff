// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SetsOfData.h
 * @brief Every set of contours of a folder, through the readers' parsers: for tests over all data.
 */
#ifndef recon_SetsOfData_h
#define recon_SetsOfData_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "CurveNetwork/CurveNetworkParser.h"
#include "DICOM/StructureSetFile.h"
#include "NUAGES/NUAGESParser.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace recon::testing
{
inline std::vector<std::filesystem::path> FilesIn(
  const std::filesystem::path& folder, const std::string& extension)
{
  std::vector<std::filesystem::path> files;
  if (std::filesystem::is_directory(folder))
  {
    for (const std::filesystem::directory_entry& entry :
      std::filesystem::directory_iterator(folder))
    {
      if (entry.path().extension() == extension)
      {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

using NamedSoup = std::pair<std::string, LoopSoup>;

/// The ROIs of a structure set, the slices, or the materials of a network.
inline std::vector<NamedSoup> ReadSoups(const std::string& path)
{
  Monitor monitor;
  std::vector<NamedSoup> soups;
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".cnt")
  {
    soups.emplace_back("all", ReadNUAGES(path, monitor).Soup);
  }
  else if (ending == ".csl" || ending == ".contour")
  {
    for (const MaterialContours& material : ReadCurveNetwork(path, monitor).Materials)
    {
      soups.emplace_back("material " + std::to_string(material.Label), material.Soup);
    }
  }
  else
  {
    StructureSetFile file(path);
    for (std::size_t i = 0; i < file.GetROIs().size(); ++i)
    {
      soups.emplace_back(
        file.GetROIs()[i].Name, file.ReadContours(static_cast<int>(i), monitor).File.Soup);
    }
  }
  return soups;
}

/// visit(name, soup) for everything in the folder's files of that extension that has contours.
template <typename Visit>
void ForSoups(const std::filesystem::path& folder, const std::string& extension, const Visit& visit)
{
  for (const std::filesystem::path& file : FilesIn(folder, extension))
  {
    for (const NamedSoup& named : ReadSoups(file.string()))
    {
      if (!named.second.Chains.empty())
      {
        visit(file.filename().string() + " " + named.first, named.second);
      }
    }
  }
}

/// Skips, and says so, where the shared data is not there.
class SharedData : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!std::filesystem::is_directory(SharedPath()))
    {
      GTEST_SKIP() << "no shared test data at " << SharedPath()
                   << "; set the CMake variable CONTOUR_SHARED_DATA";
    }
  }
};
}

#endif
