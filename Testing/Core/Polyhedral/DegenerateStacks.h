// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DegenerateStacks.h
 * @brief Random small stacks of nearly degenerate polygons, through the whole method with every
 * combination of its options.
 *
 * Three to six levels of one to four triangles and quadrilaterals on a coarse grid and beside it:
 * coordinates like .1 + .2, corners nearly or exactly in line, slivers, levels very near to each
 * other or very far apart for their size, outlines that repeat from level to level.
 *
 * The same stacks turned out of the axes have coordinates that round, and must hold the same promises.
 *
 * A failure names its seed; CONTOUR_STACK_SEED=<seed> or <first>-<last> in the environment runs those
 * instead.
 */
#ifndef recon_Testing_DegenerateStacks_h
#define recon_Testing_DegenerateStacks_h

#include "Core/Contours/SoupMaker.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/SheetCrossings.h"
#include "PolyhedralShapes.h"
#include "SurfaceInvariants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace recon::testing
{
class DegenerateStack
{
public:
  SoupMaker Maker;

  explicit DegenerateStack(unsigned seed) : Random(seed)
  {
    this->Style = this->Draw(0, 4);
    const int count = this->Draw(3, 6);
    const double thickness = this->OneOf({ 1, 1, 0.1, 1e-3, 5e-5, 30 });
    double height = this->OneOf({ 0, 0, 0.0005, -250.25 });
    std::vector<Ring> rings;
    for (int l = 0; l < count; ++l)
    {
      rings = this->DrawRings(rings);
      for (const Ring& ring : rings)
      {
        this->Maker.Loop(ring, height);
      }
      height += thickness * this->OneOf({ 1, 1, 1, 0.5, 2, 20 });
    }
  }

private:
  int Draw(int from, int to) { return std::uniform_int_distribution<int>(from, to)(this->Random); }

  double OneOf(const std::vector<double>& values)
  {
    return values[this->Draw(0, static_cast<int>(values.size()) - 1)];
  }

  /// Whole numbers, tenths, hundredths, sums of tenths (.1 + .2 is not .3), or numbers beside those.
  double Coordinate()
  {
    switch (this->Style)
    {
      case 0:
        return this->Draw(-3, 3);
      case 1:
        return this->Draw(0, 5) * 0.1;
      case 2:
        return this->Draw(0, 3) * 0.1 + this->Draw(0, 3) * 0.1;
      case 3:
        return this->Draw(-3, 3) + this->OneOf({ 0, 0, 0, 0.1, 0.02, 1e-3, 1e-6, 1e-9, 1e-12 });
      default:
        return this->Draw(0, 6) * this->OneOf({ 1, 0.5, 0.1, 1.0 / 3 });
    }
  }

  Ring DrawRing()
  {
    Ring ring;
    const int count = this->Draw(3, 5);
    for (int i = 0; i < count; ++i)
    {
      ring.push_back({ this->Coordinate(), this->Coordinate() });
    }
    if (this->Draw(0, 3) == 0)
    {
      // A corner in line with the two before it, up to rounding.
      const double t = this->OneOf({ 0.5, 0.1, 0.3, 2 });
      const Point2 &a = ring[0], &b = ring[1];
      ring[2] = { a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) };
      ring[2][this->Draw(0, 1)] += this->OneOf({ 0, 0, 1e-15, 1e-12, 1e-9, 1e-4, 0.05 });
    }
    return ring;
  }

  std::vector<Ring> DrawRings(const std::vector<Ring>& previous)
  {
    if (!previous.empty() && this->Draw(0, 4) == 0)
    {
      return previous;
    }
    std::vector<Ring> rings;
    for (int i = this->Draw(1, 4); i > 0; --i)
    {
      rings.push_back(this->DrawRing());
    }
    return rings;
  }

  std::mt19937 Random;
  int Style = 0;
};

/// The stack turned about an axis through the origin that is none of the coordinate axes.
inline SoupMaker Tilted(SoupMaker stack, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> part;
  const std::array<double, 4> drawn{ part(random), part(random), part(random), part(random) };
  const double length = std::hypot(std::hypot(drawn[0], drawn[1]), std::hypot(drawn[2], drawn[3]));
  const double w = drawn[0] / length;
  const Vector3 axis = (1 / length) * Vector3{ drawn[1], drawn[2], drawn[3] };
  for (Point3& p : stack.Soup.Points)
  {
    // By the unit quaternion of real part w and imaginary part axis.
    const Vector3 twice = 2.0 * Cross(axis, p);
    p = p + (w * twice + Cross(axis, twice));
  }
  return stack;
}

inline std::vector<PolyhedralOptions> EveryCombination()
{
  std::vector<PolyhedralOptions> all;
  for (const auto mapping : { PolyhedralOptions::Proximity, PolyhedralOptions::Overlap })
  {
    for (const auto caps : { PolyhedralOptions::Flat, PolyhedralOptions::HalfSlice,
           PolyhedralOptions::Tapered, PolyhedralOptions::Extrapolated, PolyhedralOptions::NoCaps })
    {
      for (const auto isolated : { PolyhedralOptions::Drop, PolyhedralOptions::Extrude })
      {
        PolyhedralOptions options;
        options.Mapping = mapping;
        options.EndCaps = caps;
        options.IsolatedContours = isolated;
        options.Threads = 1;
        all.push_back(options);
      }
    }
  }
  return all;
}

/// Crossings and overlaps of triangles and of sheets in words; empty where there are none.
inline std::string IntersectionsOf(const TriangleMesh& mesh)
{
  Monitor monitor;
  SelfIntersectionOptions one;
  one.Threads = 1;
  const SelfIntersections found = FindSelfIntersections(mesh, one, monitor);
  const int sheets = FindSheetCrossings(mesh).Edges;
  return (found.Crossing > 0 ? std::to_string(found.Crossing) + " crossing " : "") +
    (found.Overlapping > 0 ? std::to_string(found.Overlapping) + " overlapping " : "") +
    (sheets > 0 ? std::to_string(sheets) + " edges where sheets cross " : "");
}

/// The promises that a surface breaks but for crossings and overlaps, a word each; empty where it
/// holds all.
inline std::string BrokenPromises(
  const PolyhedralSurface& surface, const ContourSet& contours, const PolyhedralOptions& options)
{
  std::ostringstream broken;
  const LeftOut leftOut = ContoursLeftOut(surface);
  if (leftOut.Wholly.size() == contours.Contours.size())
  {
    return surface.Mesh.Triangles.empty() ? "" : "not empty";
  }
  const MeshTopology topology = CheckTopology(surface.Mesh);
  const bool open = options.EndCaps == PolyhedralOptions::NoCaps;
  const auto& total = topology.Total;
  broken << (open || total.Closed ? "" : "closed ") << (total.EdgeManifold ? "" : "edge-manifold ")
         << (total.VertexManifold ? "" : "vertex-manifold ")
         << (total.MisorientedEdges == 0 ? "" : "oriented ")
         << (open || total.Outward ? "" : "outward ");
  const std::set<Point3> points(surface.Mesh.Points.begin(), surface.Mesh.Points.end());
  for (std::size_t c = 0; c < contours.Contours.size() && !open; ++c)
  {
    const int number = static_cast<int>(c);
    for (int p : contours.Contours[c].Points)
    {
      if (leftOut.Wholly.count(number) + leftOut.InPart.count(number) == 0 &&
        points.count(contours.Points[p]) == 0)
      {
        broken << "vertex of contour " << c << " missing ";
      }
    }
  }
  return broken.str();
}

/// What many stacks took.
struct StackTally
{
  int Surfaces = 0;
  double Slowest = 0; ///< seconds of the processor that one took
};

/// Every combination of options on one stack; empty where all promises hold. What several of them
/// make alike is searched for crossings once, as that takes most of the time.
inline std::string BrokenPromisesOfStack(const SoupMaker& maker, StackTally& tally)
{
  ContourSet contours;
  try
  {
    contours = maker.Build();
  }
  catch (const Error&)
  {
    return ""; // of nothing that has an area no surface is wanted, and the sentence says so
  }
  std::ostringstream broken;
  if (contours.Levels.size() < 2 || contours.Contours.empty())
  {
    return "";
  }
  std::set<std::pair<std::vector<Point3>, std::vector<std::array<int, 3>>>> searched;
  for (const PolyhedralOptions& options : EveryCombination())
  {
    // Of the processor, as other tests may run beside this one.
    const std::clock_t start = std::clock();
    std::string found;
    try
    {
      const PolyhedralSurface surface = BuildSurface(contours, options);
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      ++tally.Surfaces;
      tally.Slowest = std::max(tally.Slowest, seconds);
      found = seconds > 1 ? "took " + std::to_string(seconds) + " s " : "";
      found += BrokenPromises(surface, contours, options);
      if (searched.emplace(surface.Mesh.Points, surface.Mesh.Triangles).second)
      {
        found += IntersectionsOf(surface.Mesh);
      }
    }
    catch (const std::exception& error)
    {
      found += error.what();
    }
    if (!found.empty())
    {
      broken << Describe(options) << ": " << found << "\n";
    }
  }
  return broken.str();
}

inline std::string BrokenPromisesOfStack(const SoupMaker& maker)
{
  StackTally tally;
  return BrokenPromisesOfStack(maker, tally);
}

enum class StackFrame
{
  Upright,
  Tilted
};

inline void ExpectSoundDegenerateStack(unsigned seed, StackFrame frame, StackTally& tally)
{
  const SoupMaker maker = DegenerateStack(seed).Maker;
  const bool tilted = frame == StackFrame::Tilted;
  EXPECT_EQ(BrokenPromisesOfStack(tilted ? Tilted(maker, seed) : maker, tally), "")
    << "seed " << seed << "; again: CONTOUR_STACK_SEED=" << seed
    << " ctest -R DegenerateStacks.AFew" << (tilted ? "Tilted" : "Upright");
}

inline void ExpectSoundDegenerateStack(unsigned seed, StackFrame frame = StackFrame::Upright)
{
  StackTally tally;
  ExpectSoundDegenerateStack(seed, frame, tally);
}

inline void ExpectSoundDegenerateStacks(
  unsigned first, unsigned last, StackFrame frame = StackFrame::Upright)
{
  if (const char* given = std::getenv("CONTOUR_STACK_SEED"))
  {
    char* rest = nullptr;
    first = static_cast<unsigned>(std::strtoul(given, &rest, 10));
    last = *rest == '-' ? static_cast<unsigned>(std::strtoul(rest + 1, nullptr, 10)) : first;
  }
  StackTally tally;
  for (unsigned seed = first; seed <= last; ++seed)
  {
    ExpectSoundDegenerateStack(seed, frame, tally);
  }
  std::printf(
    "[ NOTE     ] stacks %u to %u: %d surfaces, the slowest took %.2f s of the processor\n", first,
    last, tally.Surfaces, tally.Slowest);
}
}

#endif
