// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BorderWalks.h
 * @brief Walks around a region of a plane, along directed edges that have it on their left.
 */
#ifndef recon_BorderWalks_h
#define recon_BorderWalks_h

#include "Base/Geometry.h"

#include <map>
#include <vector>

namespace recon
{
struct BorderWalk
{
  std::vector<int> Points; ///< the first is not repeated
  bool Closed = false;
};

/**
 * @class BorderWalks
 * @brief Every edge is walked once; exact.
 *
 * At a point where several walks meet, each goes on along the same corner of the region, so walks
 * touch and do not cross; one may pass a point more than once. LoopTracing.h makes simple loops.
 * Edges need not close: walks that cannot come first, from points that more edges leave than reach.
 */
class BorderWalks
{
public:
  explicit BorderWalks(const std::vector<Point2>& points) : Points(points) {}

  void Add(int from, int to);

  /// Open walks by where they begin, then closed ones by the first of their edges that was added.
  std::vector<BorderWalk> Walk();

private:
  struct HalfEdge
  {
    int From;
    int To;
    bool Used;
  };

  BorderWalk WalkFrom(int first, bool isOpen);
  int NextAfter(const HalfEdge& last, int first) const;
  const Point2& At(int point) const { return this->Points[point]; }

  const std::vector<Point2>& Points;
  std::vector<HalfEdge> Edges;
  std::map<int, std::vector<int>> Outgoing; ///< edges by the point that they leave
  std::map<int, int> Balance;               ///< edges that leave a point, less those that reach it
};
}

#endif
