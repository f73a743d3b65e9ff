// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/ContourTracer.h"

#include "Base/BoundingBox.h"
#include "Base/Median.h"
#include "Base/SubMonitor.h"
#include "Contours/ContourSetBuilder.h"
#include "Contours/Specks.h"
#include "Implicit/ZeroSet/EdgeRoots.h"
#include "Implicit/ZeroSet/Polygonizer.h"
#include "Implicit/ZeroSet/SurfaceTracker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <utility>

namespace recon
{
namespace
{
/// Where a spacing of 0 asks for planes, there are this many intervals.
constexpr double AutomaticIntervals = 20;

/// So near to the outermost contour points, as a part of the planes' distance, a plane that tells no
/// tolerance of its own is theirs.
constexpr double BesideContours = 0.05;

/// Roots nearer to the one before than this part of a cell are left out: they say nothing but make
/// slivers.
constexpr double NearRoots = 0.05;
/// A section whose mean width (twice its area by its length) is less than so many squares gets
/// squares of half the size, but not below a quarter of a cell: chords across squares of 1 mm cut 3%
/// off a section of 113 mm2 drawn along pixels.
constexpr double EnoughSquares = 16;
constexpr int MostHalvings = 2;
/// Loops of fewer points are small beside the grid's squares: they get points half way between.
constexpr std::size_t FewPoints = 64;
/// A point half way moves by at most this part of its chord, in so many steps of Newton's.
constexpr double MostMove = 0.25;
constexpr int HalfWaySteps = 2;
/// A plane's offset, and that of a point in it, differ by no more than this part of it.
constexpr double OffsetRounding = 1e-14;

/// The three kinds of edges of a grid of squares with one diagonal, by the offset of their far end.
constexpr int EdgeOffsets[3][2] = { { 1, 0 }, { 0, 1 }, { 1, 1 } };

/// One plane's grid. A node is (i, j), an edge a node and one of EdgeOffsets.
class PlaneGrid
{
public:
  PlaneGrid(const TracePlane& plane, const Bounds& box, double cell) : Plane(plane), Cell(cell)
  {
    Box2 around;
    for (int corner = 0; corner < 8; ++corner)
    {
      around.Add(plane.Frame.ToPlane(
        { box[corner & 1], box[2 + ((corner >> 1) & 1)], box[4 + ((corner >> 2) & 1)] }));
    }
    for (int a = 0; a < 2; ++a)
    {
      // Half a cell beyond the box, where the field is outside: every contour closes.
      this->Origin[a] = around.Low[a] - 0.5 * cell;
      this->Squares[a] = static_cast<int>(std::ceil(around.Extent(a) / cell)) + 1;
    }
  }

  Point3 At(double i, double j) const
  {
    return this->Plane.Frame.ToSpace(
      { this->Origin[0] + i * this->Cell, this->Origin[1] + j * this->Cell }, this->Plane.Offset);
  }

  std::int64_t Node(int i, int j) const
  {
    return static_cast<std::int64_t>(j) * (this->Squares[0] + 1) + i;
  }

  TracePlane Plane;
  double Cell;
  Point2 Origin{};
  std::array<int, 2> Squares{};
};

using Square = std::array<int, 2>;
using Loops = std::vector<std::vector<Point3>>;

/// Traces the contours of one plane.
class PlaneTracer
{
public:
  PlaneTracer(const BoundedField& field, const SurfaceTracker& surface, const PlaneGrid& grid)
    : Field(field),
      Grid(grid)
  {
    for (int j = 0; j < grid.Squares[1]; ++j)
    {
      for (int i = 0; i < grid.Squares[0]; ++i)
      {
        if (surface.Near(grid.At(i + 0.5, j + 0.5)))
        {
          this->Near.push_back({ i, j });
        }
      }
    }
    this->EvaluateNodes();
    for (const Square& s : this->Near)
    {
      // The diagonal runs from (0, 0) to (1, 1) of every square.
      this->CutTriangle({ { s, { s[0] + 1, s[1] }, { s[0] + 1, s[1] + 1 } } });
      this->CutTriangle({ { s, { s[0] + 1, s[1] + 1 }, { s[0], s[1] + 1 } } });
    }
  }

  /// Closed contours, the solid on their left, as lists of points.
  Loops Trace(double tolerance, Monitor& monitor) const
  {
    const std::vector<Point3> roots =
      FindRoots(this->Field, this->Crossed, tolerance * this->Grid.Cell, monitor);
    Loops loops;
    std::vector<char> done(this->Next.size(), 0);
    for (std::size_t start = 0; start < this->Next.size(); ++start)
    {
      std::vector<Point3> loop;
      int at = static_cast<int>(start);
      while (at >= 0 && !done[at])
      {
        done[at] = 1;
        this->AppendPoint(roots[at], loop);
        at = this->Next[at];
      }
      // An open end is where the zero set leaves the surroundings of the surface: a phantom sheet.
      if (at == static_cast<int>(start) && loop.size() >= 3)
      {
        loops.push_back(loop.size() < FewPoints ? this->WithHalfWays(loop) : std::move(loop));
      }
    }
    return loops;
  }

private:
  /// A point between each two, on the contour: its chords would cut off too much of a small one.
  std::vector<Point3> WithHalfWays(const std::vector<Point3>& loop) const
  {
    const std::size_t n = loop.size();
    const Vector3& normal = this->Grid.Plane.Frame.Normal;
    std::vector<Point3> chords;
    for (std::size_t i = 0; i < n; ++i)
    {
      chords.push_back(0.5 * loop[i] + 0.5 * loop[(i + 1) % n]);
    }
    std::vector<Point3> middles = chords;
    for (int step = 0; step < HalfWaySteps; ++step)
    {
      std::vector<double> g;
      std::vector<Vector3> slopes;
      this->Field.Evaluate(middles, g, slopes);
      for (std::size_t i = 0; i < n; ++i)
      {
        const Vector3 slope = slopes[i] - Dot(slopes[i], normal) * normal;
        const double steep = Dot(slope, slope);
        middles[i] = steep > 0 ? middles[i] - (g[i] / steep) * slope : middles[i];
      }
    }
    std::vector<Point3> more;
    for (std::size_t i = 0; i < n; ++i)
    {
      more.push_back(loop[i]);
      const double chord = Norm(loop[(i + 1) % n] - loop[i]);
      if (Norm(middles[i] - chords[i]) <= MostMove * chord)
      {
        more.push_back(middles[i]);
      }
    }
    return more;
  }

  void AppendPoint(const Point3& p, std::vector<Point3>& loop) const
  {
    const double least = NearRoots * this->Grid.Cell;
    if (loop.empty() || Norm(p - loop.back()) > least)
    {
      loop.push_back(p);
    }
  }

  void EvaluateNodes()
  {
    std::vector<std::int64_t> nodes;
    std::vector<Point3> points;
    for (const Square& s : this->Near)
    {
      for (int c = 0; c < 4; ++c)
      {
        const int i = s[0] + (c & 1);
        const int j = s[1] + (c >> 1);
        if (this->Values.emplace(this->Grid.Node(i, j), 0.0).second)
        {
          nodes.push_back(this->Grid.Node(i, j));
          points.push_back(this->Grid.At(i, j));
        }
      }
    }
    const std::vector<double> values = this->Field.Values(points);
    for (std::size_t k = 0; k < nodes.size(); ++k)
    {
      this->Values[nodes[k]] = values[k];
    }
  }

  double ValueAt(const Square& node) const
  {
    return this->Values.at(this->Grid.Node(node[0], node[1]));
  }

  /// The number of the cut edge between two nodes of a triangle, in either order.
  int EdgeBetween(Square a, Square b)
  {
    if (b < a)
    {
      std::swap(a, b);
    }
    int kind = 0;
    while (EdgeOffsets[kind][0] != b[0] - a[0] || EdgeOffsets[kind][1] != b[1] - a[1])
    {
      ++kind;
    }
    const std::int64_t key = 3 * this->Grid.Node(a[0], a[1]) + kind;
    const auto [place, isNew] =
      this->EdgeNumbers.emplace(key, static_cast<int>(this->Crossed.size()));
    if (isNew)
    {
      const bool inside = this->ValueAt(a) > 0;
      const Square& in = inside ? a : b;
      const Square& out = inside ? b : a;
      this->Crossed.push_back({ this->Grid.At(in[0], in[1]), this->Grid.At(out[0], out[1]),
        this->ValueAt(in), this->ValueAt(out) });
      this->Next.push_back(-1);
    }
    return place->second;
  }

  /// A counterclockwise triangle: the contour leaves it so that inside corners stay on its left.
  void CutTriangle(const std::array<Square, 3>& corners)
  {
    int inside = 0;
    for (const Square& c : corners)
    {
      inside += this->ValueAt(c) > 0 ? 1 : 0;
    }
    if (inside == 0 || inside == 3)
    {
      return;
    }
    // The corner that is alone, and the two after it, counterclockwise.
    int alone = 0;
    while ((this->ValueAt(corners[alone]) > 0) != (inside == 1))
    {
      ++alone;
    }
    const Square& a = corners[alone];
    const int after = this->EdgeBetween(a, corners[(alone + 1) % 3]);
    const int before = this->EdgeBetween(a, corners[(alone + 2) % 3]);
    if (inside == 1)
    {
      this->Next[after] = before;
    }
    else
    {
      this->Next[before] = after;
    }
  }

  const BoundedField& Field;
  const PlaneGrid& Grid;
  std::vector<Square> Near;
  std::unordered_map<std::int64_t, double> Values;
  std::unordered_map<std::int64_t, int> EdgeNumbers;
  std::vector<CrossedEdge> Crossed;
  std::vector<int> Next; ///< a cut edge: the one that the contour goes on to
};

/// Twice the area by the length, of all loops of a plane together.
double MeanWidth(const Loops& loops, const Vector3& normal)
{
  double twice = 0;
  double length = 0;
  for (const std::vector<Point3>& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Vector3 a = loop[i] - loop[0];
      const Vector3 b = loop[(i + 1) % loop.size()] - loop[0];
      twice += Dot(Cross(a, b), normal);
      length += Norm(b - a);
    }
  }
  return length > 0 ? twice / length : 0;
}

/// The contours of a plane, in squares that are small beside them.
Loops TracePlaneFinely(const BoundedField& field, const SurfaceTracker& surface,
  const TracePlane& plane, const Bounds& box, double cell, double tolerance, Monitor& monitor)
{
  Loops loops;
  for (int halving = 0; halving <= MostHalvings; ++halving)
  {
    const double size = cell / (1 << halving);
    const PlaneGrid grid(plane, box, size);
    loops = PlaneTracer(field, surface, grid).Trace(tolerance, monitor);
    if (loops.empty() || MeanWidth(loops, plane.Frame.Normal) >= EnoughSquares * size)
    {
      break;
    }
  }
  return loops;
}

void CheckPlanes(const std::vector<TracePlane>& planes)
{
  if (planes.empty())
  {
    throw Error(
      "There is no plane to trace contours on: give a direction with a range and a spacing, or a "
      "second input.");
  }
  for (const TracePlane& plane : planes)
  {
    if (!std::isfinite(plane.Offset))
    {
      throw Error("A plane's offset is not a finite number.");
    }
  }
}

bool AllParallel(const std::vector<TracePlane>& planes)
{
  return std::all_of(planes.begin(), planes.end(),
    [&](const TracePlane& p)
    { return Norm(Cross(p.Frame.Normal, planes.front().Frame.Normal)) < 1e-9; });
}

void AppendLoops(const Loops& loops, LoopSoup& soup)
{
  for (const std::vector<Point3>& loop : loops)
  {
    soup.Append(loop);
  }
}
}

ContourSet TraceContours(const ImplicitFunction& function, const std::vector<Point3>& seeds,
  const std::vector<TracePlane>& planes, const TracerOptions& options, Monitor& monitor)
{
  function.Validate();
  CheckPlanes(planes);
  const Bounds box = ChooseBounds(seeds, options.Box);
  const double cell = ChooseCellSize(seeds, options.CellSize);
  CheckCellCount(BoundsOf(seeds), box, cell, options.MaximumCells);
  const BoundedField field(function, box, true, options.Threads, monitor);
  SubMonitor tracking(monitor, 0, 0.3);
  const BoundedField open = field.Open();
  const SurfaceTracker surface(
    open, Lattice(box, cell, true), seeds, options.MaximumCells, tracking);

  LoopSoup soup;
  for (std::size_t p = 0; p < planes.size(); ++p)
  {
    const double done = static_cast<double>(p) / static_cast<double>(planes.size());
    monitor.Update(0.3 + 0.6 * done, "tracing contours");
    Monitor silent;
    AppendLoops(
      TracePlaneFinely(field, surface, planes[p], box, cell, options.Tolerance, silent), soup);
  }
  const std::string specks = LeaveOutSpecks(options.SmallestArea, soup);
  if (soup.Chains.empty())
  {
    throw Error("No plane meets the surface: move the range of the planes over the contours.");
  }
  SubMonitor nesting(monitor, 0.9, 1);
  ContourSetOptions building;
  building.Parallel = AllParallel(planes);
  ContourSet contours = BuildContourSet(soup, building, nesting);
  if (!specks.empty())
  {
    contours.Report.push_back(specks);
  }
  return contours;
}

std::vector<TracePlane> PlanesWithin(
  const std::vector<TracePlane>& planes, const std::vector<Point3>& points, double tolerance)
{
  std::vector<TracePlane> within;
  for (const TracePlane& plane : planes)
  {
    const double least = -tolerance - OffsetRounding * std::abs(plane.Offset);
    const auto reaches = [&](double side)
    {
      return std::any_of(points.begin(), points.end(),
        [&](const Point3& p) { return side * (plane.Frame.OffsetOf(p) - plane.Offset) >= least; });
    };
    if (reaches(1) && reaches(-1))
    {
      within.push_back(plane);
    }
  }
  return within;
}

PlanarFrame FrameAbout(const Vector3& normal)
{
  const double length = Norm(normal);
  if (!(length > 0) || !std::isfinite(length))
  {
    throw Error(
      "The direction of the planes is zero or not a finite number: give the normal of the planes.");
  }
  PlanarFrame frame;
  frame.Normal = (1 / length) * normal;
  for (int a = 0; a < 3; ++a)
  {
    if (std::abs(frame.Normal[a]) == 1)
    {
      // PlanarFrame promises coordinate axes here.
      frame.U = { 0, 0, 0 };
      frame.U[(a + 1) % 3] = 1;
      frame.V = Cross(frame.Normal, frame.U);
      return frame;
    }
  }
  int least = 0;
  for (int a = 1; a < 3; ++a)
  {
    least = std::abs(frame.Normal[a]) < std::abs(frame.Normal[least]) ? a : least;
  }
  Vector3 axis{ 0, 0, 0 };
  axis[least] = 1;
  const Vector3 u = Cross(axis, frame.Normal);
  frame.U = (1 / Norm(u)) * u;
  frame.V = Cross(frame.Normal, frame.U);
  return frame;
}

std::vector<TracePlane> ParallelPlanes(
  const Vector3& normal, double from, double to, double spacing)
{
  if (!(spacing > 0) || !std::isfinite(spacing) || !std::isfinite(from) || !(from <= to) ||
    !std::isfinite(to))
  {
    throw Error(
      "The planes need a positive spacing and a range from a smaller to a larger offset.");
  }
  const double count = std::floor((to - from) / spacing * (1 + 1e-12)) + 1;
  if (count > 1e6)
  {
    throw Error("The spacing would make more than a million planes: choose a larger one.");
  }
  std::vector<TracePlane> planes;
  const PlanarFrame frame = FrameAbout(normal);
  for (int i = 0; i < static_cast<int>(count); ++i)
  {
    planes.push_back({ frame, from + i * spacing });
  }
  return planes;
}

std::vector<TracePlane> ParallelPlanesThrough(const std::vector<Point3>& seeds,
  const Vector3& normal, const std::optional<std::array<double, 2>>& range, double spacing)
{
  const PlanarFrame frame = FrameAbout(normal);
  double from = std::numeric_limits<double>::infinity();
  double to = -from;
  for (const Point3& seed : seeds)
  {
    from = std::min(from, frame.OffsetOf(seed));
    to = std::max(to, frame.OffsetOf(seed));
  }
  if (range)
  {
    from = (*range)[0];
    to = (*range)[1];
  }
  return ParallelPlanes(
    normal, from, to, spacing == 0 ? (to - from) / AutomaticIntervals : spacing);
}

std::vector<TracePlane> OnlyPlanesWithin(const std::vector<TracePlane>& planes,
  const std::vector<Point3>& drawn, std::optional<double> tolerance,
  std::vector<std::string>& report)
{
  std::vector<double> gaps;
  for (std::size_t p = 1; p < planes.size(); ++p)
  {
    gaps.push_back(std::abs(planes[p].Offset - planes[p - 1].Offset));
  }
  std::vector<TracePlane> within =
    PlanesWithin(planes, drawn, tolerance ? *tolerance : BesideContours * Median(std::move(gaps)));
  if (within.empty() && !planes.empty())
  {
    throw Error("No plane of " + std::to_string(planes.size()) +
      " lies between the outermost contour points: are they of the same patient, in the same frame "
      "of reference? Extrapolate traces beyond the contours as well.");
  }
  const std::size_t beyond = planes.size() - within.size();
  if (beyond > 0)
  {
    report.push_back("Planes beyond the outermost contour points, where nothing was drawn, were "
                     "left out: " +
      std::to_string(beyond) + " of " + std::to_string(planes.size()) +
      " (Extrapolate traces them, too).");
  }
  return within;
}

std::vector<TracePlane> PlanesOf(const ContourSet& contours)
{
  std::vector<TracePlane> planes;
  for (const Level& level : contours.Levels)
  {
    planes.push_back({ level.Frame, level.Offset });
  }
  return planes;
}
}
