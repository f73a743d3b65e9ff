// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/UncrossedMove.h"

#include "Base/BoundingBox.h"
#include "Fair/LinkedMesh.h"
#include "Fair/TurnedPieces.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TriangleComponents.h"

#include <algorithm>
#include <map>

namespace recon
{
namespace
{
/// So many times ways are halved; then points stay, and after as many more times all of them do.
constexpr int Halvings = 4;
constexpr int MostAttempts = 10;

class Mover
{
public:
  Mover(const TriangleMesh& mesh, const std::vector<Point3>& places, double leastAngle,
    const PlacesToKeep& keep, int threads, Monitor& monitor)
    : Given(mesh),
      Places(places),
      LeastAngle(leastAngle),
      Keep(keep),
      Threads(threads),
      Observer(monitor),
      Share(mesh.Points.size(), 1),
      Rest(FindWitnesses(mesh, keep, threads, monitor)),
      Witness(Rest)
  {
  }

  UncrossedMove Move()
  {
    UncrossedMove moved;
    moved.Mesh = this->Given;
    std::vector<char> changed = this->MovedTriangles();
    this->HoldLostPoints(moved.Mesh, changed);
    for (int attempt = 0; attempt < MostAttempts; ++attempt)
    {
      this->Apply(moved.Mesh);
      std::vector<char> bad = this->FindBad(moved.Mesh, changed);
      if (std::none_of(bad.begin(), bad.end(), [](char b) { return b != 0; }))
      {
        bad = this->FindTurned(moved.Mesh);
      }
      if (std::none_of(bad.begin(), bad.end(), [](char b) { return b != 0; }))
      {
        moved.HeldBack = std::count_if(
          this->Share.begin(), this->Share.end(), [](double share) { return share < 1; });
        return moved;
      }
      for (int ring = 0; ring <= attempt; ++ring)
      {
        this->Grow(bad);
      }
      for (std::size_t v = 0; v < bad.size(); ++v)
      {
        this->Share[v] = !bad[v] ? this->Share[v] : attempt < Halvings ? 0.5 * this->Share[v] : 0;
      }
      changed = this->TrianglesOf(bad);
    }
    moved.Mesh = this->Given;
    moved.HeldBack = this->Share.size();
    return moved;
  }

private:
  /// Those with one of the points.
  std::vector<char> TrianglesOf(const std::vector<char>& points) const
  {
    std::vector<char> of(this->Given.Triangles.size(), 0);
    for (std::size_t t = 0; t < of.size(); ++t)
    {
      const auto& corners = this->Given.Triangles[t];
      of[t] = points[corners[0]] || points[corners[1]] || points[corners[2]] ? 1 : 0;
    }
    return of;
  }

  std::vector<char> MovedTriangles() const
  {
    std::vector<char> moves(this->Given.Points.size(), 0);
    for (std::size_t v = 0; v < moves.size(); ++v)
    {
      moves[v] = this->Places[v] != this->Given.Points[v] ? 1 : 0;
    }
    return this->TrianglesOf(moves);
  }

  void Apply(TriangleMesh& mesh) const
  {
    for (std::size_t v = 0; v < this->Share.size(); ++v)
    {
      const Point3& from = this->Given.Points[v];
      mesh.Points[v] = this->Share[v] == 1 ? this->Places[v]
        : this->Share[v] == 0              ? from
                                           : from + this->Share[v] * (this->Places[v] - from);
    }
  }

  /// Points of triangles that cross or are too thin now, or had a place that is lost, among those that have changed since this was
  /// asked last: the others were well then.
  std::vector<char> FindBad(const TriangleMesh& mesh, const std::vector<char>& changed)
  {
    std::vector<char> bad(mesh.Points.size(), 0);
    const auto mark = [&](int t)
    {
      for (const int v : mesh.Triangles[t])
      {
        bad[v] = this->Share[v] > 0 ? 1 : bad[v];
      }
    };
    SelfIntersectionOptions options;
    options.Threads = this->Threads;
    options.Of = &changed;
    for (const IntersectingPair& pair : FindSelfIntersections(mesh, options, this->Observer).Pairs)
    {
      if (pair.Kind != IntersectingPair::Touching)
      {
        mark(pair.First);
        mark(pair.Second);
      }
    }
    for (int t = 0; this->LeastAngle > 0 && t < static_cast<int>(mesh.Triangles.size()); ++t)
    {
      if (changed[t] && this->AngleIn(mesh, t) < this->LeastAngle &&
        this->AngleIn(mesh, t) < this->AngleIn(this->Given, t))
      {
        mark(t);
      }
    }
    for (const std::size_t i : this->FindLost(mesh, changed))
    {
      mark(this->Rest[i]);
    }
    return bad;
  }

  /// Places to keep that the mesh passes no more, among those near what has changed.
  std::vector<std::size_t> FindLost(const TriangleMesh& mesh, const std::vector<char>& changed)
  {
    std::vector<std::size_t> lost;
    PlacesToKeep left;
    left.Within = this->Keep.Within;
    for (std::size_t i = 0; i < this->Witness.size(); ++i)
    {
      const int t = this->Witness[i];
      if (t >= 0 && changed[t] &&
        this->DistanceTo(mesh, t, this->Keep.Places[i]) > this->Keep.Within)
      {
        lost.push_back(i);
        left.Places.push_back(this->Keep.Places[i]);
      }
    }
    if (lost.empty())
    {
      return lost;
    }
    // Another triangle may have come nearer.
    const std::vector<int> others = FindWitnesses(mesh, left, this->Threads, this->Observer);
    std::vector<std::size_t> without;
    for (std::size_t k = 0; k < lost.size(); ++k)
    {
      const std::size_t i = lost[k];
      this->Witness[i] = others[k] >= 0 ? others[k] : this->Rest[i];
      if (others[k] < 0)
      {
        without.push_back(i);
      }
    }
    return without;
  }

  double DistanceTo(const TriangleMesh& mesh, int t, const Point3& p) const
  {
    const auto& corners = mesh.Triangles[t];
    return this->Keep.DistanceTo(
      p, mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]]);
  }

  /// Points that are at a place to keep which would be lost stay there.
  void HoldLostPoints(TriangleMesh& mesh, const std::vector<char>& changed)
  {
    this->Apply(mesh);
    for (const std::size_t i : this->FindLost(mesh, changed))
    {
      for (const int v : this->Given.Triangles[this->Rest[i]])
      {
        this->Share[v] = this->Given.Points[v] == this->Keep.Places[i] ? 0 : this->Share[v];
      }
    }
  }

  /// All that a triangle has gone through lies in it.
  Box3 WayOf(const TriangleMesh& mesh, int t) const
  {
    Box3 way;
    for (const int v : mesh.Triangles[t])
    {
      way.Add(this->Given.Points[v]);
      way.Add(mesh.Points[v]);
    }
    return way;
  }

  /// The points of pieces that were well and are turned now, though nothing crosses; and those that may
  /// have passed over such a piece, which is inside another one then, wherever it stays.
  std::vector<char> FindTurned(const TriangleMesh& mesh)
  {
    if (this->Pieces.Of.empty())
    {
      this->Pieces = FindTriangleComponents(this->Given);
      this->Before = FindTurnedPieces(this->Given, this->Pieces);
    }
    const std::vector<char> after = FindTurnedPieces(mesh, this->Pieces);
    const int count = static_cast<int>(mesh.Triangles.size());
    std::map<int, Box3> ways; // of the turned pieces
    for (int t = 0; t < count; ++t)
    {
      const int piece = this->Pieces.Of[t];
      if (after[piece] && !this->Before[piece])
      {
        ways[piece].Add(this->WayOf(mesh, t));
      }
    }
    std::vector<char> turned(mesh.Points.size(), 0);
    for (int t = 0; t < count && !ways.empty(); ++t)
    {
      const Box3 way = this->WayOf(mesh, t);
      const bool isNear = ways.count(this->Pieces.Of[t]) > 0 ||
        std::any_of(ways.begin(), ways.end(), [&](const auto& of) { return of.second.Meets(way); });
      for (const int v : mesh.Triangles[t])
      {
        turned[v] = isNear && this->Share[v] > 0 ? 1 : turned[v];
      }
    }
    return turned;
  }

  static double AngleIn(const TriangleMesh& mesh, int t)
  {
    const auto& corners = mesh.Triangles[t];
    return SmallestAngle(mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]]);
  }

  /// By the triangles around.
  void Grow(std::vector<char>& marked) const
  {
    const std::vector<char> before = marked;
    for (const auto& t : this->Given.Triangles)
    {
      if (before[t[0]] || before[t[1]] || before[t[2]])
      {
        marked[t[0]] = marked[t[1]] = marked[t[2]] = 1;
      }
    }
  }

  const TriangleMesh& Given;
  const std::vector<Point3>& Places;
  double LeastAngle;
  const PlacesToKeep& Keep;
  int Threads;
  Monitor& Observer;
  std::vector<double> Share; ///< of its way, a point
  std::vector<int> Rest;    ///< of a place to keep, its triangle before the move; -1: there is none
  std::vector<int> Witness; ///< the same of the mesh as it is
  TriangleComponents Pieces; ///< of the given mesh, when they are asked for
  std::vector<char> Before;  ///< which of them were turned from the beginning
};
}

UncrossedMove MoveUncrossed(const TriangleMesh& mesh, const std::vector<Point3>& places,
  double leastAngle, const PlacesToKeep& keep, int threads, Monitor& monitor)
{
  return Mover(mesh, places, leastAngle, keep, threads, monitor).Move();
}
}
