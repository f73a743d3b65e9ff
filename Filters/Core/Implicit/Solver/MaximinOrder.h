// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file MaximinOrder.h
 * @brief Points from coarse to fine, each the farthest from all before it, and who of them is near
 * whom.
 *
 * Notation (Schaefer, Katzfuss, Owhadi 2021, section 3.1):
 *   rank     place of a point in the order
 *   l_i      distance of point i to the nearest point of lower rank, when its turn came
 */
#ifndef recon_MaximinOrder_h
#define recon_MaximinOrder_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace recon
{
/**
 * @class MaximinOrder
 * @brief A k-d tree that hands out its points farthest first, and finds the nearest of low rank.
 *
 * The first four points span a tetrahedron that is as fat as greed finds it: four in one plane,
 * usual among contours, would leave the linear polynomials undetermined on the coarsest level.
 * O(n log n) for points on surfaces; the order depends on the points alone.
 */
class MaximinOrder
{
public:
  /// Simplex: how many points the fat start has.
  static constexpr int Simplex = 4;

  /// @param points at least four, finite, not all in one plane; copied.
  MaximinOrder(const std::vector<Point3>& points, Monitor& monitor);

  /// Indices of the points given, by rank.
  const std::vector<int>& Order() const { return this->ByRank; }
  /// l_i by rank, not increasing from the fifth on.
  const std::vector<double>& Distances() const { return this->DistanceByRank; }
  /// The points by rank.
  const std::vector<Point3>& Points() const { return this->PointsByRank; }

  /// The ranks of the `count` points of rank below `below` that are nearest to x (fewer where there
  /// are no more), in increasing order of rank.
  std::vector<int> Nearest(const Point3& x, int below, int count) const;

private:
  struct Node
  {
    Point3 Low;
    Point3 High;
    int Begin; ///< its points in tree order
    int End;
    int Left;         ///< its first child, the second is the next; -1: a leaf
    double Farthest2; ///< largest squared distance of its points to those ranked, -1: none is left
    int LeastRank;
  };

  /// Squared distance and rank.
  using Found = std::pair<double, int>;

  /// The nearest found so far, a heap with the farthest in front.
  struct Query
  {
    Point3 At;
    int Below;
    std::size_t Count;
    std::vector<Found> Best;

    double Reach() const
    {
      return this->Best.size() < this->Count ? std::numeric_limits<double>::infinity()
                                             : this->Best.front().first;
    }
    void Offer(const Found& found)
    {
      if (this->Best.size() == this->Count)
      {
        if (!(found < this->Best.front()))
        {
          return;
        }
        std::pop_heap(this->Best.begin(), this->Best.end());
        this->Best.pop_back();
      }
      this->Best.push_back(found);
      std::push_heap(this->Best.begin(), this->Best.end());
    }
  };

  void Search(int node, Query& query) const;
  void Build(const std::vector<Point3>& points);
  void Split(int node);
  void RankStart();
  void RankRest(Monitor& monitor);
  void Rank(int at, double distance2);
  void Approach(int node, const Point3& to);
  int FarthestLeft() const;
  int FarthestFrom(const Point3& from, const std::vector<Vector3>& known) const;
  void FindLeastRanks();

  std::vector<Point3> InTree; ///< points in tree order
  std::vector<int> Input;     ///< their indices in the input
  std::vector<double> Distance2;
  std::vector<int> RankOf; ///< of points in tree order
  std::vector<Node> Nodes;

  std::vector<int> ByRank;
  std::vector<double> DistanceByRank;
  std::vector<Point3> PointsByRank;
};
}

#endif
