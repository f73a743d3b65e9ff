// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/CrossingRepair.h"

#include "Base/Parallel.h"
#include "Base/PointHash.h"
#include "Base/Predicates.h"
#include "Base/SubMonitor.h"
#include "Mesh/MeshTopology.h"
#include "Mesh/TriangleMeasures.h"
#include "Mesh/TrianglePair.h"
#include "Mesh/TurnedBoxes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <unordered_map>
#include <utility>

namespace recon
{
namespace
{
/// Each looks at the whole surface once; a round that helps nothing is the last.
constexpr int Rounds = 16;
/// Trials beside one a triangle, and added points beside one for two triangles.
constexpr std::size_t LeastTrials = 20000;
constexpr std::size_t LeastAdded = 64;
/// From one length of a move to the next.
constexpr double Growth = 4;
/// Of the steps between neighbouring numbers of the size of a coordinate: the shortest move.
constexpr double ShortestInSteps = 2;

/// A point is tried across the triangles of so many bad pairs at most.
constexpr std::size_t MostPairs = 8;
/// Triangles that one piece of parallel work looks at.
constexpr std::size_t TrianglesAPiece = 512;

using Pair = std::pair<int, int>;

double LargestOf(const Point3& p)
{
  return std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
}

class Repair
{
public:
  Repair(TriangleMesh& mesh, const CrossingRepairOptions& options, Monitor& monitor)
    : Mesh(mesh),
      Options(options),
      Observer(monitor),
      MayMove(options.MayMove),
      Changed(options.MayMove.size(), 0),
      TrialsLeft(LeastTrials + mesh.Triangles.size()),
      AddedLeft(LeastAdded + mesh.Triangles.size() / 2)
  {
  }

  CrossingRepairResult Run()
  {
    RequireUsable(this->Mesh);
    std::vector<Pair> bad = this->FindBadPairs();
    this->Result.Found = bad.size();
    for (int round = 0; round < Rounds && !bad.empty(); ++round)
    {
      if (!this->MovePoints(bad) && !this->SplitEdges(bad))
      {
        break;
      }
      bad = this->FindBadPairs();
    }
    this->Result.Left = bad.size();
    for (const auto& [point, origin] : this->Origins)
    {
      const double way = Norm(this->Mesh.Points[point] - origin);
      this->Result.Moved += way > 0 ? 1 : 0;
      this->Result.Farthest = std::max(this->Result.Farthest, way);
    }
    return this->Result;
  }

private:
  /// Those of which one triangle at least is in doubt.
  std::vector<Pair> FindBadPairs()
  {
    const std::vector<int> doubtful = this->FindDoubtfulTriangles();
    this->Boxes.reset();
    if (doubtful.empty())
    {
      return {};
    }
    const bool areAll = doubtful.size() == this->Mesh.Triangles.size();
    auto boxes = std::make_unique<TurnedBoxes>(
      areAll ? this->Mesh : PartOf(this->Mesh, doubtful), this->Options.Frame);
    const std::size_t count = this->Mesh.Triangles.size();
    std::vector<std::vector<Pair>> pieces(count / TrianglesAPiece + 1);
    const auto examine = [&](std::size_t from, std::size_t to)
    {
      for (std::size_t t = from; t < to; ++t)
      {
        const int first = static_cast<int>(t);
        const bool isDoubtful = this->IsDoubtful(first);
        boxes->VisitNear(this->Mesh, first, 0,
          [&](int found)
          {
            const int other = doubtful[found];
            if (isDoubtful ? other > first && this->IsBad(first, other)
                           : this->IsBad(std::min(first, other), std::max(first, other)))
            {
              pieces[from / TrianglesAPiece].push_back(std::minmax(first, other));
            }
          });
      }
    };
    AbortMonitor silent(this->Observer);
    ParallelForBlocks(
      count, TrianglesAPiece, this->Options.Threads, examine, silent, ProgressRange(), 4);
    std::vector<Pair> bad;
    for (const std::vector<Pair>& piece : pieces)
    {
      bad.insert(bad.end(), piece.begin(), piece.end());
    }
    std::sort(bad.begin(), bad.end());
    if (areAll)
    {
      this->Boxes = std::move(boxes);
    }
    return bad;
  }

  bool IsDoubtful(int triangle) const
  {
    const auto isOff = [this](int p)
    {
      return this->Changed[p] != 0 || p >= static_cast<int>(this->Options.IsExact.size()) ||
        this->Options.IsExact[p] == 0;
    };
    const auto& corners = this->Mesh.Triangles[triangle];
    return std::any_of(corners.begin(), corners.end(), isOff);
  }

  std::vector<int> FindDoubtfulTriangles() const
  {
    std::vector<int> doubtful;
    for (int t = 0; t < static_cast<int>(this->Mesh.Triangles.size()); ++t)
    {
      if (this->IsDoubtful(t))
      {
        doubtful.push_back(t);
      }
    }
    return doubtful;
  }

  /// Those triangles of the mesh, with all of its points.
  static TriangleMesh PartOf(const TriangleMesh& mesh, const std::vector<int>& triangles)
  {
    TriangleMesh part{ mesh.Points, {} };
    for (int t : triangles)
    {
      part.Triangles.push_back(mesh.Triangles[t]);
    }
    return part;
  }

  /// The triangles cross or overlap; or, where either has changed, touch elsewhere than in a place that
  /// they shared from the first: sheets may pass through one another along edges of their own.
  bool IsBad(int s, int t) const
  {
    const PairRelation relation = RelateTriangles(this->Mesh, s, t);
    return relation != PairRelation::Clean &&
      (relation != PairRelation::Touching ||
        ((this->HasChanged(s) || this->HasChanged(t)) && !this->ShareAPlace(s, t)));
  }

  bool HasChanged(int triangle) const
  {
    const auto& corners = this->Mesh.Triangles[triangle];
    return std::any_of(
      corners.begin(), corners.end(), [this](int p) { return this->Changed[p] != 0; });
  }

  Point3 OriginOf(int point) const
  {
    const auto origin = this->Origins.find(point);
    return origin == this->Origins.end() ? this->Mesh.Points[point] : origin->second;
  }

  bool ShareAPlace(int s, int t) const
  {
    const auto are = [this](int p, int q)
    {
      const int given = static_cast<int>(this->Options.MayMove.size());
      return p < given && q < given && this->Mesh.Points[p] == this->Mesh.Points[q] &&
        this->OriginOf(p) == this->OriginOf(q);
    };
    const auto& first = this->Mesh.Triangles[s];
    const auto& second = this->Mesh.Triangles[t];
    return std::any_of(first.begin(), first.end(),
      [&](int p)
      { return std::any_of(second.begin(), second.end(), [&](int q) { return are(p, q); }); });
  }

  // --- moves

  /// Returns whether any point was moved.
  bool MovePoints(const std::vector<Pair>& bad)
  {
    if (!this->Boxes)
    {
      this->Boxes = std::make_unique<TurnedBoxes>(this->Mesh, this->Options.Frame);
    }
    this->FindPlacesAndFans(bad);
    bool any = false;
    for (const std::vector<int>& place : this->Places)
    {
      for (int p : place)
      {
        any = (this->MayLeave(p, place) && this->TryMoves({ p })) || any;
      }
      const auto isMovable = [this](int p) { return this->MayMove[p] != 0; };
      if (place.size() > 1 && std::all_of(place.begin(), place.end(), isMovable))
      {
        any = this->TryMoves(place) || any;
      }
    }
    return any;
  }

  /// Whether what must not move has another point where this one is.
  bool MayLeave(int point, const std::vector<int>& place) const
  {
    return this->MayMove[point] ||
      std::any_of(place.begin(), place.end(),
        [&](int p) {
          return p != point && !this->MayMove[p] &&
            this->Mesh.Points[p] == this->Mesh.Points[point];
        });
  }

  /// Places of the corners of bad pairs, in the order of their first points, and all triangles there.
  void FindPlacesAndFans(const std::vector<Pair>& bad)
  {
    std::unordered_map<Point3, std::set<int>, PointHash> places;
    for (const Pair& pair : bad)
    {
      for (int t : { pair.first, pair.second })
      {
        for (int p : this->Mesh.Triangles[t])
        {
          places[this->Mesh.Points[p]];
        }
      }
    }
    this->Fans.clear();
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      for (int p : this->Mesh.Triangles[t])
      {
        const auto place = places.find(this->Mesh.Points[p]);
        if (place != places.end())
        {
          place->second.insert(p);
          this->Fans[p].push_back(static_cast<int>(t));
        }
      }
    }
    this->Places.clear();
    for (const auto& [where, points] : places)
    {
      this->Places.emplace_back(points.begin(), points.end());
    }
    std::sort(this->Places.begin(), this->Places.end());
  }

  std::vector<int> TrianglesAt(const std::vector<int>& points) const
  {
    std::vector<int> triangles;
    for (int p : points)
    {
      const std::vector<int>& fan = this->Fans.at(p);
      triangles.insert(triangles.end(), fan.begin(), fan.end());
    }
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
  }

  /// Bad pairs that have a triangle among those, which are sorted; each once, up to `most`.
  std::vector<Pair> BadPairsAt(const std::vector<int>& triangles, std::size_t most) const
  {
    std::vector<Pair> bad;
    for (int t : triangles)
    {
      // The boxes are those of the beginning of the round: since then the other may have moved.
      this->Boxes->VisitNear(this->Mesh, t, 2 * this->Options.Reach,
        [&](int other)
        {
          const bool second =
            other < t && std::binary_search(triangles.begin(), triangles.end(), other);
          if (other == t || second || bad.size() >= most)
          {
            return;
          }
          if (this->IsBad(t, other))
          {
            bad.emplace_back(t, other);
          }
        });
    }
    return bad;
  }

  /// The least move of those points together that leaves the fewest bad pairs; returns whether there
  /// is any.
  bool TryMoves(const std::vector<int>& points)
  {
    const std::vector<int> triangles = this->TrianglesAt(points);
    const std::vector<Pair> before =
      this->BadPairsAt(triangles, std::numeric_limits<std::size_t>::max());
    std::size_t least = before.size();
    if (least == 0)
    {
      return false;
    }
    const std::vector<Vector3> directions = this->DirectionsFor(before, triangles);
    std::vector<Point3> from, best;
    for (int p : points)
    {
      from.push_back(this->Mesh.Points[p]);
      this->Origins.emplace(p, from.back());
    }
    for (double length = this->ShortestMoveAt(from[0]); length <= this->Options.Reach && least > 0;
         length *= Growth)
    {
      this->Observer.Update(0.97, "undoing crossings of rounded points");
      for (std::size_t d = 0; d < directions.size() && least > 0 && this->TrialsLeft > 0; ++d)
      {
        --this->TrialsLeft;
        const std::size_t left = this->Place(points, length * directions[d])
          ? this->BadPairsAt(triangles, least).size()
          : least;
        if (left < least)
        {
          least = left;
          best = this->PositionsOf(points);
        }
      }
    }
    const std::vector<Point3>& to = best.empty() ? from : best;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Put(points[i], to[i]);
    }
    return !best.empty();
  }

  std::vector<Point3> PositionsOf(const std::vector<int>& points) const
  {
    std::vector<Point3> positions;
    for (int p : points)
    {
      positions.push_back(this->Mesh.Points[p]);
    }
    return positions;
  }

  /// Puts the points that far from where they were at the very first; returns whether that is
  /// another place than now.
  bool Place(const std::vector<int>& points, const Vector3& step)
  {
    bool any = false;
    for (int p : points)
    {
      const Point3 to = this->Origins.at(p) + step;
      any = any || to != this->Mesh.Points[p];
      this->Put(p, to);
    }
    return any;
  }

  void Put(int point, const Point3& to)
  {
    this->Mesh.Points[point] = to;
    const bool isAdded = point >= static_cast<int>(this->Options.MayMove.size());
    this->Changed[point] = isAdded || to != this->Origins.at(point) ? 1 : 0;
  }

  static double ShortestMoveAt(const Point3& p)
  {
    return ShortestInSteps * std::numeric_limits<double>::epsilon() *
      std::max(LargestOf(p), std::numeric_limits<double>::min());
  }

  /// Across each triangle of the bad pairs and across the fan, either way, then along the axes.
  std::vector<Vector3> DirectionsFor(
    const std::vector<Pair>& bad, const std::vector<int>& triangles) const
  {
    std::vector<Vector3> across;
    Vector3 sum{ 0, 0, 0 };
    for (int t : triangles)
    {
      sum = sum + UnitNormalOf(this->Mesh, t);
    }
    const double length = Norm(sum);
    across.push_back(length > 0 ? (1 / length) * sum : sum);
    for (std::size_t i = 0; i < std::min(MostPairs, bad.size()); ++i)
    {
      across.push_back(UnitNormalOf(this->Mesh, bad[i].second));
      across.push_back(UnitNormalOf(this->Mesh, bad[i].first));
    }
    across.insert(across.end(), { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } });
    std::vector<Vector3> directions;
    for (const Vector3& direction : across)
    {
      directions.push_back(direction);
      directions.push_back(-1.0 * direction);
    }
    return directions;
  }

  // --- points on edges

  /// Returns whether any edge was split.
  bool SplitEdges(const std::vector<Pair>& bad)
  {
    // By edge, its ends in order: the share of the way from the first to the second.
    std::map<Pair, double> splits;
    for (const Pair& pair : bad)
    {
      this->ChooseSplits(pair.first, pair.second, splits);
      this->ChooseSplits(pair.second, pair.first, splits);
    }
    this->FindEndsOf(splits);
    bool any = false;
    for (const auto& [edge, share] : splits)
    {
      if (this->AddedLeft == 0)
      {
        break;
      }
      any = this->Split(edge, share) || any;
    }
    return any;
  }

  /// Edges of a triangle that pass through the plane of another, where they do; of one that lies in
  /// that plane all, in the middle.
  void ChooseSplits(int triangle, int other, std::map<Pair, double>& splits) const
  {
    const auto& plane = this->Mesh.Triangles[other];
    const auto& corners = this->Mesh.Triangles[triangle];
    std::array<int, 3> side{};
    std::array<double, 3> height{};
    const Vector3 normal = UnitNormalOf(this->Mesh, other);
    for (std::size_t k = 0; k < 3; ++k)
    {
      side[k] = Orientation3(this->Mesh.Points[plane[0]], this->Mesh.Points[plane[1]],
        this->Mesh.Points[plane[2]], this->Mesh.Points[corners[k]]);
      height[k] =
        std::abs(Dot(normal, this->Mesh.Points[corners[k]] - this->Mesh.Points[plane[0]]));
    }
    const bool inPlane = side == std::array<int, 3>{ 0, 0, 0 };
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next = (k + 1) % 3;
      if (!inPlane && side[k] * side[next] >= 0)
      {
        continue;
      }
      const double whole = height[k] + height[next];
      const double share = inPlane || !(whole > 0) ? 0.5 : height[k] / whole;
      const bool ordered = corners[k] < corners[next];
      splits.emplace(ordered ? Pair(corners[k], corners[next]) : Pair(corners[next], corners[k]),
        ordered ? share : 1 - share);
    }
  }

  /// Fans of all ends of those edges.
  void FindEndsOf(const std::map<Pair, double>& splits)
  {
    this->Fans.clear();
    for (const auto& [edge, share] : splits)
    {
      this->Fans[edge.first];
      this->Fans[edge.second];
    }
    for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
    {
      for (int p : this->Mesh.Triangles[t])
      {
        const auto fan = this->Fans.find(p);
        if (fan != this->Fans.end())
        {
          fan->second.push_back(static_cast<int>(t));
        }
      }
    }
  }

  /// Returns whether the edge has a point between its ends.
  bool Split(const Pair& edge, double share)
  {
    const Point3& a = this->Mesh.Points[edge.first];
    const Point3& b = this->Mesh.Points[edge.second];
    const Point3 middle = a + share * (b - a);
    if (middle == a || middle == b)
    {
      return false;
    }
    const int added = static_cast<int>(this->Mesh.Points.size());
    this->Mesh.Points.push_back(middle);
    this->MayMove.push_back(1);
    this->Changed.push_back(1);
    ++this->Result.AddedPoints;
    --this->AddedLeft;
    const std::vector<int> fan = this->Fans.at(edge.first);
    for (int t : fan)
    {
      const auto& corners = this->Mesh.Triangles[t];
      if (std::find(corners.begin(), corners.end(), edge.second) != corners.end())
      {
        this->SplitTriangle(t, edge, added);
      }
    }
    return true;
  }

  /// The triangle keeps the first end of the edge, and a new one has the second.
  void SplitTriangle(int triangle, const Pair& edge, int middle)
  {
    std::array<int, 3> part = this->Mesh.Triangles[triangle];
    auto& corners = this->Mesh.Triangles[triangle];
    std::replace(part.begin(), part.end(), edge.first, middle);
    std::replace(corners.begin(), corners.end(), edge.second, middle);
    const int added = static_cast<int>(this->Mesh.Triangles.size());
    this->Mesh.Triangles.push_back(part);
    this->Result.PartOf.push_back(triangle);
    for (int p : part)
    {
      const auto fan = this->Fans.find(p);
      if (fan != this->Fans.end())
      {
        fan->second.push_back(added);
      }
    }
    std::vector<int>& behind = this->Fans.at(edge.second);
    behind.erase(std::find(behind.begin(), behind.end(), triangle));
  }

  TriangleMesh& Mesh;
  const CrossingRepairOptions& Options;
  Monitor& Observer;
  std::vector<char> MayMove; ///< with those that were added
  std::vector<char> Changed; ///< of a point, whether it was added or is not where it was
  std::size_t TrialsLeft;
  std::size_t AddedLeft;
  CrossingRepairResult Result;
  std::unique_ptr<TurnedBoxes> Boxes;   ///< of the mesh at the beginning of a round
  std::vector<std::vector<int>> Places; ///< points
  std::map<int, std::vector<int>> Fans; ///< of a point, triangles
  std::map<int, Point3> Origins;        ///< of a point that was tried, where it was at first
};
}

CrossingRepairResult UndoCrossings(
  TriangleMesh& mesh, const CrossingRepairOptions& options, Monitor& monitor)
{
  return Repair(mesh, options, monitor).Run();
}
}
