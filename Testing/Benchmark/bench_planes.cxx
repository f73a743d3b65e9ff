// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file bench_planes.cxx
 * @brief Does the implicit surface have, on every drawn plane, the contours that were drawn there?
 *
 *   bench_planes [--each] [--plain] [--most N] [--least N] [--seconds N] [--ends PART]
 *     [--depth CELLS] [--area PART] [--waist PART] FILE ...
 *
 * A line an ROI (or set) of parallel contours, tab-separated, under a line of the columns' names.
 * Volumes are those of the implicit surface (cut at --ends, and at half a slice) and of the
 * polyhedral one with HalfSlice ends; `within` is the part of each between the first and the last
 * plane; `straight` and `smooth` are what the drawn areas have there, changing evenly and smoothly
 * from plane to plane. `following` are those of all the seconds that following the planes took.
 *
 * --each: a line a plane that differs, on standard error. --plain: as if only contours told
 * anything. --least, --most: ROIs of fewer, and of more, points are left out. --seconds: an ROI
 * that takes more processor seconds becomes a sentence. --ends: EndsBeyond. --depth, --area,
 * --waist: SectionTolerances (Constraints.h), to see what their values are worth.
 *
 * Contours of less than 3 square units do not count.
 */
#include "Base/Median.h"
#include "Contours/ContourSetBuilder.h"
#include "Core/SetsOfData.h"
#include "Implicit/ImplicitSurface.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
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
  double Difference = 0; ///< of all planes
  double Area = 0;
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
  figures.Difference += difference * square;
  figures.Area += area * square;
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

/// The volume of a closed mesh below a height: of min(h, height) along the normal, as the
/// divergence theorem has it.
double VolumeBelow(const TriangleMesh& mesh, const Vector3& normal, double height)
{
  double volume = 0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Point3& a = mesh.Points[t[0]];
    const Point3& b = mesh.Points[t[1]];
    const Point3& c = mesh.Points[t[2]];
    const double area = 0.5 * Dot(Cross(b - a, c - a), normal);
    std::array<double, 3> h{ Dot(a, normal) - height, Dot(b, normal) - height,
      Dot(c, normal) - height };
    std::sort(h.begin(), h.end());
    const auto [low, middle, high] = h;
    double mean = (low + middle + high) / 3;
    // The mean of max(h, 0), which is taken off again.
    double above = 0;
    if (low >= 0)
    {
      above = mean;
    }
    else if (middle >= 0 && high > 0)
    {
      above = mean - low / 3 * low / (low - middle) * low / (low - high);
    }
    else if (high > 0)
    {
      above = high / 3 * high / (high - middle) * high / (high - low);
    }
    volume += area * (mean - above);
  }
  return volume;
}

constexpr double HalfSlice = 0.5;

struct Volumes
{
  double All = 0;
  double Within = 0; ///< the first and the last plane
};

/// @param ends beyond the outermost planes, in gaps
Volumes VolumesOf(const TriangleMesh& mesh, const ContourSet& drawn, double ends)
{
  const Vector3& normal = drawn.Levels.front().Frame.Normal;
  std::vector<double> heights;
  for (const Level& level : drawn.Levels)
  {
    heights.push_back(Dot(level.Frame.Normal, normal) * level.Offset);
  }
  std::sort(heights.begin(), heights.end());
  std::vector<double> gaps;
  for (std::size_t l = 1; l < heights.size(); ++l)
  {
    gaps.push_back(heights[l] - heights[l - 1]);
  }
  const double beyond = ends * Median(gaps);
  const auto between = [&](double low, double high)
  { return VolumeBelow(mesh, normal, high) - VolumeBelow(mesh, normal, low); };
  return { between(heights.front() - beyond, heights.back() + beyond),
    between(heights.front(), heights.back()) };
}

struct Slice
{
  double Height = 0;
  double Area = 0;
};

/// By height.
std::vector<Slice> SlicesOf(const ContourSet& drawn)
{
  const Vector3& normal = drawn.Levels.front().Frame.Normal;
  std::vector<Slice> slices;
  for (const Level& level : drawn.Levels)
  {
    Slice slice{ Dot(level.Frame.Normal, normal) * level.Offset, 0 };
    for (const int c : level.Contours)
    {
      slice.Area += drawn.Contours[c].SignedArea;
    }
    slices.push_back(slice);
  }
  std::sort(slices.begin(), slices.end(),
    [](const Slice& a, const Slice& b) { return a.Height < b.Height; });
  return slices;
}

/// How the area changes at a slice: of the parabola through three slices, that one among them.
double SlopeAt(const std::vector<Slice>& slices, std::size_t s)
{
  const std::size_t first = std::min(s > 0 ? s - 1 : 0, slices.size() - 3);
  const Slice& a = slices[first];
  const Slice& b = slices[first + 1];
  const Slice& c = slices[first + 2];
  const double ab = (b.Area - a.Area) / (b.Height - a.Height);
  const double bc = (c.Area - b.Area) / (c.Height - b.Height);
  const double second = (bc - ab) / (c.Height - a.Height);
  return ab + second * (2 * slices[s].Height - a.Height - b.Height);
}

/// The drawn areas' integral between the first plane and the last.
struct SectionVolumes
{
  double Straight = 0; ///< as if areas changed evenly between two planes
  double Smooth = 0;   ///< of the cubics with the slopes of parabolas through three planes
};

SectionVolumes VolumesOfSections(const ContourSet& drawn)
{
  const std::vector<Slice> slices = SlicesOf(drawn);
  SectionVolumes volumes;
  for (std::size_t s = 0; s + 1 < slices.size(); ++s)
  {
    const double gap = slices[s + 1].Height - slices[s].Height;
    const double straight = 0.5 * gap * (slices[s].Area + slices[s + 1].Area);
    volumes.Straight += straight;
    volumes.Smooth += straight;
    if (slices.size() > 2)
    {
      volumes.Smooth += gap * gap / 12 * (SlopeAt(slices, s) - SlopeAt(slices, s + 1));
    }
  }
  return volumes;
}

double Seconds()
{
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Stops what takes too long, and sees when the drawn planes are followed.
class LimitMonitor final : public Monitor
{
public:
  explicit LimitMonitor(double seconds) : End(Seconds() + seconds) {}
  bool AbortRequested() override { return Seconds() > this->End; }
  double SecondsOfFollowing() const { return std::max(0.0, this->To - this->From); }

protected:
  void OnProgress(double fraction, const char*) override
  {
    if (this->To > 0)
    {
      return; // of another call
    }
    if (fraction < FollowingFrom)
    {
      this->From = Seconds();
    }
    else if (fraction >= FollowingTo)
    {
      this->To = Seconds();
    }
  }

private:
  /// The shares that ImplicitSurface.cxx gives to the fit (.6) and ContourFit.cxx to what comes
  /// before following (.7), with room for rounding.
  static constexpr double FollowingFrom = 0.6 * 0.7 - 1e-9;
  static constexpr double FollowingTo = 0.6 - 1e-9;

  double End;
  double From = 0;
  double To = 0;
};

struct Arguments
{
  bool Plain = false;
  bool Each = false;
  double Least = 0;
  double Most = 1e9;
  double Limit = 1e9;
  double Ends = DefaultEndsBeyond;
  SectionTolerances Tolerances;
};

Volumes Polyhedral(const LoopSoup& soup, const ContourSet& drawn, Monitor& monitor)
{
  PolyhedralOptions flat;
  flat.EndCaps = PolyhedralOptions::HalfSlice;
  flat.Mapping = PolyhedralOptions::Overlap;
  flat.IsolatedContours = PolyhedralOptions::Extrude;
  const ContourSet parallel = BuildContourSet(soup, ContourSetOptions(), monitor);
  return VolumesOf(BuildPolyhedralSurface(parallel, flat, monitor).Mesh, drawn, 2 * HalfSlice);
}

/// What Report says of the drawn planes.
std::string WordsOf(const ImplicitSurface& surface)
{
  std::string words;
  for (const std::string& line : surface.Report)
  {
    if (line.find("drawn") != std::string::npos || line.find("were put on") != std::string::npos)
    {
      words += line + " ";
    }
  }
  return words;
}

void Measure(const std::string& title, const LoopSoup& soup, const ContourSet& drawn,
  const Arguments& arguments)
{
  LimitMonitor monitor(arguments.Limit);
  ImplicitSurfaceOptions options;
  options.Constraints.FollowDrawnPlanes = !arguments.Plain;
  options.Constraints.FillLongEdges = !arguments.Plain;
  options.Constraints.Sections = arguments.Tolerances;
  options.Polygonizer.CleanUp = false;
  options.Polygonizer.Threads = 1;
  options.Function.Threads = 1;
  // What lies beyond other ends is cut off afterwards.
  options.EndsBeyond = std::max(HalfSlice, arguments.Ends);
  const double start = Seconds();
  const ImplicitSurface surface = BuildImplicitSurface(drawn, options, monitor);
  const double seconds = Seconds() - start;
  TracerOptions tracing;
  tracing.Threads = 1;
  tracing.Box = ChooseBoundsOf(drawn, options.EndsBeyond);
  PlaneFigures figures;
  const ContourSet traced = TraceContours(
    surface.Fit.Function, SeedsOf(surface.Fit.Contours), PlanesOf(drawn), tracing, monitor);
  for (int l = 0; l < static_cast<int>(drawn.Levels.size()); ++l)
  {
    CompareLevel(drawn, l, traced, figures);
  }
  const double following = monitor.SecondsOfFollowing();
  const Volumes implicit = VolumesOf(surface.Mesh.Mesh, drawn, arguments.Ends);
  const Volumes half = VolumesOf(surface.Mesh.Mesh, drawn, HalfSlice);
  const Volumes polyhedral = Polyhedral(soup, drawn, monitor);
  const SectionVolumes sections = VolumesOfSections(drawn);
  std::printf("%s\t%zu\t%zu\t%d\t%d\t%d\t%.2f\t%.6g\t%.4g\t%.2f\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g\t"
              "%.6g\t%.6g\t%.2f\t%.2f\t%zu\t%s\n",
    title.c_str(), drawn.Points.size(), drawn.Levels.size(), figures.Drawn, figures.Traced,
    figures.OtherCount, figures.Worst, figures.WorstAt, figures.WorstArea,
    figures.Area > 0 ? 100 * figures.Difference / figures.Area : 0, implicit.All, half.All,
    implicit.Within, polyhedral.All, polyhedral.Within, sections.Straight, sections.Smooth, seconds,
    following, surface.Fit.Constraints.Points.size(), WordsOf(surface).c_str());
  std::fflush(stdout);
  if (arguments.Each)
  {
    std::fputs(figures.Each.c_str(), stderr);
  }
}

constexpr const char* Columns =
  "file\tROI\tpoints\tplanes\tdrawn\ttraced\tother\tworst\tat\tarea\tmean\tvolume\thalf "
  "slices\twithin\tpolyhedr"
  "al\t"
  "polyhedral within\tstraight\tsmooth\tseconds\tfollowing\tconstraints\treport";

void MeasureFile(const std::string& path, const Arguments& arguments)
{
  for (const auto& [name, soup] : recon::testing::ReadSoups(path))
  {
    const std::string title = std::filesystem::path(path).filename().string() + "\t" + name;
    try
    {
      LimitMonitor monitor(arguments.Limit);
      ContourSetOptions planes;
      planes.Parallel = false;
      const ContourSet drawn = BuildContourSet(soup, planes, monitor);
      const auto points = static_cast<double>(drawn.Points.size());
      if (drawn.Contours.empty() || points > arguments.Most || points < arguments.Least)
      {
        continue;
      }
      Measure(title, soup, drawn, arguments);
    }
    catch (const Aborted&)
    {
      std::printf("%s\tnot within %g processor seconds\n", title.c_str(), arguments.Limit);
    }
    catch (const std::exception& error)
    {
      std::printf("%s\t%s\n", title.c_str(), error.what());
    }
    std::fflush(stdout);
  }
}
}

int main(int argc, char** argv)
{
  Arguments arguments;
  const std::pair<const char*, double*> numbers[] = { { "--depth", &arguments.Tolerances.Depth },
    { "--area", &arguments.Tolerances.Area }, { "--waist", &arguments.Tolerances.WaistArea },
    { "--ends", &arguments.Ends }, { "--least", &arguments.Least }, { "--most", &arguments.Most },
    { "--seconds", &arguments.Limit } };
  const std::pair<const char*, bool*> switches[] = { { "--plain", &arguments.Plain },
    { "--each", &arguments.Each } };
  std::puts(Columns);
  for (int i = 1; i < argc; ++i)
  {
    const auto isNamed = [&](const auto& option)
    { return std::strcmp(argv[i], option.first) == 0; };
    const auto* number = std::find_if(std::begin(numbers), std::end(numbers), isNamed);
    const auto* toggle = std::find_if(std::begin(switches), std::end(switches), isNamed);
    if (number != std::end(numbers) && i + 1 < argc)
    {
      *number->second = std::strtod(argv[++i], nullptr);
    }
    else if (toggle != std::end(switches))
    {
      *toggle->second = true;
    }
    else
    {
      MeasureFile(argv[i], arguments);
    }
  }
  return 0;
}
