// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file bench_fair.cxx
 * @brief Time of the fair surface by stage, and whether it keeps what it promises.
 *
 *   bench_fair [--threads N[,N...]] [--repeat N] [--roi TEXT] [--most N] [--stages] FILE ...
 *
 * A line an ROI (or set) of parallel contours, tab-separated, under a line of the columns' names:
 * wall and processor seconds for each number of threads, the runs of all numbers by turns and each
 * figure the median of its runs; whether all numbers give the same bytes; how far the farthest contour
 * vertex is, the tolerance, and how many vertices are beyond; pairs that cross; the Euler number beside
 * that of the polyhedral surface. --roi: only ROIs of names that contain it. --most: ROIs of more
 * points are left out. --stages: a line a stage, of the last run. Reading is not counted.
 */
#include "Base/Median.h"
#include "Contours/ContourSetBuilder.h"
#include "Core/SetsOfData.h"
#include "Fair/FairSurface.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "NodeDefaults.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

using namespace recon;

namespace
{
struct Request
{
  std::vector<int> Threads{ 1, 2 };
  int Repeat = 1;
  std::string ROI;
  std::size_t Most = 0; ///< 0: any
  bool Stages = false;
  std::vector<std::string> Files;
};

struct Timed
{
  std::vector<double> Wall;
  std::vector<double> CPU;
};

bool IsSame(const TriangleMesh& a, const TriangleMesh& b)
{
  return a.Triangles == b.Triangles && a.Points.size() == b.Points.size() &&
    std::memcmp(a.Points.data(), b.Points.data(), a.Points.size() * sizeof(Point3)) == 0;
}

void Measure(const std::string& name, const ContourSet& contours, const Request& request)
{
  Monitor monitor;
  FairOptions options = recon::testing::NodeFairOptions();
  std::vector<Timed> timed(request.Threads.size());
  FairSurface first;
  FairSurface last;
  bool same = true;
  for (int run = 0; run < request.Repeat; ++run)
  {
    for (std::size_t k = 0; k < timed.size(); ++k)
    {
      options.Threads = request.Threads[k];
      const auto start = std::chrono::steady_clock::now();
      const std::clock_t startCPU = std::clock();
      last = BuildFairSurface(contours, options, monitor);
      timed[k].CPU.push_back(static_cast<double>(std::clock() - startCPU) / CLOCKS_PER_SEC);
      const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
      timed[k].Wall.push_back(wall.count());
      if (first.Mesh.Triangles.empty())
      {
        first = last;
      }
      same = same && IsSame(first.Mesh, last.Mesh);
    }
  }
  const PolyhedralSurface polyhedral =
    BuildPolyhedralSurface(contours, options.Polyhedral, monitor);
  const SelfIntersections crossings = FindSelfIntersections(last.Mesh, monitor);
  const TopologyFigures figures = CheckTopology(last.Mesh).Total;
  std::printf("%s\t%zu\t%zu", name.c_str(), contours.Points.size(), last.Mesh.Triangles.size());
  for (const Timed& t : timed)
  {
    std::printf("\t%.2f\t%.2f", Median(t.Wall), Median(t.CPU));
  }
  std::printf("\t%s\t%.4g\t%.4g\t%zu\t%lld\t%s\t%lld\t%lld\t%zu\t%zu\n",
    same ? "same" : "DIFFERENT", last.Farthest, last.Tolerance, last.Beyond,
    static_cast<long long>(crossings.Crossing + crossings.Overlapping),
    figures.Closed && figures.Manifold() && figures.Outward ? "sound" : "UNSOUND",
    static_cast<long long>(figures.Euler),
    static_cast<long long>(CheckTopology(polyhedral.Mesh).Total.Euler), last.Thin, last.HeldBack);
  for (const auto& [stage, seconds] : last.StageSeconds)
  {
    if (request.Stages)
    {
      std::printf("  %s\t%.3f\n", stage.c_str(), seconds);
    }
  }
  std::fflush(stdout);
}

void MeasureFile(const std::string& path, const Request& request)
{
  for (const recon::testing::NamedSoup& named : recon::testing::ReadSoups(path))
  {
    if (named.first.find(request.ROI) == std::string::npos || named.second.Chains.empty() ||
      (request.Most > 0 && named.second.Points.size() > request.Most))
    {
      continue;
    }
    const std::string name = std::filesystem::path(path).filename().string() + "\t" + named.first;
    try
    {
      Monitor monitor;
      ContourSetOptions reading;
      reading.Parallel = true;
      Measure(name, BuildContourSet(named.second, reading, monitor), request);
    }
    catch (const Error& error)
    {
      std::printf("%s\t%s\n", name.c_str(), error.what());
    }
  }
}

std::vector<int> NumbersOf(const char* text)
{
  std::vector<int> numbers;
  for (const char* at = text; at != nullptr; at = std::strchr(at, ','))
  {
    at += *at == ',' ? 1 : 0;
    numbers.push_back(std::atoi(at));
  }
  return numbers;
}

Request Parse(int argc, char** argv)
{
  Request request;
  for (int i = 1; i < argc; ++i)
  {
    const std::string option = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : "";
    if (option == "--stages")
    {
      request.Stages = true;
      continue;
    }
    if (option.compare(0, 2, "--") != 0)
    {
      request.Files.push_back(option);
      continue;
    }
    ++i;
    if (option == "--threads")
    {
      request.Threads = NumbersOf(value);
    }
    else if (option == "--repeat")
    {
      request.Repeat = std::max(1, std::atoi(value));
    }
    else if (option == "--roi")
    {
      request.ROI = value;
    }
    else if (option == "--most")
    {
      request.Most = std::strtoul(value, nullptr, 10);
    }
    else
    {
      throw Error("bench_fair does not know " + option + ".");
    }
  }
  return request;
}

void PrintHead(const Request& request)
{
  std::printf("file\tROI\tpoints\ttriangles");
  for (const int threads : request.Threads)
  {
    std::printf("\twall s, %d threads\tCPU s", threads);
  }
  std::printf(
    "\tbytes\tfarthest\ttolerance\tbeyond\tcrossing\tmesh\tEuler\tpolyhedral\tthin\theld\n");
}
}

int main(int argc, char** argv)
{
  try
  {
    const Request request = Parse(argc, argv);
    PrintHead(request);
    for (const std::string& file : request.Files)
    {
      MeasureFile(file, request);
    }
    return 0;
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "bench_fair: %s\n", error.what());
    return 1;
  }
}
