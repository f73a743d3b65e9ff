// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/SheetLinks.h"

#include "Base/DisjointSets.h"
#include "Base/SubMonitor.h"
#include "Mesh/SelfIntersections.h"
#include "Mesh/TriangleComponents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

namespace recon
{
namespace
{
/// Of a triangle, how large the mouth of a tube in it is; halved where the tube would touch something.
constexpr double MouthShare = 0.4;
constexpr int MostHalvings = 3;

/// Tubes that are tried at most; each is laid against the whole surface.
constexpr int MostTries = 500;

/// Of the slab: the middles of triangles are no nearer to a level than this.
constexpr double LeastHeight = 1e-3;

struct Candidate
{
  double Length;
  int Slab;
  int From; ///< triangle
  int To;
};

bool IsShorter(const Candidate& a, const Candidate& b)
{
  return std::tie(a.Length, a.Slab, a.From, a.To) < std::tie(b.Length, b.Slab, b.From, b.To);
}

class Linker
{
public:
  Linker(TriangleMesh& mesh, const PlanarFrame& frame, const std::vector<double>& offsets)
    : Mesh(mesh),
      Frame(frame),
      Offsets(offsets),
      Components(FindTriangleComponents(mesh))
  {
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      this->Result.PartOf.push_back(static_cast<int>(t));
      const auto& c = mesh.Triangles[t];
      this->Middles.push_back(
        (1.0 / 3) * (mesh.Points[c[0]] + mesh.Points[c[1]] + mesh.Points[c[2]]));
    }
  }

  SheetLinks Link(LinksWanted wanted, Monitor& monitor)
  {
    std::vector<Candidate> candidates = this->FindCandidates(monitor);
    std::sort(candidates.begin(), candidates.end(), IsShorter);
    DisjointSets joined(static_cast<std::size_t>(this->Components.Count));
    std::vector<int> taken; // first triangles
    for (const bool makesHandles : { false, true })
    {
      int& left = makesHandles ? wanted.Handles : wanted.Pieces;
      for (const Candidate& candidate : candidates)
      {
        const std::pair<int, int> pieces{ this->Components.Of[candidate.From],
          this->Components.Of[candidate.To] };
        // One through the same place would be a second mouth beside the first.
        const bool isElsewhere = std::all_of(taken.begin(), taken.end(),
          [&](int other) {
            return Norm(this->Middles[other] - this->Middles[candidate.From]) > candidate.Length;
          });
        const bool isOne = joined.Find(pieces.first) == joined.Find(pieces.second);
        if (left > 0 && isOne == makesHandles && isElsewhere && this->Tries < MostTries &&
          this->Make(candidate, monitor))
        {
          joined.Join(pieces.first, pieces.second);
          taken.push_back(candidate.From);
          --left;
        }
      }
    }
    return std::move(this->Result);
  }

private:
  /// By slab the triangles whose middles lie well within it.
  std::vector<std::vector<int>> TrianglesBySlab() const
  {
    std::vector<std::vector<int>> triangles(this->Offsets.size() - 1);
    for (std::size_t t = 0; t < this->Middles.size(); ++t)
    {
      const double height = Dot(this->Frame.Normal, this->Middles[t]);
      const auto above = std::upper_bound(this->Offsets.begin(), this->Offsets.end(), height);
      if (above == this->Offsets.begin() || above == this->Offsets.end())
      {
        continue;
      }
      const double margin = LeastHeight * (*above - *(above - 1));
      if (height - *(above - 1) > margin && *above - height > margin)
      {
        triangles[static_cast<std::size_t>(above - this->Offsets.begin()) - 1].push_back(
          static_cast<int>(t));
      }
    }
    return triangles;
  }

  /// Of every triangle the shortest to another piece in its slab.
  std::vector<Candidate> FindCandidates(Monitor& monitor) const
  {
    std::vector<Candidate> all;
    const std::vector<std::vector<int>> bySlab = this->TrianglesBySlab();
    for (std::size_t slab = 0; slab < bySlab.size(); ++slab)
    {
      monitor.Update(static_cast<double>(slab) / static_cast<double>(bySlab.size()),
        "looking for the nearest sheets");
      std::vector<int> sorted = bySlab[slab]; // along U, so that what is far away is passed over
      std::sort(sorted.begin(), sorted.end(),
        [&](int a, int b)
        { return std::make_pair(this->AlongU(a), a) < std::make_pair(this->AlongU(b), b); });
      const bool isOnePiece = std::all_of(sorted.begin(), sorted.end(),
        [&](int t) { return this->Components.Of[t] == this->Components.Of[sorted[0]]; });
      for (std::size_t i = 0; i < sorted.size() && !isOnePiece; ++i)
      {
        if (const auto nearest = this->NearestTo(i, sorted))
        {
          all.push_back({ nearest->first, static_cast<int>(slab), sorted[i], nearest->second });
        }
      }
    }
    return all;
  }

  /// Distance and triangle.
  std::optional<std::pair<double, int>> NearestTo(
    std::size_t i, const std::vector<int>& sorted) const
  {
    const int own = sorted[i];
    std::optional<std::pair<double, int>> nearest;
    const auto isBeyond = [&](int other)
    {
      const std::pair<double, int> found{ Norm(this->Middles[own] - this->Middles[other]), other };
      if (this->Components.Of[other] != this->Components.Of[own] &&
        (!nearest || found < *nearest) && this->FacesBothWays(own, other))
      {
        nearest = found;
      }
      return nearest && std::abs(this->AlongU(other) - this->AlongU(own)) > nearest->first;
    };
    for (std::size_t j = i + 1; j < sorted.size() && !isBeyond(sorted[j]); ++j)
    {
    }
    for (std::size_t j = i; j > 0 && !isBeyond(sorted[j - 1]); --j)
    {
    }
    return nearest;
  }

  double AlongU(int triangle) const { return Dot(this->Frame.U, this->Middles[triangle]); }

  Vector3 NormalOf(int triangle) const
  {
    const auto& c = this->Mesh.Triangles[triangle];
    return Cross(this->Mesh.Points[c[1]] - this->Mesh.Points[c[0]],
      this->Mesh.Points[c[2]] - this->Mesh.Points[c[0]]);
  }

  /// How steeply the way to the other triangle leaves this one, outwards positive.
  double Leaves(int from, int to) const
  {
    return Dot(this->NormalOf(from), this->Middles[to] - this->Middles[from]);
  }

  /// Both ends lead outwards, or both into the solid.
  bool FacesBothWays(int a, int b) const { return this->Leaves(a, b) * this->Leaves(b, a) > 0; }

  /// Whether the tube touches nothing else; then it is made.
  bool Make(const Candidate& candidate, Monitor& monitor)
  {
    ++this->Tries;
    double share = MouthShare;
    for (int halving = 0; halving <= MostHalvings; ++halving, share /= 2)
    {
      TriangleMesh tried = this->Mesh;
      std::vector<int> partOf = this->Result.PartOf;
      const bool isSolid = this->Leaves(candidate.From, candidate.To) < 0;
      AddTube(tried, partOf, candidate, share);
      if (this->IsFree(tried, candidate, monitor))
      {
        this->Mesh = std::move(tried);
        this->Result.PartOf = std::move(partOf);
        this->Result.Links.push_back(
          { candidate.Slab, this->Middles[candidate.From], this->Middles[candidate.To], isSolid });
        return true;
      }
    }
    return false;
  }

  /// Exactly; with mouths that another tube has taken it is not.
  bool IsFree(const TriangleMesh& tried, const Candidate& candidate, Monitor& monitor) const
  {
    const auto isTaken = [&](int triangle)
    {
      return this->Result.PartOf[triangle] != triangle ||
        std::count(this->Result.PartOf.begin(), this->Result.PartOf.end(), triangle) > 1;
    };
    if (isTaken(candidate.From) || isTaken(candidate.To))
    {
      return false;
    }
    std::vector<char> isNew(tried.Triangles.size(), 0);
    std::fill(
      isNew.begin() + static_cast<std::ptrdiff_t>(this->Mesh.Triangles.size()), isNew.end(), 1);
    SelfIntersectionOptions options;
    options.Of = &isNew;
    AbortMonitor stop(monitor);
    return !FindSelfIntersections(tried, options, stop).Any();
  }

  using Mouth = std::array<int, 3>;

  /// The middle of a triangle becomes a mouth, with triangles around it, the first in its place.
  static Mouth OpenMouth(TriangleMesh& mesh, std::vector<int>& partOf, int triangle, double share)
  {
    const std::array<int, 3> corners = mesh.Triangles[triangle];
    const Point3 middle =
      (1.0 / 3) * (mesh.Points[corners[0]] + mesh.Points[corners[1]] + mesh.Points[corners[2]]);
    Mouth mouth{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      mouth[k] = static_cast<int>(mesh.Points.size());
      mesh.Points.push_back(middle + share * (mesh.Points[corners[k]] - middle));
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next = (k + 1) % 3;
      const std::array<int, 3> outer{ { corners[k], corners[next], mouth[next] } };
      const std::array<int, 3> inner{ { corners[k], mouth[next], mouth[k] } };
      if (k == 0)
      {
        mesh.Triangles[triangle] = outer;
      }
      else
      {
        mesh.Triangles.push_back(outer);
        partOf.push_back(triangle);
      }
      mesh.Triangles.push_back(inner);
      partOf.push_back(triangle);
    }
    return mouth;
  }

  static void AddTube(
    TriangleMesh& mesh, std::vector<int>& partOf, const Candidate& candidate, double share)
  {
    const Mouth from = OpenMouth(mesh, partOf, candidate.From, share);
    const Mouth to = OpenMouth(mesh, partOf, candidate.To, share);
    // The mouths run against each other; of the three ways to turn them the straightest.
    std::size_t best = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t turn = 0; turn < 3; ++turn)
    {
      double length = 0;
      for (std::size_t k = 0; k < 3; ++k)
      {
        length += Norm(mesh.Points[from[k]] - mesh.Points[to[(turn + 3 - k) % 3]]);
      }
      if (length < least)
      {
        least = length;
        best = turn;
      }
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t next = (k + 1) % 3;
      const int a = from[k];
      const int b = from[next];
      const int c = to[(best + 3 - next) % 3];
      const int d = to[(best + 3 - k) % 3];
      mesh.Triangles.push_back({ a, b, c });
      mesh.Triangles.push_back({ a, c, d });
      partOf.push_back(candidate.From);
      partOf.push_back(candidate.From);
    }
  }

  TriangleMesh& Mesh;
  const PlanarFrame& Frame;
  const std::vector<double>& Offsets;
  TriangleComponents Components; ///< of the mesh as it was
  std::vector<Point3> Middles;   ///< of its triangles
  int Tries = 0;
  SheetLinks Result;
};
}

SheetLinks LinkSheets(TriangleMesh& mesh, const PlanarFrame& frame,
  const std::vector<double>& offsets, const LinksWanted& wanted, Monitor& monitor)
{
  return Linker(mesh, frame, offsets).Link(wanted, monitor);
}
}
