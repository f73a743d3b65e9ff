// SPDX-License-Identifier: GPL-3.0-or-later
// Files of others whose levels once came out wrong, never, or ended the program.
#include "Contours/ContourSetBuilder.h"

#include "Core/Contours/ContourInvariants.h"
#include "Core/SetsOfData.h"
#include "TestPaths.h"
#include <cmath>
#include <random>

using namespace recon;
using namespace recon::testing;

namespace
{
class PlaneFaults : public SharedData
{
protected:
  static ContourSet Build(const std::string& file)
  {
    const std::vector<NamedSoup> soups = ReadSoups(SharedPath("faults/" + file));
    EXPECT_EQ(soups.size(), 1u);
    Monitor monitor;
    return BuildContourSet(soups.at(0).second, {}, monitor);
  }

  static void ExpectTwelveCornersOnEveryLevel(const ContourSet& set, std::size_t levels)
  {
    ASSERT_EQ(set.Levels.size(), levels);
    ASSERT_EQ(set.Contours.size(), levels);
    for (std::size_t l = 0; l < levels; ++l)
    {
      CheckContourSet(set, static_cast<int>(l));
      EXPECT_NEAR(set.Contours[l].SignedArea, 300, 1e-4);
    }
    ASSERT_EQ(set.Report.size(), 1u);
    EXPECT_TRUE(Reports(set, "within rounding"));
    EXPECT_TRUE(Reports(set, "left out"));
  }
};

TEST_F(PlaneFaults, AnOutlineStoredTwiceWithOtherDecimals)
{
  ExpectTwelveCornersOnEveryLevel(Build("rt/twin_12_points.dcm"), 3);
  ExpectTwelveCornersOnEveryLevel(Build("rt/twin_11_slices.dcm"), 11);
}

TEST_F(PlaneFaults, TheEvenOddRuleEnds)
{
  const ContourSet set = Build("other/evenodd_hang.cnt");
  CheckContourSet(set, 0);
  // Two triangles of 3.7e9 x 1e9 / 2, less their overlap twice; the small one is lost beside them.
  EXPECT_NEAR(SolidArea(set) / 3.6019e18, 1, 1e-4);
  EXPECT_TRUE(Reports(set, "touch or cross one another"));
}

TEST_F(PlaneFaults, SliversBelowTheToleranceAreNamed)
{
  for (const char* file : { "other/sliver_crash.cnt", "other/sliver_hang.cnt" })
  {
    try
    {
      Build(file);
      ADD_FAILURE() << file;
    }
    catch (const Error& error)
    {
      const std::string text = error.what();
      EXPECT_NE(text.find("is narrower than the snap tolerance of 1e-07"), std::string::npos)
        << text;
    }
  }
}

/// A structure set whose outlines are all there again, with other decimals and points left out,
/// started elsewhere, some the other way round.
LoopSoup Doubled(const LoopSoup& soup, unsigned seed)
{
  std::mt19937 random(seed);
  const double power = std::pow(10.0, random() % 5);
  const bool cut = random() % 2 == 0;
  const unsigned dropped = random() % 3 == 0 ? 10 : 0; // percent
  LoopSoup doubled = soup;
  for (const LoopSoup::Chain& chain : soup.Chains)
  {
    LoopSoup::Chain again = chain;
    again.Points.clear();
    again.Source = static_cast<int>(doubled.Chains.size());
    for (int p : chain.Points)
    {
      if (random() % 100 < dropped)
      {
        continue;
      }
      Point3 x = soup.Points[At(p)];
      for (std::size_t k = 0; k < 2; ++k)
      {
        x[k] = (cut ? std::trunc(x[k] * power) : std::round(x[k] * power)) / power;
      }
      again.Points.push_back(static_cast<int>(doubled.Points.size()));
      doubled.Points.push_back(x);
    }
    std::rotate(
      again.Points.begin(), again.Points.begin() + again.Points.size() / 3, again.Points.end());
    if (random() % 2 == 0)
    {
      std::reverse(again.Points.begin(), again.Points.end());
    }
    doubled.Chains.push_back(again);
  }
  return doubled;
}

/// How many changes the sentences tell of; a sentence a kind, with its number.
int ChangesIn(const std::vector<std::string>& report)
{
  int changes = 0;
  for (const std::string& line : report)
  {
    changes += line.find("contours, the first of ") != std::string::npos ? std::stoi(line) : 1;
  }
  return changes;
}

TEST_F(PlaneFaults, DoubledOutlinesOfRealSetsAreOneEach)
{
  int tried = 0;
  for (const char* file : { "rtstruct/dicompyler_rtss.dcm", "rtstruct/dicomexport_rs.dcm" })
  {
    for (const auto& [name, soup] : ReadSoups(SharedPath(file)))
    {
      Monitor monitor;
      const ContourSet set =
        soup.Chains.empty() ? ContourSet() : BuildContourSet(soup, {}, monitor);
      // Markers of a pixel or two have no shape left without decimals.
      if (set.Contours.empty() || SolidArea(set) < 400 * static_cast<double>(set.Contours.size()))
      {
        continue;
      }
      for (unsigned seed = 1; seed <= 2; ++seed)
      {
        const ContourSet again = BuildContourSet(Doubled(soup, seed), {}, monitor);
        EXPECT_NEAR(SolidArea(again) / SolidArea(set), 1, 0.005)
          << file << " " << name << " " << seed;
        EXPECT_GE(
          ChangesIn(again.Report), ChangesIn(set.Report) + static_cast<int>(soup.Chains.size()))
          << name;
        ++tried;
      }
    }
  }
  EXPECT_GT(tried, 15);
}
}
