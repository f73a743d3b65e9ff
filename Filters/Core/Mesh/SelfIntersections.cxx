// SPDX-License-Identifier: GPL-3.0-or-later
#include "SelfIntersections.h"

#include "../Parallel.h"
#include "MeshDefects.h"
#include "MeshTopology.h"
#include "TrianglePair.h"
#include "TriangleTree.h"

#include <algorithm>

namespace recon
{
namespace
{
/// Leaves of the tree that one piece of parallel work looks at.
constexpr int LeavesAPiece = 256;

/// What one piece of work found; pieces are put together in order.
struct Piece
{
  std::int64_t Count[3] = { 0, 0, 0 };
  std::vector<IntersectingPair> Pairs;
  std::vector<std::pair<int, int>> Marks; ///< triangle and defect
};

int DefectOf(IntersectingPair::KindType kind)
{
  switch (kind)
  {
    case IntersectingPair::Crossing:
      return DefectCrossing;
    case IntersectingPair::Overlapping:
      return DefectOverlapping;
    case IntersectingPair::Touching:
      break;
  }
  return DefectTouching;
}

void Examine(const TriangleMesh& mesh, int s, int t, std::int64_t limit, Piece& piece)
{
  const PairRelation relation = RelateTriangles(mesh, s, t);
  if (relation == PairRelation::Clean)
  {
    return;
  }
  const auto kind = relation == PairRelation::Crossing ? IntersectingPair::Crossing
    : relation == PairRelation::Overlapping            ? IntersectingPair::Overlapping
                                                       : IntersectingPair::Touching;
  ++piece.Count[kind];
  if (static_cast<std::int64_t>(piece.Pairs.size()) < limit)
  {
    piece.Pairs.push_back({ std::min(s, t), std::max(s, t), kind });
  }
  piece.Marks.emplace_back(s, DefectOf(kind));
  piece.Marks.emplace_back(t, DefectOf(kind));
}

/// Keep one mark of a triangle and kind: thousands of crossings of one large triangle are one mark.
void Shrink(std::vector<std::pair<int, int>>& marks)
{
  std::sort(marks.begin(), marks.end());
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
}

SelfIntersections Gather(const std::vector<Piece>& pieces, std::size_t triangles)
{
  SelfIntersections result;
  result.DefectOfTriangle.assign(triangles, 0);
  for (const auto& piece : pieces)
  {
    result.Touching += piece.Count[IntersectingPair::Touching];
    result.Overlapping += piece.Count[IntersectingPair::Overlapping];
    result.Crossing += piece.Count[IntersectingPair::Crossing];
    result.Pairs.insert(result.Pairs.end(), piece.Pairs.begin(), piece.Pairs.end());
    for (const auto& [triangle, defect] : piece.Marks)
    {
      result.DefectOfTriangle[triangle] |= defect;
    }
  }
  std::sort(result.Pairs.begin(), result.Pairs.end(),
    [](const IntersectingPair& a, const IntersectingPair& b)
    { return a.First != b.First ? a.First < b.First : a.Second < b.Second; });
  result.Complete = static_cast<std::int64_t>(result.Pairs.size()) ==
    result.Touching + result.Overlapping + result.Crossing;
  return result;
}
}

SelfIntersections FindSelfIntersections(
  const TriangleMesh& mesh, const SelfIntersectionOptions& options, Monitor& monitor)
{
  constexpr const char* stage = "looking for self-intersections";
  RequireUsable(mesh);
  monitor.Update(0, stage);
  const TriangleTree tree(mesh);
  const int count = (tree.GetNumberOfLeaves() + LeavesAPiece - 1) / LeavesAPiece;
  std::vector<Piece> pieces(count);
  const auto work = [&](int p)
  {
    const int end = std::min(tree.GetNumberOfLeaves(), (p + 1) * LeavesAPiece);
    for (int leaf = p * LeavesAPiece; leaf < end; ++leaf)
    {
      tree.VisitPairsOfLeaf(
        leaf, [&](int s, int t) { Examine(mesh, s, t, options.MaximumPairsAPiece, pieces[p]); });
      Shrink(pieces[p].Marks);
    }
  };
  ParallelFor(count, options.Threads, work, monitor, { 0.1, 1, stage });
  return Gather(pieces, mesh.Triangles.size());
}

SelfIntersections FindSelfIntersections(const TriangleMesh& mesh, Monitor& monitor)
{
  return FindSelfIntersections(mesh, SelfIntersectionOptions(), monitor);
}
}
