// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/PinchGap.h"

#include "Base/Median.h"
#include "Base/PointHash.h"
#include "Mesh/ComponentNesting.h"
#include "Mesh/InwardDirection.h"
#include "Mesh/MassProperties.h"
#include "Mesh/ThinPieces.h"
#include "Mesh/TriangleClearance.h"
#include "Mesh/TriangleComponents.h"
#include "Mesh/TriangleMeasures.h"
#include "Mesh/TrianglePair.h"
#include "Mesh/TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace recon
{
namespace
{
/// A point moves at most by this part of the shortest edge of its fan.
constexpr double LargestPartOfEdge = 0.1;
/// A move that would cross or touch a sheet is tried in other directions, then at a half, a quarter
/// and an eighth of the gap.
constexpr int Lengths = 4;
/// Faces that lean less than this against the plane of the contours (a sine) count as lying in it.
constexpr double LeastSlope = 1e-6;
/// So many pairs of triangles are looked at before no other way is tried any more: in a few seconds, which only sheets
/// by the thousand within one another's reach need.
constexpr std::size_t FewPairs = 20000000;
constexpr std::size_t PairsATriangle = 1000;

class Opening
{
public:
  Opening(TriangleMesh& mesh, double gap, const Vector3& normal, Monitor& monitor)
    : Mesh(mesh),
      Gap(gap),
      Normal(normal),
      Observer(monitor)
  {
  }

  PinchGapResult Run()
  {
    this->FindPlaces();
    if (this->Result.Places > 0)
    {
      this->FindFans();
      this->FindPieces();
      this->ChooseMoves();
      this->MoveWithoutCrossing();
      this->CountWhatIsLeft();
    }
    return this->Result;
  }

private:
  /// A point that goes into the cone of its own fan.
  struct Move
  {
    int Point = -1;
    Point3 From{};
    std::vector<Vector3> Steps; ///< the better first
    int Trial = 0;
    void TryNext() { ++this->Trial; }
    void GiveUp() { this->Trial = Lengths * static_cast<int>(this->Steps.size()); }
    bool IsMade() const { return this->Trial < Lengths * static_cast<int>(this->Steps.size()); }
    Point3 To() const
    {
      const int count = static_cast<int>(this->Steps.size());
      return this->IsMade()
        ? this->From + std::ldexp(1.0, -(this->Trial / count)) * this->Steps[this->Trial % count]
        : this->From;
    }
  };

  /// Points that share a place, by its coordinates.
  void FindPlaces()
  {
    const auto& points = this->Mesh.Points;
    // An open table of the first points of all places.
    std::size_t size = 1;
    while (size < 2 * points.size())
    {
      size *= 2;
    }
    std::vector<int> table(size, -1);
    std::map<int, std::vector<int>> places; // by the first point of each
    for (int p = 0; p < static_cast<int>(points.size()); ++p)
    {
      std::size_t slot = PointHash()(points[p]) & (size - 1);
      while (table[slot] >= 0 && points[table[slot]] != points[p])
      {
        slot = (slot + 1) & (size - 1);
      }
      if (table[slot] < 0)
      {
        table[slot] = p;
      }
      else
      {
        places[table[slot]].push_back(p);
      }
    }
    for (auto& [first, others] : places)
    {
      others.insert(others.begin(), first);
      this->Places.push_back(std::move(others));
    }
    std::sort(this->Places.begin(), this->Places.end(),
      [&](const auto& a, const auto& b) { return points[a[0]] < points[b[0]]; });
    this->Result.Places = this->Places.size();
  }

  void FindFans()
  {
    this->FanOf.assign(this->Mesh.Points.size(), -1);
    int count = 0;
    for (const std::vector<int>& place : this->Places)
    {
      for (int p : place)
      {
        this->FanOf[p] = count++;
      }
    }
    this->Fans.resize(count);
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      for (int p : this->Mesh.Triangles[t])
      {
        if (this->FanOf[p] >= 0)
        {
          this->Fans[this->FanOf[p]].push_back(static_cast<int>(t));
        }
      }
    }
  }

  /// What is connected by index, and how much it holds before anything moves.
  void FindPieces()
  {
    this->Pieces = FindTriangleComponents(this->Mesh);
    this->Volumes = ComputeSignedVolumes(this->Mesh, this->Pieces.Of, this->Pieces.Count);
  }

  /// Normals of a fan's faces, turned so that they look away from the axis of its cone: out of the
  /// solid where that is a wedge, into it where the solid is around an empty wedge.
  std::vector<Vector3> NormalsOf(int point) const
  {
    std::vector<Vector3> normals;
    Vector3 axis{ 0, 0, 0 };
    Vector3 sum{ 0, 0, 0 };
    for (int t : this->Fans[this->FanOf[point]])
    {
      normals.push_back(UnitNormalOf(this->Mesh, t));
      sum = sum + normals.back();
      for (int p : this->Mesh.Triangles[t])
      {
        const Vector3 edge = this->Mesh.Points[p] - this->Mesh.Points[point];
        const double length = Norm(edge);
        axis = length > 0 ? axis + (1 / length) * edge : axis;
      }
    }
    const bool empty = Dot(axis, sum) > 0;
    for (Vector3& normal : normals)
    {
      normal = (empty ? -1.0 : 1.0) * normal;
    }
    return normals;
  }

  double ShortestEdgeAt(int point) const
  {
    double shortest = std::numeric_limits<double>::infinity();
    for (int t : this->Fans[this->FanOf[point]])
    {
      for (int p : this->Mesh.Triangles[t])
      {
        const double length = Norm(this->Mesh.Points[p] - this->Mesh.Points[point]);
        shortest = p != point && length > 0 ? std::min(shortest, length) : shortest;
      }
    }
    return shortest;
  }

  /// The same within the plane of the contours, for the faces that are not in it.
  std::vector<Vector3> InPlane(const std::vector<Vector3>& normals) const
  {
    std::vector<Vector3> planar;
    for (const Vector3& normal : normals)
    {
      const Vector3 part = normal - Dot(normal, this->Normal) * this->Normal;
      const double length = Norm(part);
      if (length > LeastSlope)
      {
        planar.push_back((1 / length) * part);
      }
    }
    return planar;
  }

  /// Ways for a point, those within the plane first: what lies in the plane stays in it.
  std::vector<Vector3> StepsOf(int point, double& clearance) const
  {
    const double length = std::min(this->Gap, LargestPartOfEdge * this->ShortestEdgeAt(point));
    const std::vector<Vector3> normals = this->NormalsOf(point);
    std::vector<Vector3> steps;
    if (Norm(this->Normal) > 0)
    {
      double unused = 0;
      const Vector3 planar = length * InwardOf(this->InPlane(normals), unused);
      steps.insert(steps.end(), { planar, -1.0 * planar });
    }
    const Vector3 spatial = length * InwardOf(normals, clearance);
    steps.insert(steps.end(), { spatial, -1.0 * spatial });
    return steps;
  }

  /// Of every place the point whose fan leaves it the least way inward stays.
  void ChooseMoves()
  {
    for (const std::vector<int>& place : this->Places)
    {
      std::vector<Move> moves;
      std::size_t stays = 0;
      double least = 2;
      for (int p : place)
      {
        double clearance = 0;
        std::vector<Vector3> steps = this->StepsOf(p, clearance);
        if (clearance < least)
        {
          least = clearance;
          stays = moves.size();
        }
        moves.push_back({ p, this->Mesh.Points[p], std::move(steps) });
      }
      this->Stays.push_back(moves[stays]);
      moves.erase(moves.begin() + static_cast<std::ptrdiff_t>(stays));
      this->Moves.insert(this->Moves.end(), moves.begin(), moves.end());
    }
  }

  void MoveWithoutCrossing()
  {
    this->FindWhereTheyMayGo();
    std::vector<int> ofFans;
    for (const std::vector<int>& fan : this->Fans)
    {
      ofFans.insert(ofFans.end(), fan.begin(), fan.end());
    }
    const TriangleTree tree(this->Mesh, this->BoxesOfTrials, ofFans);
    this->MoveOf.assign(this->Mesh.Points.size(), -1);
    this->Make(0, tree);
    // Where one point found no way, the one that stayed may find one instead of it.
    const std::size_t first = this->Moves.size();
    for (const Move& stay : this->Stays)
    {
      const auto& place = this->Places[this->PlaceOf(stay)];
      const auto left = std::find_if(place.begin(), place.end(),
        [&](int p) { return p != stay.Point && this->Mesh.Points[p] == stay.From; });
      if (left != place.end())
      {
        // That one stays for good, or the place would be no point of the surface.
        this->MoveOf[*left] = -1;
        this->Moves.push_back(stay);
      }
    }
    this->Make(first, tree);
    this->KeepNesting(tree);
  }

  /// Around each triangle wherever its points may go, and how far from where they are. A shorter way along a
  /// step ends between the ends of the whole one, also when it is rounded.
  void FindWhereTheyMayGo()
  {
    this->Origin = this->Mesh.Points;
    this->Reach.assign(this->Mesh.Triangles.size(), 0);
    this->Neighbours.resize(this->Mesh.Triangles.size());
    this->IsAsked.assign(this->Mesh.Triangles.size(), 0);
    this->BoxesOfTrials.reserve(this->Mesh.Triangles.size());
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      this->BoxesOfTrials.push_back(BoxOf(this->Mesh, static_cast<int>(t)));
    }
    for (const std::vector<Move>* moves : { &this->Moves, &this->Stays })
    {
      for (const Move& move : *moves)
      {
        for (const int t : this->Fans[this->FanOf[move.Point]])
        {
          for (const Vector3& step : move.Steps)
          {
            this->BoxesOfTrials[t].Add(move.From + step);
            this->Reach[t] = std::max(this->Reach[t], Norm(step));
          }
        }
      }
    }
  }

  std::array<Point3, 3> OriginOf(int triangle) const
  {
    const auto& corners = this->Mesh.Triangles[triangle];
    return { this->Origin[corners[0]], this->Origin[corners[1]], this->Origin[corners[2]] };
  }

  /// Triangles that one may meet, wherever the points of both may go; looked for once.
  const std::vector<int>& NeighboursOf(int triangle, const TriangleTree& tree)
  {
    std::vector<int>& neighbours = this->Neighbours[triangle];
    if (!this->IsAsked[triangle])
    {
      this->IsAsked[triangle] = 1;
      tree.VisitMeeting(this->BoxesOfTrials[triangle],
        [&](int other)
        {
          ++this->PairsAsked;
          const double reach = this->Reach[triangle] + this->Reach[other];
          if (other != triangle &&
            !AreFartherApartThan(this->OriginOf(triangle), this->OriginOf(other), reach))
          {
            neighbours.push_back(other);
          }
        });
    }
    return neighbours;
  }

  /// Stays are in the order of the places.
  std::size_t PlaceOf(const Move& stay) const
  {
    return static_cast<std::size_t>(&stay - this->Stays.data());
  }

  /// Make the moves from that number on, and try others for those that cross or touch.
  void Make(std::size_t first, const TriangleTree& tree)
  {
    std::vector<int> toLookAt;
    for (std::size_t m = first; m < this->Moves.size(); ++m)
    {
      this->MoveOf[this->Moves[m].Point] = static_cast<int>(m);
      this->PlaceAgain(static_cast<int>(m), toLookAt);
    }
    this->Settle(toLookAt, tree);
  }

  void PlaceAgain(int m, std::vector<int>& toLookAt)
  {
    this->Mesh.Points[this->Moves[m].Point] = this->Moves[m].To();
    const auto& fan = this->Fans[this->FanOf[this->Moves[m].Point]];
    toLookAt.insert(toLookAt.end(), fan.begin(), fan.end());
  }

  /// Other trials of moves that make what is to be looked at cross, touch or turn.
  void Settle(std::vector<int>& toLookAt, const TriangleTree& tree)
  {
    // Every round takes a trial from a move, and each has only so many.
    while (!toLookAt.empty())
    {
      this->Observer.Update(0.97, "parting sheets that touch");
      std::vector<int> wrong = this->MovesThatCross(tree, toLookAt);
      this->AddMovesThatTurn(toLookAt, wrong);
      toLookAt.clear();
      const bool isEnough =
        this->PairsAsked > FewPairs + PairsATriangle * this->Mesh.Triangles.size();
      for (int m : wrong)
      {
        isEnough ? this->Moves[m].GiveUp() : this->Moves[m].TryNext();
        this->PlaceAgain(m, toLookAt);
      }
    }
  }

  std::vector<int> Nesting(const TriangleMesh& mesh) const
  {
    return FindComponentNesting(
      mesh, this->Pieces.Of, std::vector<bool>(this->Volumes.size(), true));
  }

  /// Thin pieces come to lie in no other piece, and out of none: else nothing moves in their places.
  void KeepNesting(const TriangleTree& tree)
  {
    if (this->Volumes.size() < 2 ||
      !HasThinPiece(this->Mesh, this->Pieces.Of, this->Volumes, this->Gap))
    {
      return;
    }
    const std::vector<int> before = this->Nesting({ this->Origin, this->Mesh.Triangles });
    for (std::vector<int> undone{ 0 }; !undone.empty();)
    {
      this->Observer.Update(0.97, "parting sheets that touch");
      const std::vector<int> after = this->Nesting(this->Mesh);
      undone.clear();
      for (const std::vector<int>& place : this->Places)
      {
        const bool isKept = std::all_of(place.begin(), place.end(),
          [&](int p)
          {
            const std::vector<int>& fan = this->Fans[this->FanOf[p]];
            // A point of no triangle is of no piece.
            return fan.empty() ||
              before[this->Pieces.Of[fan.front()]] == after[this->Pieces.Of[fan.front()]];
          });
        for (const int p : place)
        {
          const int m = this->MoveOf[p];
          if (!isKept && m >= 0 && this->Moves[m].IsMade())
          {
            this->Moves[m].GiveUp();
            this->PlaceAgain(m, undone);
          }
        }
      }
      std::vector<int> toLookAt = undone;
      this->Settle(toLookAt, tree);
    }
  }

  /// Whether the triangles touch in a corner that could not be drawn apart.
  bool ShareAPlace(int s, int t) const
  {
    const auto& first = this->Mesh.Triangles[s];
    const auto& second = this->Mesh.Triangles[t];
    return std::any_of(first.begin(), first.end(),
      [&](int p)
      {
        return std::any_of(second.begin(), second.end(),
          [&](int q) { return p != q && this->Mesh.Points[p] == this->Mesh.Points[q]; });
      });
  }

  /// Numbers of moves that are made, of triangles that cross, overlap or touch others.
  std::vector<int> MovesThatCross(const TriangleTree& tree, std::vector<int>& triangles)
  {
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    std::vector<int> wrong;
    std::vector<char> isWrong(this->Moves.size(), 0);
    // Moves of a triangle that are made and not known to be wrong yet.
    const auto visitUnblamed = [&](int triangle, const auto& visit)
    {
      for (int p : this->Mesh.Triangles[triangle])
      {
        const int m = this->MoveOf[p];
        if (m >= 0 && !isWrong[m] && this->Moves[m].IsMade())
        {
          visit(m);
        }
      }
    };
    const auto isUnblamed = [&](int triangle)
    {
      bool any = false;
      visitUnblamed(triangle, [&any](int) { any = true; });
      return any;
    };
    const auto blame = [&](int m)
    {
      isWrong[m] = 1;
      wrong.push_back(m);
    };
    // Of two triangles that are both looked at, the first asks.
    std::vector<char> hasAsked(this->Mesh.Triangles.size(), 0);
    for (int t : triangles)
    {
      hasAsked[t] = 1;
      const Box3 box = BoxOf(this->Mesh, t);
      const std::vector<int>& neighbours = this->NeighboursOf(t, tree);
      this->PairsAsked += neighbours.size();
      bool mayBeBlamed = isUnblamed(t);
      for (const int other : neighbours)
      {
        if (hasAsked[other] || !(mayBeBlamed || isUnblamed(other)) ||
          !BoxOf(this->Mesh, other).Meets(box))
        {
          continue;
        }
        const PairRelation relation = RelateTriangles(this->Mesh, t, other);
        if (relation != PairRelation::Clean &&
          (relation != PairRelation::Touching || !this->ShareAPlace(t, other)))
        {
          visitUnblamed(t, blame);
          visitUnblamed(other, blame);
          mayBeBlamed = false;
        }
      }
    }
    std::sort(wrong.begin(), wrong.end());
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
    return wrong;
  }

  /// Of what held nothing nobody can tell.
  static bool IsTurned(double before, double after)
  {
    return (before > 0 && !(after > 0)) || (before < 0 && !(after < 0));
  }

  /// A piece thinner than the moves may be turned inside out without any two triangles crossing in the end: then all moves of
  /// its points are wrong as well.
  void AddMovesThatTurn(const std::vector<int>& triangles, std::vector<int>& wrong) const
  {
    std::vector<char> isLookedAt(this->Volumes.size(), 0);
    for (const int t : triangles)
    {
      isLookedAt[this->Pieces.Of[t]] = 1;
    }
    std::vector<int> pieceOf = this->Pieces.Of;
    for (int& piece : pieceOf)
    {
      piece = isLookedAt[piece] ? piece : -1;
    }
    const std::vector<double> volumes =
      ComputeSignedVolumes(this->Mesh, pieceOf, this->Pieces.Count);
    for (std::size_t t = 0; t < pieceOf.size(); ++t)
    {
      const int piece = pieceOf[t];
      if (piece < 0 || !IsTurned(this->Volumes[piece], volumes[piece]))
      {
        continue;
      }
      for (const int p : this->Mesh.Triangles[t])
      {
        const int m = this->MoveOf[p];
        if (m >= 0 && this->Moves[m].IsMade())
        {
          wrong.push_back(m);
        }
      }
    }
    std::sort(wrong.begin(), wrong.end());
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
  }

  void CountWhatIsLeft()
  {
    for (std::vector<int>& place : this->Places)
    {
      std::sort(place.begin(), place.end(),
        [&](int a, int b) { return this->Mesh.Points[a] < this->Mesh.Points[b]; });
      this->Result.Left +=
        std::adjacent_find(place.begin(), place.end(),
          [&](int a, int b) { return this->Mesh.Points[a] == this->Mesh.Points[b]; }) == place.end()
        ? 0
        : 1;
    }
  }

  TriangleMesh& Mesh;
  double Gap;
  Vector3 Normal; ///< of the contours' planes, or zero
  Monitor& Observer;
  PinchGapResult Result;
  std::vector<std::vector<int>> Places; ///< points by place
  std::vector<int> FanOf;             ///< of a point that has company the number of its fan, or -1
  std::vector<std::vector<int>> Fans; ///< triangles
  std::vector<Move> Moves;
  std::vector<Move> Stays;                  ///< by place the point that stays, and how it could go
  std::vector<int> MoveOf;                  ///< of a point, or -1
  std::vector<Point3> Origin;               ///< points before any move
  std::vector<Box3> BoxesOfTrials;          ///< a triangle: around wherever it may be moved
  std::vector<double> Reach;                ///< a triangle: the farthest that a corner may be moved
  std::vector<std::vector<int>> Neighbours; ///< see NeighboursOf
  std::size_t PairsAsked = 0;
  std::vector<char> IsAsked; ///< a triangle: whether Neighbours has them
  TriangleComponents Pieces;
  std::vector<double> Volumes; ///< of the pieces, before any move
};
}

PinchGapResult OpenPinches(TriangleMesh& mesh, double gap, const Vector3& normal, Monitor& monitor)
{
  return Opening(mesh, gap, normal, monitor).Run();
}

double MedianEdgeLength(const TriangleMesh& mesh)
{
  std::vector<double> lengths;
  lengths.reserve(3 * mesh.Triangles.size());
  for (const auto& corners : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      lengths.push_back(Norm(mesh.Points[corners[(k + 1) % 3]] - mesh.Points[corners[k]]));
    }
  }
  return Median(std::move(lengths));
}
}
