// SPDX-License-Identifier: GPL-3.0-or-later
// What Contour Mapping costs by the number of regions a level, and by the number of points.
//
// usage: bench_mapping [--check]
//
// Prints processor seconds a slab (one thread, median of five). With --check it fails where eight
// times the regions, from 250 to 2000, cost more than twice what n log n grants.
#include "Contours/ContourMapping.h"
#include "Contours/ContourSetBuilder.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <exception>
#include <vector>

using namespace recon;

namespace
{
constexpr double FullTurn = 2 * 3.14159265358979323846;

/// A grid of regular polygons, every second one with a hole.
void AddLevel(LoopSoup& soup, int regions, int corners, double shift, double z)
{
  const int side = static_cast<int>(std::ceil(std::sqrt(regions)));
  for (int r = 0; r < regions; ++r)
  {
    for (const double radius : { 1.0, 0.5 })
    {
      if (radius < 1 && r % 2 == 1)
      {
        continue;
      }
      LoopSoup::Chain chain;
      chain.Closed = true;
      chain.Source = static_cast<int>(soup.Chains.size());
      for (int i = 0; i < corners; ++i)
      {
        const double angle = FullTurn * (i + 0.3 * r) / corners;
        chain.Points.push_back(static_cast<int>(soup.Points.size()));
        soup.Points.push_back({ 2.5 * (r % side) + shift + radius * std::cos(angle),
          2.5 * (r / side) + 0.7 * shift + radius * std::sin(angle), z });
      }
      soup.Chains.push_back(chain);
    }
  }
}

/// Processor seconds of one slab between two such levels.
double Measure(int regions, int corners)
{
  Monitor monitor;
  LoopSoup soup;
  AddLevel(soup, regions, corners, 0, 0);
  AddLevel(soup, regions, corners, 0.6, 1);
  const ContourSet contours = BuildContourSet(soup, {}, monitor);
  ContourMappingOptions options;
  options.Threads = 1;
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i)
  {
    const std::clock_t start = std::clock();
    const ContourMapping mapping = BuildContourMapping(contours, options, monitor);
    seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    if (mapping.Joins.empty())
    {
      throw Error("Nothing was joined.");
    }
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[2];
}
}

int main(int argc, char** argv)
{
  try
  {
    const bool check = argc == 2 && std::strcmp(argv[1], "--check") == 0;
    std::printf("regions a level (16 corners) | CPU s a slab | us / (n log2 n)\n");
    double first = 0, last = 0;
    for (const int regions : { 125, 250, 500, 1000, 2000 })
    {
      const double seconds = Measure(regions, 16);
      last = 1e6 * seconds / (regions * std::log2(regions));
      first = regions == 250 ? last : first;
      std::printf("%28d | %12.3f | %8.2f\n", regions, seconds, last);
    }
    std::printf("500 regions of corners | points a level | CPU s a slab\n");
    for (const int corners : { 16, 64, check ? 64 : 133 })
    {
      std::printf("%22d | %14d | %8.3f\n", corners, 750 * corners, Measure(500, corners));
    }
    return check && last > 2 * first ? 1 : 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "bench_mapping: %s\n", error.what());
    return 1;
  }
}
