// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file bench_ism.cxx
 * @brief One fit of the implicit method, and what is made of it, in a process of its own.
 *
 * Usage: bench_ism FILE [--solver automatic|lu|direct|iterative] [--tolerance T] [--threads N]
 *                       [--evaluate N] [--surface CELLSIZE]
 *
 * FILE holds doubles, four a constraint: x, y, z, value. Prints one JSON object: seconds of wall
 * and of processor time, the misfit, the process's largest memory. A process of its own, because
 * memory that was once taken cannot be told from memory that is needed.
 */
#include "Implicit/FastMultipole/DirectSums.h"
#include "Implicit/FastMultipole/FunctionEvaluator.h"
#include "Implicit/Solver/FitImplicitFunction.h"
#include "Implicit/ZeroSet/Polygonizer.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <map>
#include <string>

using namespace recon;

namespace
{
struct Options
{
  std::string File;
  FunctionOptions Function;
  int Evaluate = 0;
  double CellSize = 0;
};

struct Times
{
  double Wall = 0;
  double Cpu = 0;
};

Times Now()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t)
  { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  const auto wall = std::chrono::steady_clock::now().time_since_epoch();
  return { std::chrono::duration<double>(wall).count(),
    seconds(usage.ru_utime) + seconds(usage.ru_stime) };
}

Times Since(const Times& start)
{
  const Times now = Now();
  return { now.Wall - start.Wall, now.Cpu - start.Cpu };
}

/// Of this program alone: getrusage's figure is also that of whoever started it.
double PeakMegabytes()
{
  std::ifstream file("/proc/self/status");
  std::string word;
  double kilobytes = 0;
  while (file >> word && word != "VmHWM:")
  {
  }
  file >> kilobytes;
  return kilobytes / 1024;
}

Options Parse(int argc, char** argv)
{
  const std::map<std::string, FunctionOptions::SolverType> solvers{
    { "automatic", FunctionOptions::Automatic }, { "lu", FunctionOptions::LU },
    { "direct", FunctionOptions::Direct }, { "iterative", FunctionOptions::Iterative }
  };
  Options options;
  options.File = argc > 1 ? argv[1] : "";
  for (int i = 2; i + 1 < argc; i += 2)
  {
    const std::string name = argv[i];
    const char* value = argv[i + 1];
    if (name == "--solver")
    {
      options.Function.Solver = solvers.at(value);
    }
    else if (name == "--tolerance")
    {
      options.Function.Tolerance = std::atof(value);
    }
    else if (name == "--threads")
    {
      options.Function.Threads = std::atoi(value);
    }
    else if (name == "--evaluate")
    {
      options.Evaluate = std::atoi(value);
    }
    else if (name == "--surface")
    {
      options.CellSize = std::atof(value);
    }
    else
    {
      throw Error("There is no option " + name + ".");
    }
  }
  return options;
}

void Read(const std::string& name, std::vector<Point3>& points, std::vector<double>& values)
{
  std::ifstream file(name, std::ios::binary);
  std::array<double, 4> row{};
  while (file.read(reinterpret_cast<char*>(row.data()), sizeof row))
  {
    points.push_back({ row[0], row[1], row[2] });
    values.push_back(row[3]);
  }
  if (points.empty())
  {
    throw Error("There are no constraints in " + name + ".");
  }
}

/// Points spread evenly over the bounding box: Halton's sequence.
std::vector<Point3> Spread(const std::vector<Point3>& in, int count)
{
  Point3 low = in.front();
  Point3 high = low;
  for (const Point3& p : in)
  {
    for (int a = 0; a < 3; ++a)
    {
      low[a] = std::min(low[a], p[a]);
      high[a] = std::max(high[a], p[a]);
    }
  }
  const std::array<int, 3> bases{ 2, 3, 5 };
  std::vector<Point3> points(count);
  for (int i = 0; i < count; ++i)
  {
    for (int a = 0; a < 3; ++a)
    {
      double part = 1;
      double place = 0;
      for (int k = i + 1; k > 0; k /= bases[a])
      {
        part /= bases[a];
        place += part * (k % bases[a]);
      }
      points[i][a] = low[a] + (high[a] - low[a]) * place;
    }
  }
  return points;
}

void BenchEvaluation(const ImplicitFunction& function, int count, int threads)
{
  constexpr int Sample = 10000;
  const std::vector<Point3> points = Spread(function.Centres, count);
  const Times start = Now();
  Monitor monitor;
  const FunctionEvaluator evaluator(function, threads);
  const std::vector<double> values = evaluator.Values(points, monitor);
  const Times took = Since(start);
  double error = 0;
  const int step = std::max(1, count / Sample);
  for (int i = 0; i < count; i += step)
  {
    double exact = 0;
    SumKernels(function.Phi, function.Centres, function.Weights, &points[i], 1, &exact);
    const Vector3 x = points[i] - function.Origin;
    exact += function.Polynomial[0] + function.Polynomial[1] * x[0] +
      function.Polynomial[2] * x[1] + function.Polynomial[3] * x[2];
    error = std::max(error, std::abs(values[i] - exact));
  }
  std::printf(", \"evaluations\": %d, \"evaluate_wall\": %.4g, \"evaluate_cpu\": %.4g, "
              "\"evaluate_error\": %.3g",
    count, took.Wall, took.Cpu, error);
}

void BenchSurface(const ImplicitFunction& function, double cellSize, int threads)
{
  PolygonizerOptions options;
  options.CellSize = cellSize;
  options.Threads = threads;
  options.CleanUp = false; // the rival has none
  Monitor monitor;
  const Times start = Now();
  const ImplicitMesh mesh = Polygonize(function, SeedsOf(function), options, monitor);
  const Times took = Since(start);
  std::printf(", \"triangles\": %zu, \"surface_wall\": %.4g, \"surface_cpu\": %.4g",
    mesh.Mesh.Triangles.size(), took.Wall, took.Cpu);
}
}

int main(int argc, char** argv)
{
  try
  {
    const Options options = Parse(argc, argv);
    std::vector<Point3> points;
    std::vector<double> values;
    Read(options.File, points, values);
    Monitor monitor;
    const Times start = Now();
    const ImplicitFunction function =
      FitImplicitFunction(points, values, options.Function, monitor);
    const Times took = Since(start);
    std::printf("{\"constraints\": %zu, \"fit_wall\": %.4g, \"fit_cpu\": %.4g, \"misfit\": %.3g, "
                "\"iterations\": %d, \"megabytes\": %.0f",
      function.Centres.size(), took.Wall, took.Cpu, function.Residual, function.Iterations,
      PeakMegabytes());
    if (options.Evaluate > 0)
    {
      BenchEvaluation(function, options.Evaluate, options.Function.Threads);
    }
    if (options.CellSize > 0)
    {
      BenchSurface(function, options.CellSize, options.Function.Threads);
    }
    std::printf("}\n");
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
