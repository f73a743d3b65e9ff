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

class LevelSearch : public VertexSearch
{
public:
  /// The level must outlive the search.
  explicit LevelSearch(const LevelTriangulation& level);

  /// The interval in which a contour edge is nearer to the line than that, beginning first of all
  /// that reach into the line; none where no edge does.
  std::optional<LineInterval> FirstContour(const PlanarLine& line, double tolerance) const;

private:
  std::optional<LineInterval> Near(int edge, const PlanarLine& line, double tolerance) const;

  std::vector<std::array<int, 2>> Edges; ///< of contours: points
  BoxTree Contours;
};
}

#endif
