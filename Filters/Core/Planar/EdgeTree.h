// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file EdgeTree.h
 * @brief Segments of a plane in a tree of boxes, asked for sides, distances and what is near.
 */
#ifndef recon_EdgeTree_h
#define recon_EdgeTree_h

#include "Planar/PlanarSegment.h"

#include <functional>
#include <memory>
#include <vector>

namespace recon
{
/// Whether two segments have a point in common; exact.
bool Meet(const PlanarSegment& a, const PlanarSegment& b);

/// To the nearest point of a segment of some length.
double DistanceToSegment(const Point2& p, const PlanarSegment& segment);

/**
 * @class EdgeTree
 * @brief CGAL's AABB tree over segments. Any number of threads may ask.
 */
class EdgeTree
{
public:
  explicit EdgeTree(std::vector<PlanarSegment> segments);
  ~EdgeTree();
  EdgeTree(EdgeTree&& other) noexcept;
  EdgeTree& operator=(EdgeTree&& other) noexcept;

  enum SideType
  {
    Outside = -1,
    On = 0,
    Inside = 1
  };

  /// By even-odd over all segments, which form closed loops; exact.
  SideType SideOf(const Point2& p) const;

  /// To the nearest segment, but no more than reach.
  double DistanceWithin(const Point2& p, double reach) const;
  /// The same for those segments that count(number) wants.
  double DistanceWithin(const Point2& p, double reach, const std::function<bool(int)>& count) const;
  /// The same of another segment that crosses none.
  double DistanceWithin(const PlanarSegment& segment, double reach) const;

  /// To the nearest segment; there has to be one. The tree's own search, which takes many more
  /// steps in an hour, and rounds in the last bit otherwise than DistanceWithin.
  double Distance(const Point2& p) const;

  /// Calls visit(number) for every segment whose box meets that from low to high, in an order that
  /// depends on the segments only.
  void ForNear(const Point2& low, const Point2& high, const std::function<void(int)>& visit) const;

  const std::vector<PlanarSegment>& Segments() const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> Impl;
};
}

#endif
