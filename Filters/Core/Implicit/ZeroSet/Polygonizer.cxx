// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/Polygonizer.h"

#include "Base/Median.h"
#include "Base/Parallel.h"
#include "Base/PointGrid.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Implicit/ZeroSet/CubeCutter.h"
#include "Implicit/ZeroSet/EdgeRoots.h"
#include "Implicit/ZeroSet/MeshCleanUp.h"
#include "Implicit/ZeroSet/SurfaceTracker.h"
#include "Mesh/MassProperties.h"
#include "Mesh/TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace recon
{
namespace
{
/// A surface passes through about this many cells for every cell's face that it covers.
constexpr double CellsPerFace = 1.5;
/// The part of the bounds that is proposed where a cell was larger than all of them.
constexpr double LeastCellsAcross = 0.1;
/// Cells that are chosen are so small, and no smaller, that the seeds' diagonal has so many.
constexpr double FewestCellsAcross = 80;
constexpr double MostCellsAcross = 160;
/// The bounds that are chosen are the seeds' box and this part of its diagonal on all sides.
constexpr double RoomAround = 0.1;
/// Cells of previews, as parts of the diagonal of the seeds' bounding box, and how exactly coarse
/// ones cut the surface, in cells.
constexpr double MediumCells = 1.0 / 100;
constexpr double CoarseCells = 1.0 / 50;
constexpr double CoarseTolerance = 0.02;
/// A clean-up that leaves a smaller angle (degrees) says so.
constexpr double PromisedAngle = 1;
/// Where CellSize is to be chosen and cells miss walls or gaps that contours are on, cells smaller
/// by this factor are tried, for twice the triangles. They are kept where they leave at most so
/// many of the points missed.
constexpr double FinerCells = 0.7;
constexpr double WorthTheirPrice = 0.5;
/// Walls and gaps thinner than this part of a cell are not worth smaller cells: those would not
/// find them either.
constexpr double WorthFinding = 0.5;
/// A function that is off by more than this part of a cell at a point passes it by.
constexpr double PassedBy = 0.25;
/// Steps to a cell in which a wall or gap is measured.
constexpr int ThicknessSteps = 16;

/// body(i) for all items, in pieces that threads share.
template <typename Body>
void ForAll(std::size_t items, int threads, const Body& body, Monitor& monitor)
{
  constexpr std::size_t ItemsPerPiece = 4096; ///< of parallel work
  AbortMonitor stop(monitor);
  const auto run = [&](int piece)
  {
    const std::size_t from = static_cast<std::size_t>(piece) * ItemsPerPiece;
    for (std::size_t i = from; i < std::min(items, from + ItemsPerPiece); ++i)
    {
      body(i);
    }
  };
  ParallelFor(static_cast<int>((items + ItemsPerPiece - 1) / ItemsPerPiece), threads, run, stop,
    { 0, 1, "finding the surface's points" });
}

/// Puts points of edges that lie in the bounds there, to the last bit.
void PutOntoBounds(const CubeCutter& cutter, const Lattice& lattice, std::vector<Point3>& points)
{
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const LatticeEdge& edge = cutter.Edges()[i];
    const Point3 corner = lattice.At(edge.Corner);
    for (int a = 0; a < 3; ++a)
    {
      points[i][a] = ((edge.Direction >> a) & 1) != 0 ? points[i][a] : corner[a];
    }
  }
}

std::vector<CrossedEdge> CrossedEdgesOf(
  const CubeCutter& cutter, const SurfaceTracker& tracker, int threads, Monitor& monitor)
{
  std::vector<CrossedEdge> crossed(cutter.Edges().size());
  const auto cross = [&](std::size_t i)
  {
    const LatticeEdge& edge = cutter.Edges()[i];
    const LatticeIndex far = edge.Far();
    const double near = tracker.ValueAt(edge.Corner);
    const double other = tracker.ValueAt(far);
    const Point3 nearPlace = tracker.Grid().At(edge.Corner);
    const Point3 farPlace = tracker.Grid().At(far);
    crossed[i] = near > 0 ? CrossedEdge{ nearPlace, farPlace, near, other }
                          : CrossedEdge{ farPlace, nearPlace, other, near };
  };
  ForAll(crossed.size(), threads, cross, monitor);
  return crossed;
}

/// Normals of f's own surface. @param field not closed
std::vector<Vector3> OutwardNormals(const BoundedField& field, const std::vector<Point3>& points)
{
  std::vector<double> values;
  std::vector<Vector3> normals;
  field.Evaluate(points, values, normals);
  for (Vector3& n : normals)
  {
    const double steep = Norm(n);
    n = steep > 0 ? (-1 / steep) * n : Vector3{ 0, 0, 0 };
  }
  return normals;
}

/// The surface as the cells cut it.
struct CutSurface
{
  TriangleMesh Mesh;
  std::vector<char> Faces; ///< by triangle, as CubeCutter::Faces
};

CutSurface Track(const BoundedField& field, const std::vector<Point3>& seeds, double cellSize,
  const PolygonizerOptions& options, Monitor& monitor)
{
  SubMonitor tracking(monitor, 0, 0.5);
  const Lattice lattice(field.Box(), cellSize, field.Closed());
  const BoundedField open = field.Open();
  const SurfaceTracker tracker(open, lattice, seeds, options.MaximumCells, tracking);
  CubeCutter cutter(tracker);
  SubMonitor rooting(monitor, 0.5, 1);
  CutSurface surface;
  surface.Mesh.Points = FindRoots(open, CrossedEdgesOf(cutter, tracker, options.Threads, monitor),
    options.Tolerance * cellSize, rooting);
  PutOntoBounds(cutter, lattice, surface.Mesh.Points);
  surface.Mesh.Triangles = std::move(cutter.Triangles());
  surface.Faces = std::move(cutter.Faces());
  return surface;
}

/// The function's own normals on the wall and its rim, those of the bounds within flat ends.
std::vector<Vector3> NormalsOf(const BoundedField& field, const CutSurface& surface)
{
  std::vector<Vector3> normals = OutwardNormals(field.Open(), surface.Mesh.Points);
  std::vector<char> onWall(normals.size(), 0);
  const std::vector<std::array<int, 3>>& triangles = surface.Mesh.Triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (const int v : triangles[t])
    {
      onWall[v] = onWall[v] || surface.Faces[t] == 0;
    }
  }
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (const int v : triangles[t])
    {
      normals[v] = onWall[v] ? normals[v] : FaceNormal(surface.Faces[t]);
    }
  }
  return normals;
}

bool IsWithin(const Point3& p, const Bounds& box)
{
  for (int a = 0; a < 3; ++a)
  {
    if (!(p[a] >= box[2 * a] && p[a] <= box[2 * a + 1]))
    {
      return false;
    }
  }
  return true;
}

/// What of the contours no triangle is within a cell of.
struct FarPoints
{
  /// The function's surface passes by these, so that smaller cells would find it.
  std::vector<Point3> Missed;
  std::size_t Others = 0; ///< that the function itself passes elsewhere
};

/// Points within the bounds that are more than a cell away from the mesh.
FarPoints FindFarPoints(const BoundedField& field, const TriangleMesh& mesh,
  const std::vector<Point3>& points, double cellSize, int threads, Monitor& monitor)
{
  const TriangleTree tree(mesh);
  std::vector<char> isFar(points.size(), 0);
  const auto measure = [&](std::size_t i)
  {
    isFar[i] =
      IsWithin(points[i], field.Box()) && tree.DistanceTo(points[i], 2 * cellSize) > cellSize ? 1
                                                                                              : 0;
  };
  ForAll(points.size(), threads, measure, monitor);
  std::vector<Point3> far;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (isFar[i])
    {
      far.push_back(points[i]);
    }
  }
  // Smaller cells come no nearer to those that the function itself misses.
  std::vector<double> values;
  std::vector<Vector3> gradients;
  field.Evaluate(far, values, gradients);
  FarPoints found;
  for (std::size_t i = 0; i < far.size(); ++i)
  {
    if (std::abs(values[i]) < PassedBy * cellSize * Norm(gradients[i]))
    {
      found.Missed.push_back(far[i]);
    }
  }
  found.Others = far.size() - found.Missed.size();
  return found;
}

/// Is a point on a wall, or at a gap, that smaller cells can find? The way to the other
/// side is measured along the normal.
bool AnyWorthFinding(const BoundedField& field, const std::vector<Point3>& points, double cellSize)
{
  const std::vector<Vector3> normals = OutwardNormals(field, points);
  std::vector<Point3> probes;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (int k = -ThicknessSteps; k <= ThicknessSteps; ++k)
    {
      probes.push_back(points[i] + (k * cellSize / ThicknessSteps) * normals[i]);
    }
  }
  const std::vector<double> g = field.Values(probes);
  const int steps = 2 * ThicknessSteps + 1;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    int thinnest = ThicknessSteps + 1;
    for (int k = 1; k <= ThicknessSteps; ++k)
    {
      const std::size_t middle = i * steps + ThicknessSteps;
      const bool otherSide = g[middle + k] > 0 || g[middle - k] <= 0;
      thinnest = otherSide ? std::min(thinnest, k) : thinnest;
    }
    if (thinnest <= ThicknessSteps && thinnest >= WorthFinding * ThicknessSteps)
    {
      return true;
    }
  }
  return false;
}

/**
 * Tracks the surface, where CellSize is to be chosen with smaller cells where seeds or witnesses
 * are more than a cell away from it: between two sheets of the surface that are nearer than a cell
 * there may be no corner, and then neither is found.
 */
CutSurface TrackAndFind(const BoundedField& field, const std::vector<Point3>& seeds,
  const PolygonizerOptions& options, ImplicitMesh& result, Monitor& monitor)
{
  std::vector<Point3> all = seeds;
  all.insert(all.end(), options.Witnesses.begin(), options.Witnesses.end());
  SubMonitor tracking(monitor, 0, 0.3);
  CutSurface surface = Track(field, seeds, result.CellSize, options, tracking);
  FarPoints far =
    FindFarPoints(field, surface.Mesh, all, result.CellSize, options.Threads, monitor);
  const double finer = FinerCells * result.CellSize;
  const double finerTriangles =
    static_cast<double>(surface.Mesh.Triangles.size()) / (FinerCells * FinerCells);
  if (!far.Missed.empty() && options.CellSize == 0 && finerTriangles < options.MaximumCells &&
    AnyWorthFinding(field, far.Missed, result.CellSize))
  {
    SubMonitor again(monitor, 0.3, 0.6);
    CutSurface found = Track(field, seeds, finer, options, again);
    FarPoints stillFar = FindFarPoints(field, found.Mesh, all, finer, options.Threads, monitor);
    if (static_cast<double>(stillFar.Missed.size()) <=
      WorthTheirPrice * static_cast<double>(far.Missed.size()))
    {
      surface = std::move(found);
      result.CellSize = finer;
      far = std::move(stillFar);
    }
  }
  result.FarContourPoints = far.Missed.size() + far.Others;
  if (far.Others > 0)
  {
    result.Report.push_back(std::to_string(far.Others) + " of " + std::to_string(all.size()) +
      " points of contours and middles of their edges are more than a cell of " +
      Text(result.CellSize) +
      " away from the surface, because its constraints stand too far apart for what is drawn "
      "there: "
      "set ResampleSpacing to less than the thinnest wall or gap.");
  }
  if (!far.Missed.empty())
  {
    result.Report.push_back(std::to_string(far.Missed.size()) +
      " points of contours are more than a cell of " + Text(result.CellSize) +
      " away from the surface, as the shape, or a gap in it, is thinner than that there: choose a "
      "smaller CellSize.");
  }
  return surface;
}

/// The face of the bounds that a point lies in, to the last bit; 0 = none.
int FaceAt(const Point3& p, const Bounds& box)
{
  for (int side = 0; side < 6; ++side)
  {
    if (p[side / 2] == box[side])
    {
      return 1 + side;
    }
  }
  return 0;
}

void CleanUpMesh(const BoundedField& field, const std::vector<Point3>& seeds,
  const std::vector<char>& faces, const PolygonizerOptions& options, ImplicitMesh& result,
  Monitor& monitor)
{
  const double h = result.CellSize;
  const Projector project =
    [&](std::vector<Point3>& points, std::vector<Vector3>& normals, std::vector<char>& done)
  {
    monitor.Update(0.5, "cleaning up the mesh");
    const std::vector<Point3> asked = points;
    field.Project(points, normals, done, 0.5 * h, options.Tolerance * h);
    for (std::size_t i = 0; i < asked.size(); ++i)
    {
      // Points of a flat end move in it alone.
      const int face = field.Closed() ? FaceAt(asked[i], field.Box()) : 0;
      if (face > 0)
      {
        points[i] = asked[i];
        normals[i] = FaceNormal(face);
        done[i] = 1;
      }
    }
  };
  CleanUpOptions cleaning;
  cleaning.EdgeLength = h;
  cleaning.Faces = faces;
  cleaning.Threads = options.Threads;
  if (options.SnapToSeeds)
  {
    cleaning.Anchors = seeds;
  }
  const CleanUpResult cleaned = CleanUp(result.Mesh, result.Normals, project, cleaning, monitor);
  result.SmallestAngle = ComputeSmallestAngle(result.Mesh);
  if (result.SmallestAngle < PromisedAngle)
  {
    result.Report.push_back("A triangle's angle of " + Text(result.SmallestAngle) +
      " degrees could not be mended without moving the surface.");
  }
  if (cleaned.Crossing > 0)
  {
    result.Report.push_back(std::to_string(cleaned.Crossing) +
      " pairs of triangles cross each other: choose a smaller CellSize, or no CleanUp.");
  }
  if (options.SnapToSeeds && cleaned.Anchored < seeds.size())
  {
    result.Report.push_back(std::to_string(cleaned.Anchored) + " of " +
      std::to_string(seeds.size()) +
      " contour points became mesh points; the others lie closer together than CellSize.");
  }
}

/// What a preview does without; says so in the result's Report.
PolygonizerOptions WithDetail(const PolygonizerOptions& asked, ImplicitMesh& result)
{
  PolygonizerOptions options = asked;
  if (asked.Detail == PolygonizerOptions::Full)
  {
    return options;
  }
  options.CellSize = result.CellSize;
  const bool coarse = asked.Detail == PolygonizerOptions::Coarse;
  if (coarse)
  {
    options.CleanUp = false;
    options.SnapToSeeds = false;
    options.Tolerance = std::max(CoarseTolerance, asked.Tolerance);
  }
  result.Report.push_back("This is a preview with cells of " + Text(result.CellSize) +
    (coarse ? " and triangles as they come" : "") + ": set Detail to Full for the whole surface.");
  return options;
}

void CheckOptions(const PolygonizerOptions& options)
{
  if (!(options.Tolerance > 0 && options.Tolerance <= 0.1))
  {
    throw Error("The root tolerance must be a part of a cell, above 0 and at most 0.1.");
  }
}
}

double ChooseCellSize(const std::vector<Point3>& seeds, double asked)
{
  if (!(asked >= 0) || !std::isfinite(asked))
  {
    throw Error("CellSize must be positive, or 0 to have it chosen, and a finite number.");
  }
  if (asked > 0)
  {
    return asked;
  }
  const double diagonal = DiagonalOf(BoundsOf(seeds));
  if (!(diagonal > 0))
  {
    throw Error("All seeds are one point, which gives no cell size: set CellSize.");
  }
  const double coarsest = diagonal / FewestCellsAcross;
  const PointGrid grid(seeds, coarsest);
  std::vector<double> spacings;
  for (std::size_t i = 0; i < seeds.size(); ++i)
  {
    double least = coarsest * coarsest;
    grid.ForNear(seeds[i], coarsest,
      [&](int j, double r2)
      {
        if (j != static_cast<int>(i) && r2 > 0)
        {
          least = std::min(least, r2);
        }
      });
    spacings.push_back(std::sqrt(least));
  }
  return std::min(coarsest, std::max(diagonal / MostCellsAcross, Median(std::move(spacings))));
}

double ChooseCellSize(const std::vector<Point3>& seeds, const PolygonizerOptions& options)
{
  const double size = ChooseCellSize(seeds, options.CellSize);
  if (options.Detail == PolygonizerOptions::Full)
  {
    return size;
  }
  const double part = options.Detail == PolygonizerOptions::Medium ? MediumCells : CoarseCells;
  return std::max(size, part * DiagonalOf(BoundsOf(seeds)));
}

Bounds ChooseBounds(const std::vector<Point3>& seeds, const std::optional<Bounds>& asked)
{
  if (asked)
  {
    CheckBounds(*asked);
    return *asked;
  }
  Bounds box = BoundsOf(seeds);
  const double margin = RoomAround * DiagonalOf(box);
  for (int a = 0; a < 3; ++a)
  {
    box[2 * a] -= margin;
    box[2 * a + 1] += margin;
  }
  CheckBounds(box);
  return box;
}

void CheckCellCount(const Bounds& ofSeeds, const Bounds& box, double cellSize, double maximumCells)
{
  if (!(maximumCells >= 1) || !std::isfinite(maximumCells))
  {
    throw Error("MaximumCells must be at least 1, and a finite number.");
  }
  std::array<double, 3> side{};
  double longest = 0;
  for (int a = 0; a < 3; ++a)
  {
    const double low = std::max(ofSeeds[2 * a], box[2 * a]);
    const double high = std::min(ofSeeds[2 * a + 1], box[2 * a + 1]);
    side[a] = std::max(0.0, high - low);
    longest = std::max(longest, box[2 * a + 1] - box[2 * a]);
  }
  if (cellSize > longest)
  {
    throw Error("CellSize " + Text(cellSize) + " is larger than the bounds: choose less than " +
      Text(LeastCellsAcross * longest) + ", or 0 to have it chosen.");
  }
  const double area = 2 * (side[0] * side[1] + side[1] * side[2] + side[2] * side[0]);
  const double cells = CellsPerFace * area / (cellSize * cellSize);
  if (cells > maximumCells || longest / cellSize > Lattice::MaximumCells)
  {
    const double enough =
      std::max(std::sqrt(CellsPerFace * area / maximumCells), longest / Lattice::MaximumCells);
    throw Error("CellSize " + Text(cellSize) + " would take about " + Text(cells) +
      " cells, more than the " + Text(maximumCells) + " allowed: choose " + Text(1.01 * enough) +
      " or more, or smaller bounds.");
  }
}

std::vector<Point3> SeedsOf(const ImplicitFunction& function)
{
  std::vector<Point3> seeds;
  for (std::size_t j = 0; j < function.Centres.size(); ++j)
  {
    if (j < function.Values.size() && function.Values[j] == 0)
    {
      seeds.push_back(function.Centres[j]);
    }
  }
  if (seeds.empty())
  {
    throw Error(
      "The model has no constraint of value 0, so there is no point of the surface to start from: "
      "fit it to constraints made of contours.");
  }
  return seeds;
}

ImplicitMesh Polygonize(const ImplicitFunction& function, const std::vector<Point3>& seeds,
  const PolygonizerOptions& asked, Monitor& monitor)
{
  CheckOptions(asked);
  function.Validate();
  ImplicitMesh result;
  const Bounds box = ChooseBounds(seeds, asked.Box);
  result.CellSize = ChooseCellSize(seeds, asked);
  CheckCellCount(BoundsOf(seeds), box, result.CellSize, asked.MaximumCells);
  const PolygonizerOptions options = WithDetail(asked, result);

  const BoundedField field(function, box, options.ClosedAtBounds, options.Threads, monitor);
  CutSurface surface = TrackAndFind(field, seeds, options, result, monitor);
  result.Normals = NormalsOf(field, surface);
  result.Mesh = std::move(surface.Mesh);
  if (options.CleanUp)
  {
    SubMonitor cleaning(monitor, 0.6, 1);
    CleanUpMesh(field, seeds, surface.Faces, options, result, cleaning);
  }
  else
  {
    result.SmallestAngle = ComputeSmallestAngle(result.Mesh);
  }
  monitor.Update(1, "cleaning up the mesh");
  return result;
}
}
