// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MaterialWalker.h
 * @brief The boundary of each material in one plane of a curve network.
 */
#ifndef recon_MaterialWalker_h
#define recon_MaterialWalker_h

#include "Planar/BorderWalks.h"

#include <vector>

namespace recon
{
/// An edge with the materials on its sides, seen from the tip of the plane's normal.
struct NetworkEdge
{
  int From = 0;
  int To = 0;
  int Left = 0;
  int Right = 0;
};

class MaterialWalker
{
public:
  /// @param normal of unit length
  /// @param edges none from a vertex to itself, none with one material on both sides
  MaterialWalker(const Vector3& normal, const std::vector<Point3>& vertices,
    const std::vector<NetworkEdge>& edges);

  /**
   * Material 0 is what reaches to infinity. Looks at the vertex farthest to one side, where the
   * wedge that opens to infinity is known: where that wedge has a material and the edge's other
   * side has 0, all edges' sides are swapped.
   *
   * @return whether they were
   */
  bool SwapSidesWhereZeroIsInside();

  /// All but 0, increasing.
  std::vector<int> GetMaterials() const;

  /// The boundary of a material, with the material to the left.
  std::vector<BorderWalk> Walk(int material) const;

private:
  std::vector<Point2> Planar;
  std::vector<NetworkEdge> Edges;
};
}

#endif
