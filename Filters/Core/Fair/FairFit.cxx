// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairFit.h"

#include "Base/Angles.h"
#include "Base/Parallel.h"
#include "Base/SubMonitor.h"
#include "Fair/EvenPasses.h"
#include "Fair/LocalTension.h"
#include "Fair/UncrossedMove.h"
#include "Mesh/TriangleTree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace recon
{
namespace
{
/// A sample is looked for on the mesh within so many edge lengths.
constexpr double Reach = 2;
/// Pulls that miss get so many times the weight, so many times.
constexpr double MoreWeight = 10;
constexpr int LeastSolves = 2;
constexpr int MostSolves = 3;
/// So many times the bend is evened out, in the first solve, which lengths and tension are taken from, and in later
/// ones.
constexpr int FirstEvenings = 1;
constexpr int Evenings = 3;
/// Passes over the samples that are too far, which are brought to this part of the tolerance; rounds of
/// passes with what crosses, or becomes thin, taken back; and after these rounds in which angles may
/// become small, as the tolerance comes first.
constexpr int Passes = 12;
constexpr double PartOfTolerance = 0.7;
constexpr int Rounds = 3;
constexpr int AnyAngleRounds = 2;
constexpr std::size_t SamplesABlock = 256;

std::vector<SurfacePlace> PlacesOf(const SurfacePlaces& surface,
  const std::vector<ContourSample>& samples, double radius, int threads, Monitor& monitor)
{
  std::vector<SurfacePlace> places(samples.size());
  ParallelForBlocks(samples.size(), SamplesABlock, threads,
    [&](std::size_t from, std::size_t to)
    {
      for (std::size_t i = from; i < to; ++i)
      {
        places[i] = surface.Nearest(samples[i].Place, samples[i].Outward, radius);
      }
    },
    monitor, { 0, 0, "fairing" });
  return places;
}

/// From the places that are nearest by now, with more weight where they miss. @returns how many do
std::size_t PullAgain(const SurfacePlaces& surface, std::vector<Pull>& pulls,
  const FairFitOptions& options, Monitor& monitor)
{
  std::vector<char> misses(pulls.size(), 0);
  ParallelForBlocks(pulls.size(), SamplesABlock, options.Threads,
    [&](std::size_t from, std::size_t to)
    {
      for (std::size_t i = from; i < to; ++i)
      {
        Pull& pull = pulls[i];
        const SurfacePlace place =
          surface.Nearest(pull.To, pull.Outward, Reach * options.EdgeLength);
        misses[i] = place.Triangle < 0 || place.Distance > options.Tolerance ? 1 : 0;
        pull.From = place.Triangle < 0 ? pull.From : place;
        pull.Weight *= misses[i] ? MoreWeight : 1;
      }
    },
    monitor, { 0, 0, "fairing" });
  return std::count(misses.begin(), misses.end(), 1);
}

/// By as little as takes the place there: a corner by its share.
void Take(TriangleMesh& mesh, const SurfacePlace& place, const Vector3& way)
{
  double squares = 0;
  for (const double share : place.Shares)
  {
    squares += share * share;
  }
  for (int k = 0; k < 3; ++k)
  {
    Point3& corner = mesh.Points[mesh.Triangles[place.Triangle][k]];
    corner = corner + (place.Shares[k] / squares) * way;
  }
}
}

SampleMisfit MeasureMisfit(const TriangleMesh& mesh, const std::vector<ContourSample>& samples,
  double tolerance, int threads, Monitor& monitor)
{
  const TriangleTree tree(mesh);
  std::vector<double> distances(samples.size(), 0);
  ParallelForBlocks(samples.size(), SamplesABlock, threads,
    [&](std::size_t from, std::size_t to)
    {
      for (std::size_t i = from; i < to; ++i)
      {
        distances[i] = samples[i].IsVertex
          ? tree.DistanceTo(samples[i].Place, std::numeric_limits<double>::max())
          : 0;
      }
    },
    monitor, { 0, 0, "fairing" });
  SampleMisfit misfit;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    misfit.Farthest = std::max(misfit.Farthest, distances[i]);
    misfit.Beyond += distances[i] > tolerance ? 1 : 0;
  }
  return misfit;
}

std::vector<Pull> PullsOf(const SurfacePlaces& surface, const std::vector<ContourSample>& samples,
  const FairFitOptions& options, Monitor& monitor)
{
  const std::vector<SurfacePlace> places =
    PlacesOf(surface, samples, Reach * options.EdgeLength, options.Threads, monitor);
  std::vector<Pull> pulls;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (places[i].Triangle >= 0)
    {
      const double smaller = std::max(1.0, options.Scale / samples[i].Radius);
      const double asLarge = std::min(options.MostWeight, options.Weight * std::pow(smaller, 3));
      const double weight = samples[i].Length * std::max(options.Weight, asLarge);
      pulls.push_back({ places[i], samples[i].Place, samples[i].Outward, weight });
    }
  }
  return pulls;
}

FairSolution SolveWithin(const TriangleMesh& mesh, std::vector<Pull>& pulls, double tension,
  const FairFitOptions& options, Monitor& monitor)
{
  AbortMonitor silent(monitor);
  std::vector<double> tensions(mesh.Points.size(), tension < 0 ? FirstTension : tension);
  TriangleMesh moved = mesh;
  FairSystem system(mesh, options.Kept, options.Scale, options.Threads, silent);
  for (int solve = 0; solve < MostSolves; ++solve)
  {
    monitor.Update(static_cast<double>(solve) / MostSolves, "fairing");
    if (solve > 0 && tension < 0)
    {
      tensions = TensionByBend(mesh, system.BendOf(mesh.Points), system.BendOf(moved.Points),
        options.Scale / options.EdgeLength);
    }
    moved.Points =
      system.Solve(moved.Points, pulls, tensions, solve == 0 ? FirstEvenings : Evenings);
    const std::size_t missed = PullAgain(SurfacePlaces(moved), pulls, options, silent);
    if (missed == 0 && solve + 1 >= LeastSolves)
    {
      break;
    }
  }
  const double sum = std::accumulate(tensions.begin(), tensions.end(), 0.0);
  return { std::move(moved.Points), sum / static_cast<double>(tensions.size()) };
}

PulledMesh PullWithin(const TriangleMesh& mesh, const std::vector<ContourSample>& samples,
  const FairFitOptions& options, Monitor& monitor)
{
  PulledMesh result{ mesh, false };
  TriangleMesh& pulled = result.Mesh;
  for (int round = 0; round < Rounds + AnyAngleRounds; ++round)
  {
    const SurfacePlaces surface(pulled);
    const std::vector<SurfacePlace> places =
      PlacesOf(surface, samples, Reach * options.EdgeLength, options.Threads, monitor);
    TriangleMesh moved = pulled;
    std::size_t taken = 0;
    for (int pass = 0; pass < Passes; ++pass)
    {
      monitor.Update(0, "fairing");
      for (std::size_t i = 0; i < samples.size(); ++i)
      {
        if (!samples[i].IsVertex || places[i].Triangle < 0)
        {
          continue;
        }
        const Vector3 way = samples[i].Place - places[i].On(moved);
        const double distance = Norm(way);
        if (distance > options.Tolerance)
        {
          Take(moved, places[i], (1 - PartOfTolerance * options.Tolerance / distance) * way);
          ++taken;
        }
      }
    }
    if (taken == 0)
    {
      result.IsWithin = std::none_of(places.begin(), places.end(),
        [&](const SurfacePlace& place)
        { return samples[&place - places.data()].IsVertex && place.Triangle < 0; });
      break;
    }
    const double leastAngle = round < Rounds ? FairLeastAngle * Pi / 180 : 0;
    pulled = MoveUncrossed(pulled, moved.Points, leastAngle, {}, options.Threads, monitor).Mesh;
  }
  return result;
}
}
