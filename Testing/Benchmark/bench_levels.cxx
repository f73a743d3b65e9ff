// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file bench_levels.cxx
 * @brief How many points the triangulations of levels need, beside those of the contours.
 *
 *   bench_levels FILE ...
 *
 * A line an ROI (or set) of parallel contours, tab-separated: file, ROI, levels, the most points of a
 * level after refinement for each of its contours, the same of levels of fifty contour points or
 * more, levels without condition 2. The bounds in LevelTriangulation.cxx come from it.
 */
#include "Contours/ContourSetBuilder.h"
#include "Core/SetsOfData.h"
#include "Polyhedral/LevelTriangulation.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

using namespace recon;

namespace
{
constexpr std::size_t ManyPoints = 50;

struct Figures
{
  double Most = 0;
  double MostOfMany = 0;
  int WithoutCondition2 = 0;
};

std::size_t PointsOf(const ContourSet& set, const Level& level)
{
  std::size_t count = 0;
  for (const int c : level.Contours)
  {
    count += set.Contours[c].Points.size();
  }
  return count;
}

Figures Measure(const ContourSet& set)
{
  Figures figures;
  for (std::size_t l = 0; l < set.Levels.size(); ++l)
  {
    const std::size_t drawn = PointsOf(set, set.Levels[l]);
    const LevelTriangulator triangulator(set, static_cast<int>(l));
    const double share =
      static_cast<double>(triangulator.Finish().Points.size()) / static_cast<double>(drawn);
    figures.Most = std::max(figures.Most, share);
    figures.MostOfMany =
      drawn < ManyPoints ? figures.MostOfMany : std::max(figures.MostOfMany, share);
    figures.WithoutCondition2 += triangulator.HasCondition2() ? 0 : 1;
  }
  return figures;
}

void Print(const std::string& file, const recon::testing::NamedSoup& named)
{
  Monitor monitor;
  const ContourSet set = BuildContourSet(named.second, {}, monitor);
  if (set.Parallel)
  {
    const Figures figures = Measure(set);
    std::printf("%s\t%s\t%zu\t%.3f\t%.3f\t%d\n", file.c_str(), named.first.c_str(),
      set.Levels.size(), figures.Most, figures.MostOfMany, figures.WithoutCondition2);
  }
}
}

int main(int argc, char** argv)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string file = std::filesystem::path(argv[i]).filename().string();
    try
    {
      for (const recon::testing::NamedSoup& named : recon::testing::ReadSoups(argv[i]))
      {
        if (!named.second.Chains.empty())
        {
          Print(file, named);
        }
      }
    }
    catch (const std::exception& error)
    {
      std::printf("%s: %s\n", file.c_str(), error.what());
    }
  }
  return 0;
}
