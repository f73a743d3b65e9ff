// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralSweep.h
 * @brief Reads contour sets of all formats and runs them through the whole polyhedral method.
 *
 * The files of CONTOUR_SHARED_DATA are other people's and may be absent: then tests skip and say
 * so.
 */
#ifndef recon_Testing_PolyhedralSweep_h
#define recon_Testing_PolyhedralSweep_h

#include "Core/SetsOfData.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <filesystem>
#include <functional>

namespace recon::testing
{
inline std::string SharedPath(const std::string& name)
{
  return std::string(CONTOUR_SHARED_DATA) + "/" + name;
}

inline std::string OwnPath(const std::string& name)
{
  return std::string(CONTOUR_SOURCE_DIR) + "/Data/" + name;
}

/// A ROI may have no contours, points only, or one plane: nothing to make a surface of.
inline bool MakesASolid(const LoopSoup& soup, ContourSet& contours)
{
  Monitor monitor;
  if (soup.Chains.empty())
  {
    return false;
  }
  try
  {
    contours = BuildContourSet(soup, {}, monitor);
  }
  catch (const Error& error)
  {
    std::printf("[ NOTE     ] not one usable contour: %s\n", error.what());
    return false;
  }
  return contours.Levels.size() > 1;
}

/// Calls check(contours) for everything in the file that can be a solid; returns how many were.
inline int ForEachSolid(
  const std::string& path, const std::function<void(const ContourSet&)>& check)
{
  int solids = 0;
  for (const auto& named : ReadSoups(path))
  {
    SCOPED_TRACE(named.first);
    ContourSet contours;
    if (MakesASolid(named.second, contours))
    {
      ++solids;
      check(contours);
    }
  }
  return solids;
}

struct Case
{
  const char* File;
  int Solids; ///< how many the file has
};

inline std::ostream& operator<<(std::ostream& out, const Case& c)
{
  return out << c.File;
}

/// GoogleTest wants letters and digits.
inline std::string NameOf(const ::testing::TestParamInfo<Case>& info)
{
  std::string name = info.param.File;
  for (char& c : name)
  {
    c = std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
  }
  return name;
}

class PolyhedralSweep : public ::testing::TestWithParam<Case>
{
protected:
  void SetUp() override
  {
    this->Path = SharedPath(GetParam().File);
    if (!std::filesystem::exists(this->Path))
    {
      GTEST_SKIP() << "no " << this->Path << ": this real contour set was NOT tested";
    }
  }

  std::string Path;
};

inline void ExpectAllOptions(const ContourSet& contours)
{
  for (const bool internalPoints : { false, true })
  {
    for (const bool lift : { false, true })
    {
      SCOPED_TRACE(std::string(internalPoints ? "with" : "without") + " internal points, " +
        (lift ? "lifted" : "not lifted"));
      PolyhedralOptions options;
      options.InternalPoints = internalPoints;
      options.LiftInternalPoints = lift;
      options.Threads = 1;
      const PolyhedralSurface surface = BuildSurface(contours, options);
      ExpectKeepsPromises(surface, contours);
      options.Threads = 3;
      ExpectEqualSurfaces(surface, BuildSurface(contours, options));
    }
  }
}

}

#endif
