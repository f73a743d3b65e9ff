// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file bench_psm.cxx
 * @brief Time of the polyhedral method by stage, beside CGAL's 3D Delaunay triangulation alone.
 *
 * Usage: bench_psm [--json FILE] [--repeat N] [--only TEXT]
 *
 * All on one thread. Each repetition builds the surface and then Delaunay_triangulation_3 of the
 * points of every slab (those of its two levels, internal points included), so that both meet the
 * machine in the same state; the figures are those of the median run by total time, and the median
 * of CGAL's. The ratio is of processor time, which other programs disturb less than wall time.
 * Reading and cleaning the contours is not counted. Build it in Release.
 */
#include "Contours/ContourSetBuilder.h"
#include "CurveNetwork/CSLParser.h"
#include "DICOM/StructureSetFile.h"
#include "NUAGES/NUAGESParser.h"
#include "Polyhedral/PolyhedralStages.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "TestPaths.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace recon;

namespace
{
struct Case
{
  std::string Name;
  std::string File;
  std::string ROI; ///< of a structure set
};

const std::vector<Case> Cases{
  { "head", recon::testing::OwnPath("Data/head.cnt"), "" },
  { "brain", recon::testing::OwnPath("Data/brain.cnt"), "" },
  { "Lt Lung", recon::testing::SharedPath("rtstruct/dicompyler_rtss.dcm"), "Lt Lung" },
  { "BODY", recon::testing::SharedPath("rtstruct/dicompyler_rtss.dcm"), "BODY" },
  { "amygdala", recon::testing::SharedPath("cnt/amygdala_label3.cnt"), "" },
  { "sainthelens", recon::testing::SharedPath("cnt/sainthelens_100m.cnt"), "" },
  { "rose", recon::testing::SharedPath("csl/rose.csl"), "" },
};

struct Figures
{
  std::string Name;
  std::size_t Contours = 0, Levels = 0, ContourPoints = 0, Tetrahedra = 0, Triangles = 0;
  std::vector<std::pair<std::string, double>> Stages;
  double Total = 0; ///< wall
  double CGAL = 0;
  double TotalCPU = 0;
  double CGALCPU = 0;
  double MappingCPU = 0;
};

/// Wall and processor seconds since it was made.
class Watch
{
public:
  double Wall() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
  }
  double CPU() const { return static_cast<double>(std::clock() - this->StartCPU) / CLOCKS_PER_SEC; }

private:
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
  std::clock_t StartCPU = std::clock();
};

double MedianOf(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

LoopSoup ReadCase(const Case& c)
{
  Monitor monitor;
  const std::string ending = std::filesystem::path(c.File).extension().string();
  if (ending == ".cnt")
  {
    return ReadNUAGES(c.File, monitor).Soup;
  }
  if (ending == ".csl")
  {
    return ReadCSL(c.File, monitor).Materials.at(0).Soup;
  }
  StructureSetFile file(c.File);
  for (std::size_t i = 0; i < file.GetROIs().size(); ++i)
  {
    if (file.GetROIs()[i].Name == c.ROI)
    {
      return file.ReadContours(static_cast<int>(i), monitor).File.Soup;
    }
  }
  throw Error(c.File + " has no ROI " + c.ROI + ".");
}

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// The points of every slab.
std::vector<std::vector<Kernel::Point_3>> SlabPoints(const PolyhedralStages& stages)
{
  std::vector<std::vector<Kernel::Point_3>> slabs(stages.Slabs.size());
  for (std::size_t i = 0; i < slabs.size(); ++i)
  {
    for (std::size_t l : { i, i + 1 })
    {
      for (const Point2& p : stages.Levels[l].Triangulation.Points)
      {
        slabs[i].emplace_back(p[0], p[1], stages.Levels[l].Offset);
      }
    }
  }
  return slabs;
}

void TriangulateWithCGAL(const std::vector<std::vector<Kernel::Point_3>>& slabs)
{
  std::size_t cells = 0;
  for (const auto& points : slabs)
  {
    const CGAL::Delaunay_triangulation_3<Kernel> delaunay(points.begin(), points.end());
    cells += delaunay.number_of_cells();
  }
  if (cells == 0)
  {
    throw Error("CGAL made no tetrahedron.");
  }
}

Figures Measure(const Case& c, int repeat)
{
  Monitor monitor;
  const ContourSet contours = BuildContourSet(ReadCase(c), {}, monitor);
  PolyhedralOptions options;
  options.Threads = 1;
  // CGAL does not map contours either; what that costs is measured by itself.
  options.Mapping = PolyhedralOptions::Proximity;
  Figures figures;
  figures.Name = c.Name;
  figures.Contours = contours.Contours.size();
  figures.Levels = contours.Levels.size();
  figures.ContourPoints = contours.Points.size();
  std::vector<std::vector<Kernel::Point_3>> slabs;
  {
    const PolyhedralStages stages = BuildPolyhedralStages(contours, options, monitor);
    for (const auto& slab : stages.Slabs)
    {
      figures.Tetrahedra += slab.Diagram.Tetrahedra.size();
    }
    slabs = SlabPoints(stages);
  }
  std::vector<std::pair<double, std::vector<std::pair<std::string, double>>>> runs;
  std::vector<double> cpu, cgal, cgalCPU;
  for (int i = 0; i < repeat; ++i)
  {
    const Watch whole;
    const PolyhedralSurface surface = BuildPolyhedralSurface(contours, options, monitor);
    runs.emplace_back(whole.Wall(), surface.StageSeconds);
    cpu.push_back(whole.CPU());
    figures.Triangles = surface.Mesh.Triangles.size();
    const Watch oracle;
    TriangulateWithCGAL(slabs);
    cgal.push_back(oracle.Wall());
    cgalCPU.push_back(oracle.CPU());
  }
  std::sort(runs.begin(), runs.end());
  figures.Total = runs[runs.size() / 2].first;
  figures.Stages = runs[runs.size() / 2].second;
  figures.CGAL = MedianOf(cgal);
  figures.TotalCPU = MedianOf(cpu);
  figures.CGALCPU = MedianOf(cgalCPU);
  ContourMappingOptions mapping;
  mapping.Threads = 1;
  const Watch mapped;
  BuildContourMapping(contours, mapping, monitor);
  figures.MappingCPU = mapped.CPU();
  return figures;
}

/// All stage names in the order in which they first occur.
std::vector<std::string> StageNames(const std::vector<Figures>& all)
{
  std::vector<std::string> names;
  for (const auto& figures : all)
  {
    for (const auto& stage : figures.Stages)
    {
      if (std::find(names.begin(), names.end(), stage.first) == names.end())
      {
        names.push_back(stage.first);
      }
    }
  }
  return names;
}

template <typename Value>
void PrintRow(const char* title, const char* format, const std::vector<Figures>& all, Value value)
{
  std::printf("%-34s", title);
  for (const auto& figures : all)
  {
    std::printf(format, value(figures));
  }
  std::printf("\n");
}

void PrintTable(const std::vector<Figures>& all)
{
  PrintRow(
    "polyhedral method, 1 thread", "%13s", all, [](const Figures& f) { return f.Name.c_str(); });
  PrintRow("contours", "%13zu", all, [](const Figures& f) { return f.Contours; });
  PrintRow("levels", "%13zu", all, [](const Figures& f) { return f.Levels; });
  PrintRow("contour points", "%13zu", all, [](const Figures& f) { return f.ContourPoints; });
  PrintRow("tetrahedra", "%13zu", all, [](const Figures& f) { return f.Tetrahedra; });
  PrintRow("triangles", "%13zu", all, [](const Figures& f) { return f.Triangles; });
  for (const auto& name : StageNames(all))
  {
    PrintRow(("  " + name + ", s").c_str(), "%13.3f", all,
      [&](const Figures& f)
      {
        const auto stage = std::find_if(
          f.Stages.begin(), f.Stages.end(), [&](const auto& s) { return s.first == name; });
        return stage == f.Stages.end() ? 0.0 : stage->second;
      });
  }
  PrintRow("total, s", "%13.3f", all, [](const Figures& f) { return f.Total; });
  PrintRow("CGAL's 3D Delaunay, s", "%13.3f", all, [](const Figures& f) { return f.CGAL; });
  PrintRow("total, CPU s", "%13.3f", all, [](const Figures& f) { return f.TotalCPU; });
  PrintRow("CGAL's 3D Delaunay, CPU s", "%13.3f", all, [](const Figures& f) { return f.CGALCPU; });
  PrintRow(
    "Mapping Overlap besides, CPU s", "%13.3f", all, [](const Figures& f) { return f.MappingCPU; });
  PrintRow("ratio of CPU", "%13.2f", all, [](const Figures& f) { return f.TotalCPU / f.CGALCPU; });
}

void WriteJSON(const std::vector<Figures>& all, const std::string& fileName)
{
  std::ofstream out(fileName);
  out << "[\n";
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const Figures& f = all[i];
    out << "  {\"name\": \"" << f.Name << "\", \"contours\": " << f.Contours
        << ", \"levels\": " << f.Levels << ", \"contour_points\": " << f.ContourPoints
        << ", \"tetrahedra\": " << f.Tetrahedra << ", \"triangles\": " << f.Triangles
        << ", \"stages\": {";
    for (std::size_t s = 0; s < f.Stages.size(); ++s)
    {
      out << (s > 0 ? ", " : "") << '"' << f.Stages[s].first << "\": " << f.Stages[s].second;
    }
    out << "}, \"total\": " << f.Total << ", \"cgal_delaunay_3\": " << f.CGAL
        << ", \"total_cpu\": " << f.TotalCPU << ", \"cgal_delaunay_3_cpu\": " << f.CGALCPU
        << ", \"total_cpu\": " << f.TotalCPU << ", \"cgal_delaunay_3_cpu\": " << f.CGALCPU
        << ", \"ratio\": " << f.TotalCPU / f.CGALCPU << "}" << (i + 1 < all.size() ? "," : "")
        << "\n";
  }
  out << "]\n";
  if (!out.flush())
  {
    throw Error("Could not write " + fileName + ".");
  }
}

int Run(int argc, char** argv)
{
  std::string json, only;
  int repeat = 5;
  for (int i = 1; i < argc; i += 2)
  {
    const std::string option = argv[i];
    const std::string value = i + 1 < argc ? argv[i + 1] : "";
    if (option == "--json" && !value.empty())
    {
      json = value;
    }
    else if (option == "--only" && !value.empty())
    {
      only = value;
    }
    else if (option == "--repeat" && std::atoi(value.c_str()) > 0)
    {
      repeat = std::atoi(value.c_str());
    }
    else
    {
      std::fprintf(stderr, "usage: bench_psm [--json FILE] [--repeat N] [--only TEXT]\n");
      return 2;
    }
  }
  std::vector<Figures> all;
  for (const Case& c : Cases)
  {
    if (c.Name.find(only) == std::string::npos)
    {
      continue;
    }
    if (!std::filesystem::exists(c.File))
    {
      std::fprintf(stderr, "%s: no %s, so it is left out\n", c.Name.c_str(), c.File.c_str());
      continue;
    }
    all.push_back(Measure(c, repeat));
  }
  PrintTable(all);
  if (!json.empty())
  {
    WriteJSON(all, json);
  }
  return all.empty() ? 1 : 0;
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
    std::fprintf(stderr, "bench_psm: %s\n", error.what());
    return 1;
  }
}
