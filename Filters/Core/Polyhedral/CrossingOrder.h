// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CrossingOrder.h
 * @brief T12 nodes in the order in which they lie on the Voronoi edges of either level.
 */
#ifndef recon_CrossingOrder_h
#define recon_CrossingOrder_h

#include "Polyhedral/VoronoiSections.h"

#include <vector>

namespace recon
{
class CrossingOrder
{
public:
  /// Crossings may come several times. The cells must outlive this.
  CrossingOrder(const JointCells& cells, std::vector<JointCrossing> crossings);

  /// By edge of level 1, then along it; each once.
  const std::vector<JointCrossing>& Crossings() const { return this->Sorted; }

  /// Numbers of the crossings on an edge of the level, in their order, from the triangle after
  /// which the edge is numbered.
  const int* Begin(int level, int edge) const;
  const int* End(int level, int edge) const;

  /// The last crossing of the edge that comes before this one, which lies on it, or -1.
  int Before(int level, int edge, const JointCrossing& crossing) const;

  /// The cells of the other level between which a path that runs forth goes there.
  static std::array<int, 2> CellsAt(const VoronoiPath& path, const JointCrossing& crossing);

private:
  bool IsBefore(const VoronoiPath& path, const JointCrossing& p, const JointCrossing& q) const;
  std::vector<int> SortAlong(int level);

  const JointCells& Cells;
  std::vector<JointCrossing> Sorted;
  std::array<std::vector<int>, 2> First; ///< by level, of every edge the place in Numbers
  std::array<std::vector<int>, 2> Numbers;
};
}

#endif
