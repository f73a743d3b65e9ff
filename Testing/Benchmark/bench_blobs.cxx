// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file bench_blobs.cxx
 * @brief Time and memory of the polyhedral method for a stack of smooth, densely sampled outlines.
 *
 * Usage: bench_blobs POINTS LEVELS [--threads N]
 *
 * One outline of POINTS points a level, that turns and swells from level to level; the options are
 * those that users get. Prints one line of JSON. Making and cleaning the contours is not counted in
 * the seconds; memory is the peak of the whole process, and what it was before the method began.
 */
#include "Contours/ContourSetBuilder.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <sys/resource.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>

using namespace recon;

namespace
{
ContourSet MakeStack(int points, int levels)
{
  constexpr double fullTurn = 2 * 3.14159265358979323846;
  LoopSoup soup;
  for (int l = 0; l < levels; ++l)
  {
    LoopSoup::Chain chain;
    chain.Closed = true;
    for (int i = 0; i < points; ++i)
    {
      const double t = fullTurn * i / points;
      const double r = 1 + 0.2 * std::sin(3 * t + 0.25 * l) + 0.1 * std::sin(5 * t + 0.5 * l) +
        0.03 * std::sin(0.7 * l);
      chain.Points.push_back(static_cast<int>(soup.Points.size()));
      soup.Points.push_back({ r * std::cos(t), r * std::sin(t), 0.2 * l });
    }
    soup.Chains.push_back(chain);
  }
  Monitor monitor;
  return BuildContourSet(soup, {}, monitor);
}

double PeakMegabytes()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

int Run(int argc, char** argv)
{
  const int points = argc > 1 ? std::atoi(argv[1]) : 0;
  const int levels = argc > 2 ? std::atoi(argv[2]) : 0;
  const bool threads = argc == 5 && std::strcmp(argv[3], "--threads") == 0;
  if (points < 3 || levels < 2 || (argc != 3 && !threads))
  {
    std::fprintf(stderr, "usage: bench_blobs POINTS LEVELS [--threads N]\n");
    return 2;
  }
  const ContourSet contours = MakeStack(points, levels);
  const double before = PeakMegabytes();
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  options.EndCaps = PolyhedralOptions::Tapered;
  options.Threads = threads ? std::atoi(argv[4]) : 1;
  Monitor monitor;
  const std::clock_t start = std::clock();
  const PolyhedralSurface surface = BuildPolyhedralSurface(contours, options, monitor);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf(
    "{\"points\": %d, \"levels\": %d, \"triangles\": %zu, \"cpu\": %.3f, \"before\": %.1f, "
    "\"peak\": %.1f, \"stages\": {",
    points, levels, surface.Mesh.Triangles.size(), seconds, before, PeakMegabytes());
  const char* separator = "";
  for (const auto& [stage, wall] : surface.StageSeconds)
  {
    std::printf("%s\"%s\": %.3f", separator, stage.c_str(), wall);
    separator = ", ";
  }
  std::printf("}}\n");
  return 0;
}
}

int main(int argc, char** argv)
{
  try
  {
    return Run(argc, argv);
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "bench_blobs: %s\n", error.what());
    return 1;
  }
}
