// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Arrangement.h
 * @brief Edges of a plane, snapped together where they nearly meet and split where they cross.
 */
#ifndef recon_Arrangement_h
#define recon_Arrangement_h

#include "Base/DisjointSets.h"
#include "Planar/EdgeConflicts.h"

#include <cstddef>
#include <map>
#include <vector>

namespace recon
{
/// Into how many pieces so many edges may fall, and how often they may cross.
std::size_t MostPiecesOf(std::size_t edges);

/**
 * @class Arrangement
 * @brief Tagged edges that in the end meet in common end points only.
 *
 * Iterated snap rounding, on the points as they are instead of on a grid, so that what was in order
 * keeps every bit: of points nearer than the tolerance the first stands for the others, edges that
 * pass a point within the tolerance go through it, and crossings (computed exactly, rounded once)
 * become points. Whatever that disturbs is found and snapped again. At rest no point lies within
 * the tolerance of another, or of an edge that it is no end of: there is no sliver left for a later
 * stage.
 *
 * Each pass is bounded, and so is their number: where they do not come to rest, the tolerance grows
 * tenfold, four times at most.
 */
class Arrangement
{
public:
  /// What edges with the same two ends amount to.
  enum class SumType
  {
    Parity, ///< an odd number of them to one, an even number to none
    Weight  ///< to the sum of their weights
  };
  /// What was the matter with the edges of a tag.
  struct Findings
  {
    std::size_t Crossings = 0;
    std::size_t OnEdge = 0;    ///< points found in, or within the tolerance of, another edge
    std::size_t Cancelled = 0; ///< edges with the same two ends
    std::size_t Merged = 0;    ///< points for which another stands
    double Moved = 0;          ///< the farthest that a merged point was from the one that stands
  };

  /**
   * @param points with distinct coordinates; crossings are appended
   * @param tolerances a number for every tag; the smaller counts between two
   */
  Arrangement(std::vector<Point2>& points, std::vector<PlanarEdge> edges,
    std::vector<double> tolerances, SumType sum);

  /// @throws Error where edges cross too often, or do not come to rest
  void Resolve();

  const std::vector<PlanarEdge>& Edges() const { return this->All; }
  /// Leaves the others out.
  void Keep(const std::vector<bool>& kept);

  /// Tags that have something to do with one another have one set.
  int SetOf(int tag) { return this->Sets.Find(tag); }
  bool HasConflict(int tag) const { return this->InConflict[static_cast<std::size_t>(tag)]; }
  const Findings& FindingsOf(int tag) const { return this->Found[static_cast<std::size_t>(tag)]; }
  /// As large as it had to grow.
  double ToleranceOf(int tag) const { return this->Tolerances[static_cast<std::size_t>(tag)]; }
  void Join(int tag, int other);

private:
  bool ResolveWithin(int passes);
  void Unsettle();
  void SumEqual();
  void Merge(std::vector<EdgeConflicts::Twins> twins);
  void MoveEnds(const std::vector<int>& standIn);
  void Split(const EdgeConflicts& conflicts);
  void AddTouches(const EdgeConflicts& conflicts, std::vector<std::vector<int>>& inner);
  void AddCrossings(const EdgeConflicts& conflicts, std::vector<std::vector<int>>& inner);
  void SplitEdge(const PlanarEdge& e, std::vector<int>& inner, std::vector<PlanarEdge>& out) const;
  int PointAt(const Point2& p);
  const Point2& At(int p) const { return this->Points[static_cast<std::size_t>(p)]; }
  Findings& FoundAt(int edge);

  std::vector<Point2>& Points;
  std::vector<PlanarEdge> All;
  std::vector<double> Tolerances;
  SumType Sum;
  std::size_t MostEdges;
  DisjointSets Sets;
  std::vector<bool> InConflict;
  std::vector<Findings> Found;
  std::map<Point2, int> Known; ///< points by coordinates, filled with the first crossing
};
}

#endif
