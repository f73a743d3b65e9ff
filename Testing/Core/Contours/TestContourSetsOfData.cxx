// SPDX-License-Identifier: GPL-3.0-or-later
// Every set of the shared test data and of Data/ keeps the guarantees of a ContourSet. Prints a
// line a set: contours in and out, levels, sentences, seconds; CONTOUR_VERBOSE=1 in the environment
// prints the sentences.
#include "ContourInvariants.h"
#include "Contours/ContourSetBuilder.h"
#include "Core/SetsOfData.h"
#include "TestPaths.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

using namespace recon;
using namespace recon::testing;

namespace
{
/// How far off its level a point may be.
double AllowedOff(const LoopSoup& soup, const ContourSet& set)
{
  Box3 box;
  for (const LoopSoup::Chain& chain : soup.Chains)
  {
    for (int p : chain.Points)
    {
      box.Add(soup.Points[At(p)]);
    }
  }
  const double flat = 1e-5 * box.Diagonal() * (1 + 1e-9);
  if (Reports(set, "taken as parallel") || Reports(set, "taken as one level"))
  {
    return std::max(flat, 0.2 * set.Spacing());
  }
  return Reports(set, "planes were found with a tolerance") ? 30 * flat : flat;
}

/// Kept points must be input points to the last bit, unless a crossing had to be computed or they
/// were put on the plane of their slice.
void CheckPointsAreGiven(const LoopSoup& soup, const ContourSet& set)
{
  const std::set<Point3> given(soup.Points.begin(), soup.Points.end());
  std::size_t computed = 0;
  for (const Point3& p : set.Points)
  {
    computed += given.count(p) == 0 ? 1 : 0;
  }
  EXPECT_TRUE(computed == 0 || Reports(set, "crossing") || Reports(set, "were put on it"))
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
    CheckContourSet(set, AllowedOff(soup, set));
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

void CheckParallel(const std::string& name, const LoopSoup& soup)
{
  Check(name, soup, true);
}

void CheckBothWays(const std::string& name, const LoopSoup& soup)
{
  Check(name, soup, false);
  Check(name + " (parallel only)", soup, true);
}

TEST(ContourSetsOfData, OwnData)
{
  ForSoups(OwnPath("Data"), ".cnt", CheckParallel);
  ForSoups(OwnPath("Data"), ".csl", CheckBothWays);
}

TEST_F(SharedData, NUAGES)
{
  ForSoups(SharedPath("cnt"), ".cnt", CheckParallel);
}

TEST_F(SharedData, CrossSections)
{
  ForSoups(SharedPath("csl"), ".csl", CheckBothWays);
}

TEST_F(SharedData, CurveNetworks)
{
  ForSoups(SharedPath("contour"), ".contour", CheckBothWays);
}

TEST_F(SharedData, StructureSets)
{
  ForSoups(SharedPath("rtstruct"), ".dcm", CheckParallel);
}

TEST_F(SharedData, Phantoms)
{
  ForSoups(SharedPath("rtstruct/phantoms"), ".dcm", CheckParallel);
}
}
