// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/KeptPlaces.h"

#include "Base/Parallel.h"
#include "Fair/SurfacePlaces.h"
#include "Mesh/TriangleTree.h"

#include <algorithm>
#include <limits>

namespace recon
{
namespace
{
/// What a thread takes at once.
constexpr std::size_t PlacesABlock = 256;
}

double PlacesToKeep::DistanceTo(
  const Point3& place, const Point3& a, const Point3& b, const Point3& c) const
{
  if (this->Within > 0)
  {
    return NearestOfTriangle(place, a, b, c).Distance;
  }
  // A height that is rounded to nothing does not count.
  return place == a || place == b || place == c ? 0 : std::numeric_limits<double>::infinity();
}

std::vector<int> FindWitnesses(
  const TriangleMesh& mesh, const PlacesToKeep& keep, int threads, Monitor& monitor)
{
  const TriangleTree tree(mesh);
  std::vector<int> witnesses(keep.Places.size(), -1);
  ParallelForBlocks(keep.Places.size(), PlacesABlock, threads,
    [&](std::size_t from, std::size_t to)
    {
      for (std::size_t i = from; i < to; ++i)
      {
        const Point3& p = keep.Places[i];
        double least = keep.Within;
        const auto look = [&](int t)
        {
          const auto& corners = mesh.Triangles[t];
          const double distance = keep.DistanceTo(
            p, mesh.Points[corners[0]], mesh.Points[corners[1]], mesh.Points[corners[2]]);
          const bool isFirst = distance == least && (witnesses[i] < 0 || t < witnesses[i]);
          if (distance < least || isFirst)
          {
            least = distance;
            witnesses[i] = t;
          }
        };
        tree.VisitMeeting(Box3(p, p).Grown(keep.Within), look);
      }
    },
    monitor, { 0, 0, "fairing" });
  return witnesses;
}

KeptPlaces::KeptPlaces(
  const LinkedMesh& mesh, const PlacesToKeep& keep, int threads, Monitor& monitor)
  : Mesh(mesh),
    Keep(keep),
    First(mesh.Triangles.size(), -1),
    Next(keep.Places.size(), -1)
{
  const std::vector<int> witnesses = FindWitnesses(mesh.Mesh, keep, threads, monitor);
  for (std::size_t i = 0; i < witnesses.size(); ++i)
  {
    if (witnesses[i] >= 0)
    {
      this->Give(static_cast<int>(i), witnesses[i]);
    }
  }
}

double KeptPlaces::DistanceTo(int place, const Triangle& t) const
{
  const auto& points = this->Mesh.Points;
  return this->Keep.DistanceTo(this->Keep.Places[place], points[t[0]], points[t[1]], points[t[2]]);
}

void KeptPlaces::Gather(const std::vector<int>& triangles)
{
  this->Gathered.clear();
  this->Before = triangles;
  for (const int t : triangles)
  {
    for (int i = t < static_cast<int>(this->First.size()) ? this->First[t] : -1; i >= 0;
         i = this->Next[i])
    {
      this->Gathered.push_back(i);
    }
  }
}

void KeptPlaces::Give(int place, int triangle)
{
  if (triangle >= static_cast<int>(this->First.size()))
  {
    this->First.resize(this->Mesh.Triangles.size(), -1);
  }
  this->Next[place] = this->First[triangle];
  this->First[triangle] = place;
}

/// Among the triangles that do not change, around the corners of those that do; -1: none is.
int KeptPlaces::WitnessBeside(int place, const std::vector<Change>& after) const
{
  for (const Change& change : after)
  {
    for (const int v : change.second)
    {
      for (const int t : this->Mesh.Around(v))
      {
        if (std::find(this->Before.begin(), this->Before.end(), t) == this->Before.end() &&
          this->DistanceTo(place, this->Mesh.Triangles[t]) <= this->Keep.Within)
        {
          return t;
        }
      }
    }
  }
  return -1;
}

bool KeptPlaces::MayChange(const std::vector<int>& before, const std::vector<Change>& after)
{
  this->Gather(before);
  this->Pending.clear();
  for (const int place : this->Gathered)
  {
    const auto isNear = [&](const Change& change)
    { return this->DistanceTo(place, change.second) <= this->Keep.Within; };
    const auto found = std::find_if(after.begin(), after.end(), isNear);
    const int witness = found != after.end() ? found->first : this->WitnessBeside(place, after);
    if (witness < 0)
    {
      return false;
    }
    this->Pending.emplace_back(place, witness);
  }
  return true;
}

void KeptPlaces::Commit()
{
  if (this->Pending.empty())
  {
    return;
  }
  for (const int t : this->Before)
  {
    if (t < static_cast<int>(this->First.size()))
    {
      this->First[t] = -1;
    }
  }
  for (const auto& [place, witness] : this->Pending)
  {
    this->Give(place, witness);
  }
}

void KeptPlaces::TakeCut(const std::vector<int>& triangles)
{
  this->Gather(triangles);
  this->Pending.clear();
  for (const int place : this->Gathered)
  {
    int nearest = triangles.front();
    double least = this->DistanceTo(place, this->Mesh.Triangles[nearest]);
    for (const int t : triangles)
    {
      const double distance = this->DistanceTo(place, this->Mesh.Triangles[t]);
      nearest = distance < least ? t : nearest;
      least = std::min(least, distance);
    }
    this->Pending.emplace_back(place, nearest);
  }
  this->Commit();
}
}
