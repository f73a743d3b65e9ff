// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file PolyhedralShapes.h
 * @brief Contours that are hard for the polyhedral method, and triangulations made by hand.
 *
 * All coordinates are planar; stacks have their levels at whole heights unless they say otherwise.
 */
#ifndef recon_Testing_PolyhedralShapes_h
#define recon_Testing_PolyhedralShapes_h

#include "Core/Contours/SoupMaker.h"
#include "Polyhedral/LevelTriangulation.h"
#include "Polyhedral/PolyhedralSurface.h"
#include "Polyhedral/VoronoiSkeleton.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

namespace recon::testing
{
using Ring = std::vector<Point2>;

constexpr double FullTurn = 2 * 3.14159265358979323846;

/// The contours of each level, at heights 0, 1, 2, ...
using RingStack = std::vector<std::vector<Ring>>;

inline ContourSet BuildStack(const RingStack& levels, double spacing = 1)
{
  SoupMaker maker;
  for (std::size_t l = 0; l < levels.size(); ++l)
  {
    for (const Ring& ring : levels[l])
    {
      maker.Loop(ring, spacing * static_cast<double>(l));
    }
  }
  return maker.Build();
}

/// Counterclockwise; the first corner at angle `phase`.
inline Ring RegularPolygon(
  int count, double radius, double phase = 0, const Point2& middle = { 0, 0 })
{
  Ring ring;
  for (int i = 0; i < count; ++i)
  {
    const double angle = phase + FullTurn * i / count;
    ring.push_back({ middle[0] + radius * std::cos(angle), middle[1] + radius * std::sin(angle) });
  }
  return ring;
}

/// Needles that leave a small core: angles of some degrees at every tip and between them.
inline Ring Needles(int count, double length, double core)
{
  Ring ring;
  for (int i = 0; i < 2 * count; ++i)
  {
    const double r = i % 2 == 0 ? length : core;
    const double angle = FullTurn * i / (2 * count);
    ring.push_back({ r * std::cos(angle), r * std::sin(angle) });
  }
  return ring;
}

/// One sliver of a spike, `width` wide at its foot, that leaves a square.
inline Ring SpikedSquare(double length, double width)
{
  return { { -1, -1 }, { 1, -1 }, { 1, -width / 2 }, { 1 + length, 0 }, { 1, width / 2 }, { 1, 1 },
    { -1, 1 } };
}

/// The outline of a disc of pixels with all its corners, edges of `step` along x and y, moved by
/// `shift`.
inline Ring PixelDisc(int radius, double step, const Point2& shift = { 0, 0 })
{
  // Half the widths of the rows above the middle; the outline is symmetric to both axes.
  std::vector<int> width;
  for (int row = 0; row < radius; ++row)
  {
    const double y = row + 0.5;
    width.push_back(static_cast<int>(std::floor(std::sqrt(radius * radius - y * y) + 0.5)));
  }
  Ring quarter; // from (width, 0) to (0, radius), every pixel's corner
  int x = width[0];
  for (int row = 0; row < radius; ++row)
  {
    quarter.push_back({ static_cast<double>(x), static_cast<double>(row) });
    const int next = row + 1 < radius ? width[row + 1] : 0;
    for (; x > next; --x)
    {
      quarter.push_back({ static_cast<double>(x), static_cast<double>(row + 1) });
    }
  }
  Ring ring;
  for (int turn = 0; turn < 4; ++turn)
  {
    for (const Point2& p : quarter)
    {
      const Point2 q = turn == 0 ? p
        : turn == 1              ? Point2{ -p[1], p[0] }
        : turn == 2              ? Point2{ -p[0], -p[1] }
                                 : Point2{ p[1], -p[0] };
      ring.push_back({ step * q[0] + shift[0], step * q[1] + shift[1] });
    }
  }
  return ring;
}

/// Radii drawn at random around `middle`, so it is simple whatever is drawn.
inline Ring RandomStar(
  int count, const Point2& middle, double least, double largest, std::mt19937& random)
{
  std::uniform_real_distribution<double> radius(least, largest);
  Ring ring;
  for (int i = 0; i < count; ++i)
  {
    const double r = radius(random);
    const double angle = FullTurn * i / count;
    ring.push_back({ middle[0] + r * std::cos(angle), middle[1] + r * std::sin(angle) });
  }
  return ring;
}

/**
 * Levels of random stars on a grid of places: some places stay empty, stars have holes, holes have
 * islands, and from level to level all of it comes and goes.
 *
 * Coordinates are random doubles, or where `onGrid` whole numbers, so that many points are
 * cocircular and repeat from level to level.
 */
inline RingStack RandomStack(unsigned seed)
{
  std::mt19937 random(seed);
  const auto draw = [&](int from, int to)
  { return std::uniform_int_distribution<int>(from, to)(random); };
  const int places = draw(1, 3);
  const int levels = draw(2, 5);
  const bool onGrid = draw(0, 3) == 0;
  const double scale = onGrid ? 8 : 1;
  RingStack stack;
  for (int l = 0; l < levels; ++l)
  {
    std::vector<Ring> rings;
    for (int place = 0; place < places * places; ++place)
    {
      if (draw(0, 3) == 0)
      {
        continue;
      }
      const Point2 middle{ 2.1 * (place % places), 2.1 * (place / places) };
      double outer = 1, inner = 0.6;
      for (int depth = draw(1, 3); depth > 0; --depth)
      {
        rings.push_back(RandomStar(draw(3, 24), middle, inner * 1.02, outer, random));
        // The innermost a ring of n corners reaches is inner * cos(half its angle); be below it.
        outer = 0.5 * inner;
        inner = 0.6 * outer;
      }
    }
    if (rings.empty())
    {
      rings.push_back(RandomStar(12, { 0, 0 }, 0.6, 1, random));
    }
    stack.push_back(rings);
  }
  for (auto& rings : stack)
  {
    for (Ring& ring : rings)
    {
      for (Point2& p : ring)
      {
        p = { scale * p[0], scale * p[1] };
        p = onGrid ? Point2{ std::round(p[0]), std::round(p[1]) } : p;
      }
    }
  }
  return stack;
}

/// What the pipeline does with levels before it joins them, step by step.
inline std::vector<LevelTriangulation> TriangulateLevels(
  const ContourSet& contours, bool internalPoints)
{
  const int count = static_cast<int>(contours.Levels.size());
  std::vector<LevelTriangulator> triangulators;
  std::vector<std::vector<Point2>> skeletons;
  for (int l = 0; l < count; ++l)
  {
    triangulators.emplace_back(contours, l);
    skeletons.push_back(ExternalSkeletonVertices(triangulators.back().Finish(), 0));
  }
  std::vector<LevelTriangulation> levels;
  for (int l = 0; l < count; ++l)
  {
    if (internalPoints && l > 0)
    {
      triangulators[l].AddInternalPoints(skeletons[l - 1], LevelTriangulation::LevelBelow);
    }
    if (internalPoints && l + 1 < count)
    {
      triangulators[l].AddInternalPoints(skeletons[l + 1], LevelTriangulation::LevelAbove);
    }
    levels.push_back(triangulators[l].Finish());
  }
  return levels;
}

/// The Delaunay triangulation of bare points, all of it inside, without contours.
inline LevelTriangulation TriangulatePoints(const Ring& points)
{
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
  using Face = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
  CGAL::Delaunay_triangulation_2<Kernel, Structure> delaunay;
  LevelTriangulation level;
  for (const Point2& p : points)
  {
    delaunay.insert(Kernel::Point_2(p[0], p[1]))->info() = static_cast<int>(level.Points.size());
    level.Points.push_back(p);
  }
  level.Source.assign(points.size(), -1);
  level.Kind.assign(points.size(), LevelTriangulation::InputVertex);
  level.AskedBy.assign(points.size(), 0);
  level.StarTriangle.assign(points.size(), -1);
  for (auto f : delaunay.all_face_handles())
  {
    f->info() = -1;
  }
  int next = 0;
  for (auto f : delaunay.finite_face_handles())
  {
    f->info() = next++;
  }
  for (auto f : delaunay.finite_face_handles())
  {
    std::array<int, 3> corners{}, neighbours{};
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = f->vertex(k)->info();
      neighbours[k] = f->neighbor(k)->info();
      level.StarTriangle[corners[k]] = f->info();
    }
    level.Triangles.push_back(corners);
    level.Neighbours.push_back(neighbours);
    level.EdgeContour.push_back({ { -1, -1, -1 } });
    level.Inside.push_back(1);
  }
  return level;
}
}

#endif
