// SPDX-License-Identifier: GPL-3.0-or-later
// Every set of the shared test data and of Data/ keeps the guarantees of a ContourSet. Prints a
// line a set: contours in and out, levels, sentences, seconds; CONTOUR_VERBOSE=1 in the environment
// prints the sentences.
#include "ContourInvariants.h"
#include "Contours/ContourSetBuilder.h"
#include "CurveNetworkParser.h"
#include "NUAGESParser.h"
#include "StructureSetFile.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

using namespace recon;
using namespace recon::testing;
namespace fs = std::filesystem;

namespace
{
double DiagonalOf(const LoopSoup& soup)
{
  Point3 low{ 1e300, 1e300, 1e300 };
  Point3 high{ -1e300, -1e300, -1e300 };
  for (const LoopSoup::Chain& chain : soup.Chains)
  {
    for (int p : chain.Points)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        low[k] = std::min(low[k], soup.Points[At(p)][k]);
        high[k] = std::max(high[k], soup.Points[At(p)][k]);
      }
    }
  }
  return Norm(high - low);
}

/// Kept points must be input points to the last bit, unless a crossing had to be computed.
void CheckPointsAreGiven(const LoopSoup& soup, const ContourSet& set)
{
  const std::set<Point3> given(soup.Points.begin(), soup.Points.end());
  std::size_t computed = 0;
  for (const Point3& p : set.Points)
  {
    computed += given.count(p) == 0 ? 1 : 0;
  }
  EXPECT_TRUE(computed == 0 || Reports(set, "crossing"))
    << computed << " points that were not given";
}

void Check(const std::string& name, const LoopSoup& soup, bool parallel)
{
  SCOPED_TRACE(name);
  ContourSetOptions options;
  options.Parallel = parallel;
  Monitor monitor;
  const auto start = std::chrono::steady_clock::now();
  try
  {
    const ContourSet set = BuildContourSet(soup, options, monitor);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%-58s %5zu in %5zu out %4zu levels%s %7zu points %3zu sentences %.3f s\n",
      name.c_str(), soup.Chains.size(), set.Contours.size(), set.Levels.size(),
      set.Parallel ? " (parallel)" : "           ", set.Points.size(), set.Report.size(),
      seconds.count());
    if (std::getenv("CONTOUR_VERBOSE"))
    {
      for (const std::string& line : set.Report)
      {
        std::printf("    %s\n", line.c_str());
      }
    }
    const double tolerance = options.PlaneTolerance * DiagonalOf(soup) * (1 + 1e-9);
    CheckContourSet(
      set, Reports(set, "planes were found with a tolerance") ? 30 * tolerance : tolerance);
    CheckPointsAreGiven(soup, set);
    EXPECT_TRUE(set.Parallel || !parallel);
  }
  catch (const Error& error)
  {
    std::printf("%-58s %5zu in: %s\n", name.c_str(), soup.Chains.size(), error.what());
    // Only sets in which nothing encloses an area may fail.
    for (const LoopSoup::Chain& chain : soup.Chains)
    {
      EXPECT_TRUE(!chain.Closed || chain.Points.size() < 3) << error.what();
    }
  }
}

std::vector<fs::path> FilesIn(const fs::path& folder, const std::string& extension)
{
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
  {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
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

void CheckNUAGES(const fs::path& folder)
{
  Monitor monitor;
  for (const fs::path& file : FilesIn(folder, ".cnt"))
  {
    Check(file.filename().string(), ReadNUAGES(file.string(), monitor).Soup, true);
  }
}

void CheckCurveNetworks(const fs::path& folder, const std::string& extension)
{
  Monitor monitor;
  for (const fs::path& file : FilesIn(folder, extension))
  {
    for (const MaterialContours& material : ReadCurveNetwork(file.string(), monitor).Materials)
    {
      const std::string name = file.filename().string() + " " + std::to_string(material.Label);
      Check(name, material.Soup, false);
      Check(name + " (parallel only)", material.Soup, true);
    }
  }
}

void CheckStructureSets(const fs::path& folder)
{
  Monitor monitor;
  for (const fs::path& path : FilesIn(folder, ".dcm"))
  {
    StructureSetFile file(path.string());
    for (std::size_t r = 0; r < file.GetROIs().size(); ++r)
    {
      const StructureSetContours roi = file.ReadContours(static_cast<int>(r), monitor);
      if (!roi.File.Soup.Chains.empty())
      {
        Check(path.filename().string() + " " + file.GetROIs()[r].Name, roi.File.Soup, true);
      }
    }
  }
}

TEST(ContourSetsOfData, OwnData)
{
  CheckNUAGES(CONTOUR_SOURCE_DIR "/Data");
  CheckCurveNetworks(CONTOUR_SOURCE_DIR "/Data", ".csl");
}

class SharedData : public ::testing::Test
{
protected:
  void SetUp() override
  {
    if (!fs::is_directory(CONTOUR_SHARED_DATA))
    {
      GTEST_SKIP() << "no shared test data at " << CONTOUR_SHARED_DATA
                   << "; set the CMake variable CONTOUR_SHARED_DATA";
    }
  }
};

TEST_F(SharedData, NUAGES)
{
  CheckNUAGES(CONTOUR_SHARED_DATA "/cnt");
}

TEST_F(SharedData, CrossSections)
{
  CheckCurveNetworks(CONTOUR_SHARED_DATA "/csl", ".csl");
}

TEST_F(SharedData, CurveNetworks)
{
  CheckCurveNetworks(CONTOUR_SHARED_DATA "/contour", ".contour");
}

TEST_F(SharedData, StructureSets)
{
  CheckStructureSets(CONTOUR_SHARED_DATA "/rtstruct");
}

TEST_F(SharedData, Phantoms)
{
  CheckStructureSets(CONTOUR_SHARED_DATA "/rtstruct/phantoms");
}
}
