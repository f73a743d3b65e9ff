// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file LevelSearch.h
 * @brief Finds the vertex of a level that is nearest to a place, and the contour that a line meets.
 *
 * In floating point: whoever decides by it says how far it may err.
 */
#ifndef recon_LevelSearch_h
#define recon_LevelSearch_h

#include "Base/BoxTree.h"
#include "Polyhedral/LevelTriangulation.h"

#include <optional>

namespace recon
{
/// Origin + s Direction for s from From to To.
struct PlanarLine
{
  Point2 Origin;
  Point2 Direction;
  double From;
  double To;
};

/// Of numbers s on a line.
struct LineInterval
{
  double From;
  double To;
};

class VertexSearch
{
public:
  /// The level must outlive the search.
  explicit VertexSearch(const LevelTriangulation& level);

  int NearestVertex(const Point2& p) const;

protected:
  const LevelTriangulation& Level;

private:
  BoxTree Vertices;
};

/// How far rounding may have moved a Voronoi vertex (LevelTriangulation::VoronoiVertex) from its place, in each
/// coordinate; infinite where that cannot be told.
double VoronoiVertexError(const LevelTriangulation& level, int triangle);

class LevelSearch : public VertexSearch
{
public:
  /// The level must outlive the search.
  explicit LevelSearch(const LevelTriangulation& level);

  /// The interval in which a contour edge is nearer to the line than that, beginning first of all
  /// that reach into the line; none where no edge does.
  std::optional<LineInterval> FirstContour(const PlanarLine& line, double tolerance) const;

  /// The same of Voronoi edges of the external skeleton, the edges between which that of an external
  /// Delaunay edge lies; rounding of their ends counts as distance.
  std::optional<LineInterval> FirstExternal(const PlanarLine& line, double tolerance) const;

private:
  struct Segment
  {
    Point2 From;
    Point2 To;
    double Error; ///< how far it may be off
  };

  static std::vector<Segment> ContourEdgesOf(const LevelTriangulation& level);
  static std::vector<Segment> ExternalEdgesOf(const LevelTriangulation& level);
  static std::vector<Box2> BoxesOf(const std::vector<Segment>& segments);
  static std::optional<LineInterval> Near(
    const Segment& segment, const PlanarLine& line, double tolerance);
  static std::optional<LineInterval> First(const BoxTree& boxes,
    const std::vector<Segment>& segments, const PlanarLine& line, double tolerance);

  std::vector<Segment> Edges; ///< of contours
  BoxTree Contours;
  std::vector<Segment> Skeleton;
  BoxTree External;
};
}

#endif
