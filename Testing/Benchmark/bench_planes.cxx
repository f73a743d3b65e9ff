// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file bench_planes.cxx
 * @brief Does the implicit surface have, on every drawn plane, the contours that were drawn there?
 *
 *   bench_planes [--plain] [--each] [--points N] [--depth CELLS] [--area PART] [--waist PART] FILE ...
 *
 * A line an ROI (or set) of parallel contours, tab-separated: file, ROI, planes, contours drawn,
 * traced, planes with another number of contours, the largest symmetric difference of a plane in
 * per cent of its drawn area (where, and that area), volume of the implicit surface, of the polyhedral one with HalfSlice
 * ends, processor seconds, constraints, the lines of Report that the drawn planes made. --plain: as if only
 * contours told anything. --each: a line a plane that differs, on standard error. --points: ROIs of more points are left out. --depth, --area, --waist:
 * SectionTolerances (Constraints.h), to see what their values are worth.
 *
 * Contours of less than 3 square units do not count.
 */
#include "Contours/ContourSetBuilder.h"
#include "Core/SetsOfData.h"
#include "Implicit/ImplicitSurface.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "Mesh/MassProperties.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <cstdio>
#include <cstring>
#include <ctime>

using namespace recon;

namespace
{
constexpr double LeastArea = 3;
constexpr int Scanlines = 500;
/// Per cent of the drawn area from which on a plane is one that differs.
constexpr double Promised = 2;

/// Where the contours of a level cross a line of constant v.
std::vector<double> Crossings(const ContourSet& set, int level, const PlanarFrame& frame, double v)
{
  std::vector<double> at;
  for (const int c : set.Levels[level].Contours)
  {
    const std::vector<int>& points = set.Contours[c].Points;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Point2 a = frame.ToPlane(set.Points[points[i]]);
      const Point2 b = frame.ToPlane(set.Points[points[(i + 1) % points.size()]]);
      if ((a[1] > v) != (b[1] > v))
      {
        at.push_back(a[0] + (b[0] - a[0]) * (v - a[1]) / (b[1] - a[1]));
      }
    }
  }
  std::sort(at.begin(), at.end());
  return at;
}

double LengthOf(const std::vector<double>& ends)
{
  double length = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    length += ends[i + 1] - ends[i];
  }
  return length;
}

struct PlaneFigures
{
  int Drawn = 0;
  int Traced = 0;
  int OtherCount = 0;
  double Worst = 0; ///< per cent
  double WorstAt = 0;
  double WorstArea = 0;
  std::string Each; ///< a line a plane that differs
};

int CountLarge(const ContourSet& set, int level)
{
  int count = 0;
  for (const int c : set.Levels[level].Contours)
  {
    count += std::abs(set.Contours[c].SignedArea) > LeastArea ? 1 : 0;
  }
  return count;
}

int LevelAt(const ContourSet& set, const Level& like)
{
  for (int l = 0; l < static_cast<int>(set.Levels.size()); ++l)
  {
    const double sign = Dot(set.Levels[l].Frame.Normal, like.Frame.Normal);
    if (std::abs(sign * set.Levels[l].Offset - like.Offset) < 1e-6 * (1 + std::abs(like.Offset)))
    {
      return l;
    }
  }
  return -1;
}

void CompareLevel(
  const ContourSet& drawn, int level, const ContourSet& traced, PlaneFigures& figures)
{
  const Level& plane = drawn.Levels[level];
  const int other = LevelAt(traced, plane);
  const int count = CountLarge(drawn, level);
  const int found = other < 0 ? 0 : CountLarge(traced, other);
  figures.Drawn += count;
  figures.Traced += found;
  figures.OtherCount += count != found ? 1 : 0;
  Box2 box;
  const auto grow = [&](const ContourSet& set, int l)
  {
    for (const int c : set.Levels[l].Contours)
    {
      for (const int p : set.Contours[c].Points)
      {
        box.Add(plane.Frame.ToPlane(set.Points[p]));
      }
    }
  };
  grow(drawn, level);
  if (other >= 0)
  {
    grow(traced, other);
  }
  double area = 0;
  double difference = 0;
  for (int k = 0; k < Scanlines; ++k)
  {
    const double v = box.Low[1] + (k + 0.5) / Scanlines * box.Extent(1);
    std::vector<double> ends = Crossings(drawn, level, plane.Frame, v);
    area += LengthOf(ends);
    if (other >= 0)
    {
      const std::vector<double> more = Crossings(traced, other, plane.Frame, v);
      ends.insert(ends.end(), more.begin(), more.end());
      std::sort(ends.begin(), ends.end());
    }
    difference += LengthOf(ends);
  }
  const double square = box.Extent(1) / Scanlines;
  if (count != found || (area * square > LeastArea && 100 * difference > Promised * area))
  {
    char line[160];
    std::snprintf(line, sizeof line,
      "  %.6g: %d contours, %d traced; %.4g of %.4g differ, %.2f %%\n", plane.Offset, count, found,
      difference * square, area * square, 100 * difference / area);
    figures.Each += line;
  }
  if (area * square > LeastArea)
  {
    if (100 * difference > figures.Worst * area)
    {
      figures.Worst = 100 * difference / area;
      figures.WorstAt = plane.Offset;
      figures.WorstArea = area * square;
    }
  }
}

double VolumeOf(const TriangleMesh& mesh)
{
  const std::vector<int> one(mesh.Triangles.size(), 0);
  return ComputeSignedVolumes(mesh, one, 1).front();
}

void Measure(const std::string& file, const std::string& name, const ContourSet& drawn, bool plain,
  bool each, double ends, const ContourSet& parallel, const SectionTolerances& tolerances)
{
  Monitor monitor;
  ImplicitSurfaceOptions options;
  options.Constraints.FollowDrawnPlanes = !plain;
  options.Constraints.FillLongEdges = !plain;
  options.Constraints.Sections = tolerances;
  options.Polygonizer.CleanUp = false;
  options.EndsBeyond = ends;
  const std::clock_t start = std::clock();
  const ImplicitSurface surface = BuildImplicitSurface(drawn, options, monitor);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  TracerOptions tracing;
  tracing.Box = ChooseBoundsOf(drawn, ends);
  PlaneFigures figures;
  const ContourSet traced = TraceContours(
    surface.Fit.Function, SeedsOf(surface.Fit.Contours), PlanesOf(drawn), tracing, monitor);
  for (int l = 0; l < static_cast<int>(drawn.Levels.size()); ++l)
  {
    CompareLevel(drawn, l, traced, figures);
  }
  double polyhedral = 0;
  try
  {
    PolyhedralOptions flat;
    flat.EndCaps = PolyhedralOptions::HalfSlice;
    flat.Mapping = PolyhedralOptions::Overlap;
    flat.IsolatedContours = PolyhedralOptions::Extrude;
    polyhedral = VolumeOf(BuildPolyhedralSurface(parallel, flat, monitor).Mesh);
  }
  catch (const Error&)
  {
  }
  std::printf("%s\t%s\t%zu\t%d\t%d\t%d\t%.2f (%.6g, %.4g)\t%.6g\t%.6g\t%.2f\t%zu\t", file.c_str(),
    name.c_str(), drawn.Levels.size(), figures.Drawn, figures.Traced, figures.OtherCount,
    figures.Worst, figures.WorstAt, figures.WorstArea, VolumeOf(surface.Mesh.Mesh), polyhedral,
    seconds, surface.Fit.Constraints.Points.size());
  for (const std::string& line : surface.Report)
  {
    if (line.find("drawn") != std::string::npos || line.find("were put on") != std::string::npos)
    {
      std::printf("%s ", line.c_str());
    }
  }
  std::printf("\n");
  std::fflush(stdout);
  if (each)
  {
    std::fputs(figures.Each.c_str(), stderr);
  }
}
}

int main(int argc, char** argv)
{
  bool plain = false;
  bool each = false;
  std::size_t most = static_cast<std::size_t>(-1);
  SectionTolerances tolerances;
  double ends = DefaultEndsBeyond;
  const std::pair<const char*, double*> settable[] = { { "--depth", &tolerances.Depth },
    { "--area", &tolerances.Area }, { "--waist", &tolerances.WaistArea }, { "--ends", &ends } };
  for (int i = 1; i < argc; ++i)
  {
    const auto* set = std::find_if(std::begin(settable), std::end(settable),
      [&](const auto& option) { return std::strcmp(argv[i], option.first) == 0; });
    if (set != std::end(settable) && i + 1 < argc)
    {
      *set->second = std::strtod(argv[++i], nullptr);
      continue;
    }
    if (std::strcmp(argv[i], "--plain") == 0)
    {
      plain = true;
      continue;
    }
    if (std::strcmp(argv[i], "--each") == 0)
    {
      each = true;
      continue;
    }
    if (std::strcmp(argv[i], "--points") == 0 && i + 1 < argc)
    {
      most = std::strtoul(argv[++i], nullptr, 10);
      continue;
    }
    for (const auto& [name, soup] : recon::testing::ReadSoups(argv[i]))
    {
      try
      {
        Monitor monitor;
        ContourSetOptions planes;
        planes.Parallel = false;
        const ContourSet drawn = BuildContourSet(soup, planes, monitor);
        if (drawn.Contours.empty() || drawn.Points.size() > most)
        {
          continue;
        }
        Measure(std::filesystem::path(argv[i]).filename().string(), name, drawn, plain, each, ends,
          BuildContourSet(soup, ContourSetOptions(), monitor), tolerances);
      }
      catch (const std::exception& error)
      {
        std::printf("%s\t%s\t%s\n", argv[i], name.c_str(), error.what());
      }
    }
  }
  return 0;
}
