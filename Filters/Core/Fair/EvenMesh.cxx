// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/EvenMesh.h"

#include "Base/PointGrid.h"
#include "Base/SubMonitor.h"
#include "Fair/EvenPasses.h"
#include "Fair/SurfacePlaces.h"
#include "Implicit/ZeroSet/CrossingGuard.h"
#include "Mesh/SelfIntersections.h"

#include <algorithm>

namespace recon
{
namespace
{
constexpr int Rounds = 2; ///< of splits, collapses and flips
/// Where sheets are nearer than so many edge lengths, changes are looked at.
constexpr double ThinPlace = 0.7;
/// Where triangles cross all the same, it is begun again with changes looked at so many edge lengths
/// around, and in the last attempt everywhere.
constexpr double AroundCrossing = 4;
constexpr int MostAttempts = 4;

class Evener
{
public:
  Evener(const TriangleMesh& given, const std::vector<char>& parts, const PlacesToKeep& keep,
    double edgeLength, int threads, Monitor& monitor)
    : Given(given),
      Parts(parts),
      Keep(keep),
      Surface(given),
      EdgeLength(edgeLength),
      Threads(threads),
      Observer(monitor)
  {
  }

  EvenMesh Make()
  {
    AbortMonitor silent(this->Observer);
    EvenMesh even;
    for (int attempt = 0; attempt < MostAttempts; ++attempt)
    {
      this->Observer.Update(static_cast<double>(attempt) / MostAttempts, "making the mesh even");
      this->Once(attempt + 1 == MostAttempts, silent, even);
      even.Crossing = this->FindCrossings(even.Mesh, silent);
      if (even.Crossing == 0)
      {
        break;
      }
    }
    return even;
  }

private:
  void Once(bool lookEverywhere, Monitor& silent, EvenMesh& even) const
  {
    EvenPasses passes(this->Given, this->Parts, &this->Surface, this->Keep, this->EdgeLength,
      this->Threads, silent);
    // Nothing is known of what is near before edges are short, so the last attempt looks at once.
    std::fill(passes.Thin.begin(), passes.Thin.end(), lookEverywhere ? 1 : 0);
    passes.CollapseShort();
    passes.SplitLong();
    this->MarkThin(passes, lookEverywhere);
    for (int round = 0; round < Rounds; ++round)
    {
      passes.SplitLong();
      passes.CollapseShort();
      passes.Flip();
      passes.Spread();
      passes.Flip();
    }
    passes.MendSlivers();
    passes.Spread();
    passes.Flip();
    passes.MendSlivers();
    even.Mesh = passes.Mesh.Compact();
    even.Parts = passes.Mesh.CompactParts();
  }

  void MarkThin(EvenPasses& passes, bool everywhere) const
  {
    passes.Thin = ThinPlaces(passes.Mesh.Points, passes.Normals, ThinPlace * this->EdgeLength);
    if (everywhere)
    {
      std::fill(passes.Thin.begin(), passes.Thin.end(), 1);
      return;
    }
    const double radius = AroundCrossing * this->EdgeLength;
    const PointGrid grid(passes.Mesh.Points, radius);
    for (const Point3& p : this->Crossed)
    {
      grid.ForNear(p, radius, [&](int v, double) { passes.Thin[v] = 1; });
    }
  }

  std::int64_t FindCrossings(const TriangleMesh& mesh, Monitor& silent)
  {
    SelfIntersectionOptions options;
    options.Threads = this->Threads;
    const SelfIntersections found = FindSelfIntersections(mesh, options, silent);
    for (const IntersectingPair& pair : found.Pairs)
    {
      if (pair.Kind != IntersectingPair::Touching)
      {
        this->Crossed.push_back(mesh.Points[mesh.Triangles[pair.First][0]]);
      }
    }
    return found.Crossing + found.Overlapping;
  }

  const TriangleMesh& Given;
  const std::vector<char>& Parts;
  const PlacesToKeep& Keep;
  SurfacePlaces Surface;
  double EdgeLength;
  int Threads;
  Monitor& Observer;
  std::vector<Point3> Crossed; ///< places of triangles that crossed in earlier attempts
};
}

EvenMesh MakeEvenMesh(const TriangleMesh& given, const std::vector<char>& parts,
  const PlacesToKeep& keep, double edgeLength, int threads, Monitor& monitor)
{
  return Evener(given, parts, keep, edgeLength, threads, monitor).Make();
}

TriangleMesh MendMesh(const TriangleMesh& given, const std::vector<char>& parts,
  const PlacesToKeep& keep, double edgeLength, int threads, Monitor& monitor)
{
  EvenPasses passes(given, parts, nullptr, keep, edgeLength, threads, monitor);
  // Every change is looked at, so nothing crosses that did not before.
  std::fill(passes.Thin.begin(), passes.Thin.end(), 1);
  passes.Flip();
  passes.MendSlivers();
  return passes.Mesh.Compact();
}
}
