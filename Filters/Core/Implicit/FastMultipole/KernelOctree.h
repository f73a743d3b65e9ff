// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file KernelOctree.h
 * @brief Points sorted into the cubes of an adaptive octree, level by level.
 */
#ifndef recon_KernelOctree_h
#define recon_KernelOctree_h

#include "Base/Geometry.h"

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace recon
{
/// The cube of level 0: x -> (x - Low) / Size. Size is a power of two, so scaling does not round.
struct RootCube
{
  Point3 Low{ 0, 0, 0 };
  double Size = 1;

  /// Around the points, with at least a quarter of their extent on every side.
  static RootCube Around(const std::vector<Point3>& points);
  Point3 ToUnit(const Point3& x) const { return (1 / this->Size) * (x - this->Low); }
  bool Contains(const Point3& x) const;
};

/// A cube; its points are a run in the order of the tree.
struct OctreeBox
{
  int Level = 0;
  std::array<std::int32_t, 3> Cell{}; ///< in cubes of this level
  std::int32_t From = 0;
  std::int32_t To = 0;
  std::int32_t Parent = -1;
  std::int32_t FirstChild = -1;
  std::int32_t Children = 0;

  std::int32_t Count() const { return this->To - this->From; }
  bool IsLeaf() const { return this->Children == 0; }
};

/**
 * @class KernelOctree
 * @brief Boxes are stored by level, those of one level along a Morton curve.
 */
class KernelOctree
{
public:
  /// Boxes smaller than Size / 2^DeepestLevel are not split.
  static constexpr int DeepestLevel = 20;

  /// No points: splitting a box makes all its eight children.
  KernelOctree();
  /// @param points all in the cube. Only boxes with points are kept.
  KernelOctree(const std::vector<Point3>& points, const RootCube& cube);

  /// Splits those boxes of the last level for which that is true; false where there is none.
  bool SplitLastLevel(const std::function<bool(int)>& wanted);

  int Levels() const { return static_cast<int>(this->LevelStart.size()) - 1; }
  int LevelBegin(int level) const { return this->LevelStart[level]; }
  int LevelEnd(int level) const { return this->LevelStart[level + 1]; }
  const std::vector<OctreeBox>& Boxes() const { return this->Nodes; }
  /// Coordinates in the unit cube, in the order of the tree.
  const std::vector<Point3>& Points() const { return this->Sorted; }
  /// The number, as given, of the i-th point in the order of the tree.
  const std::vector<std::int32_t>& Numbers() const { return this->Order; }
  /// The leaf around a place in the unit cube, in a tree without points.
  std::int32_t LeafAround(const Point3& unit) const;
  static Point3 CentreOf(const OctreeBox& box);
  /// Half an edge, in the unit cube.
  static double HalfWidthOf(int level);

private:
  void AppendChildren(std::int32_t box);
  void AppendAllChildren(std::int32_t box);

  bool OfPoints;
  std::vector<std::uint64_t> Keys;
  std::vector<std::int32_t> Order;
  std::vector<Point3> Sorted;
  std::vector<OctreeBox> Nodes;
  std::vector<int> LevelStart;
};
}

#endif
