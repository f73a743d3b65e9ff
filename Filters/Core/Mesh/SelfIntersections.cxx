// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SelfIntersections.h"

#include "Base/Parallel.h"
#include "Mesh/MeshDefects.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/TrianglePair.h"
#include "Mesh/TriangleTree.h"
#include "Mesh/VertexStars.h"

#include <algorithm>
#include <map>
#include <utility>

namespace recon
{
namespace
{
constexpr const char* Stage = "looking for self-intersections";
/// Leaves of the tree that one piece of parallel work looks at.
constexpr int LeavesAPiece = 256;
/// Triangles that one piece looks at where not all are asked for.
constexpr std::size_t TrianglesAPiece = 1024;

/// What one piece of work found; pieces are put together in order.
struct Piece
{
  PairCounts Counts;
  std::map<int, PairCounts> CountsOfComponent;
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

/// Whether triangles share a point around which all is well.
bool ShareAFlatStar(const TriangleMesh& mesh, int s, int t, const std::vector<char>& flat)
{
  const auto& one = mesh.Triangles[s];
  const auto& other = mesh.Triangles[t];
  return std::any_of(one.begin(), one.end(),
    [&](int v) { return flat[v] && (v == other[0] || v == other[1] || v == other[2]); });
}

void Examine(
  const TriangleMesh& mesh, int s, int t, const SelfIntersectionOptions& options, Piece& piece)
{
  const PairRelation relation = RelateTriangles(mesh, s, t);
  if (relation == PairRelation::Clean)
  {
    return;
  }
  const auto kind = relation == PairRelation::Crossing ? IntersectingPair::Crossing
    : relation == PairRelation::Overlapping            ? IntersectingPair::Overlapping
                                                       : IntersectingPair::Touching;
  piece.Counts.Add(kind);
  if (options.ComponentOfTriangle)
  {
    const int first = (*options.ComponentOfTriangle)[s];
    const int second = (*options.ComponentOfTriangle)[t];
    piece.CountsOfComponent[first].Add(kind);
    if (second != first)
    {
      piece.CountsOfComponent[second].Add(kind);
    }
  }
  if (static_cast<std::int64_t>(piece.Pairs.size()) < options.MaximumPairsAPiece)
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

template <typename Examiner>
std::vector<Piece> PiecesOfAll(const TriangleTree& tree, const SelfIntersectionOptions& options,
  const Examiner& examine, Monitor& monitor)
{
  const int count = (tree.GetNumberOfLeaves() + LeavesAPiece - 1) / LeavesAPiece;
  std::vector<Piece> pieces(count);
  const auto work = [&](int p)
  {
    const int end = std::min(tree.GetNumberOfLeaves(), (p + 1) * LeavesAPiece);
    for (int leaf = p * LeavesAPiece; leaf < end; ++leaf)
    {
      tree.VisitPairsOfLeaf(leaf, [&](int s, int t) { examine(s, t, pieces[p]); });
      Shrink(pieces[p].Marks);
    }
  };
  ParallelFor(count, options.Threads, work, monitor, { 0.1, 1, Stage });
  return pieces;
}

template <typename Examiner>
std::vector<Piece> PiecesOfSome(const TriangleMesh& mesh, const TriangleTree& tree,
  const SelfIntersectionOptions& options, const Examiner& examine, Monitor& monitor)
{
  const std::vector<char>& of = *options.Of;
  std::vector<int> chosen;
  for (int t = 0; t < static_cast<int>(of.size()); ++t)
  {
    if (of[t])
    {
      chosen.push_back(t);
    }
  }
  std::vector<Piece> pieces((chosen.size() + TrianglesAPiece - 1) / TrianglesAPiece);
  const auto work = [&](std::size_t from, std::size_t to)
  {
    Piece& piece = pieces[from / TrianglesAPiece];
    for (std::size_t i = from; i < to; ++i)
    {
      const int s = chosen[i];
      Box3 box;
      for (const int v : mesh.Triangles[s])
      {
        box.Add(mesh.Points[v]);
      }
      tree.VisitMeeting(box,
        [&](int t)
        {
          // Of two that are both asked for the pair comes up twice.
          if (t != s && !(of[t] && t < s))
          {
            examine(s, t, piece);
          }
        });
      Shrink(piece.Marks);
    }
  };
  ParallelForBlocks(
    chosen.size(), TrianglesAPiece, options.Threads, work, monitor, { 0.1, 1, Stage });
  return pieces;
}

SelfIntersections Gather(const std::vector<Piece>& pieces, std::size_t triangles)
{
  SelfIntersections result;
  result.DefectOfTriangle.assign(triangles, 0);
  for (const auto& piece : pieces)
  {
    result.Add(piece.Counts);
    result.Pairs.insert(result.Pairs.end(), piece.Pairs.begin(), piece.Pairs.end());
    for (const auto& [component, counts] : piece.CountsOfComponent)
    {
      if (component >= static_cast<int>(result.CountsOfComponent.size()))
      {
        result.CountsOfComponent.resize(component + 1);
      }
      if (component >= 0)
      {
        result.CountsOfComponent[component].Add(counts);
      }
    }
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
  RequireUsable(mesh);
  monitor.Update(0, Stage);
  const TriangleTree tree(mesh);
  const std::vector<char> flat = FindFlatStars(mesh, options.Threads, monitor);
  const auto examine = [&](int s, int t, Piece& piece)
  {
    if (!ShareAFlatStar(mesh, s, t, flat))
    {
      Examine(mesh, s, t, options, piece);
    }
  };
  const std::vector<Piece> pieces = options.Of ? PiecesOfSome(mesh, tree, options, examine, monitor)
                                               : PiecesOfAll(tree, options, examine, monitor);
  return Gather(pieces, mesh.Triangles.size());
}

SelfIntersections FindSelfIntersections(const TriangleMesh& mesh, Monitor& monitor)
{
  return FindSelfIntersections(mesh, SelfIntersectionOptions(), monitor);
}
}
