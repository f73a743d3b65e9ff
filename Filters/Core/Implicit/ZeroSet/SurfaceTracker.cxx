// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/SurfaceTracker.h"

namespace recon
{
namespace
{
/// The value of corners beyond the bounds: outside.
constexpr double Beyond = -1;

LatticeIndex CornerOf(const LatticeIndex& cube, int corner)
{
  return { cube[0] + (corner & 1), cube[1] + ((corner >> 1) & 1), cube[2] + ((corner >> 2) & 1) };
}
}

SurfaceTracker::SurfaceTracker(const BoundedField& field, const Lattice& lattice,
  const std::vector<Point3>& seeds, double maximumCubes, Monitor& monitor)
  : Field(field),
    Cells(lattice)
{
  monitor.Update(0, "following the surface");
  CubeList wave = this->SeedCubes(seeds);
  // How far the end is cannot be known: the bar nears its end as the waves grow smaller.
  while (!wave.empty())
  {
    this->EvaluateCorners(wave);
    wave = this->Next(wave);
    if (static_cast<double>(this->Active.size()) > maximumCubes)
    {
      throw Error("The surface passes through more than " +
        std::to_string(static_cast<long long>(maximumCubes)) +
        " cells: choose a larger CellSize or smaller bounds.");
    }
    const double done = static_cast<double>(this->Active.size());
    monitor.Update(
      done / (done + 8.0 * static_cast<double>(wave.size()) + 1), "following the surface");
  }
  if (this->Active.empty())
  {
    throw Error(
      "No surface passes near the contours: the shape is thinner than CellSize everywhere, or lies "
      "outside the bounds; choose a smaller CellSize or larger bounds.");
  }
  for (const LatticeIndex& cube : this->Active)
  {
    this->ActiveKeys.insert(Lattice::Key(cube));
  }
  // What is smaller than a cube may have no corner in it, but has seeds.
  for (const Point3& seed : seeds)
  {
    const LatticeIndex cube = this->Cells.CubeOf(seed);
    if (this->Cells.HasCube(cube))
    {
      this->ActiveKeys.insert(Lattice::Key(cube));
    }
  }
  monitor.Update(1, "following the surface");
}

void SurfaceTracker::PushNew(const LatticeIndex& cube, CubeList& list)
{
  if (this->Cells.HasCube(cube) && this->Visited.insert(Lattice::Key(cube)).second)
  {
    list.push_back(cube);
  }
}

/// The cubes of the seeds, and the neighbours of those whose own corners are all on one side.
SurfaceTracker::CubeList SurfaceTracker::SeedCubes(const std::vector<Point3>& seeds)
{
  CubeList own;
  std::unordered_set<std::uint64_t, LatticeHash> seen;
  for (const Point3& seed : seeds)
  {
    const LatticeIndex cube = this->Cells.CubeOf(seed);
    if (this->Cells.HasCube(cube) && seen.insert(Lattice::Key(cube)).second)
    {
      own.push_back(cube);
    }
  }
  this->EvaluateCorners(own);
  CubeList wave;
  CubeList around;
  for (const LatticeIndex& cube : own)
  {
    if (this->IsMixed(cube))
    {
      this->PushNew(cube, wave);
      continue;
    }
    for (int i = 0; i < 27; ++i)
    {
      const LatticeIndex near{ cube[0] + i % 3 - 1, cube[1] + i / 3 % 3 - 1, cube[2] + i / 9 - 1 };
      if (this->Cells.HasCube(near))
      {
        around.push_back(near);
      }
    }
  }
  this->EvaluateCorners(around);
  for (const LatticeIndex& cube : around)
  {
    if (this->IsMixed(cube))
    {
      this->PushNew(cube, wave);
    }
  }
  return wave;
}

void SurfaceTracker::EvaluateCorners(const CubeList& cubes)
{
  std::vector<std::uint64_t> keys;
  std::vector<Point3> points;
  for (const LatticeIndex& cube : cubes)
  {
    for (int c = 0; c < 8; ++c)
    {
      const LatticeIndex corner = CornerOf(cube, c);
      const std::uint64_t key = Lattice::Key(corner);
      if (this->Values.emplace(key, Beyond).second && !this->Cells.IsBeyond(corner))
      {
        keys.push_back(key);
        points.push_back(this->Cells.At(corner));
      }
    }
  }
  const std::vector<double> values = this->Field.Values(points);
  for (std::size_t i = 0; i < keys.size(); ++i)
  {
    this->Values[keys[i]] = values[i];
  }
}

bool SurfaceTracker::IsMixed(const LatticeIndex& cube) const
{
  const bool first = this->IsInside(cube);
  for (int c = 1; c < 8; ++c)
  {
    if (this->IsInside(CornerOf(cube, c)) != first)
    {
      return true;
    }
  }
  return false;
}

bool SurfaceTracker::FaceIsMixed(const LatticeIndex& cube, int axis, int side) const
{
  int inside = 0;
  for (int c = 0; c < 8; ++c)
  {
    if (((c >> axis) & 1) == side)
    {
      inside += this->IsInside(CornerOf(cube, c)) ? 1 : 0;
    }
  }
  return inside > 0 && inside < 4;
}

SurfaceTracker::CubeList SurfaceTracker::Next(const CubeList& wave)
{
  CubeList next;
  for (const LatticeIndex& cube : wave)
  {
    if (!this->IsMixed(cube))
    {
      continue;
    }
    this->Active.push_back(cube);
    for (int axis = 0; axis < 3; ++axis)
    {
      for (int side = 0; side < 2; ++side)
      {
        if (this->FaceIsMixed(cube, axis, side))
        {
          LatticeIndex beside = cube;
          beside[axis] += side == 1 ? 1 : -1;
          this->PushNew(beside, next);
        }
      }
    }
  }
  return next;
}

bool SurfaceTracker::Near(const Point3& p) const
{
  const LatticeIndex cube = this->Cells.CubeOf(p);
  for (int i = 0; i < 27; ++i)
  {
    const LatticeIndex near{ cube[0] + i % 3 - 1, cube[1] + i / 3 % 3 - 1, cube[2] + i / 9 - 1 };
    if (this->Cells.HasCube(near) && this->ActiveKeys.count(Lattice::Key(near)) > 0)
    {
      return true;
    }
  }
  return false;
}
}
