// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairSurface.h"

#include "Base/Angles.h"
#include "Base/PointGrid.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Fair/EvenMesh.h"
#include "Fair/EvenPasses.h"
#include "Fair/FairFit.h"
#include "Fair/StaircaseStep.h"
#include "Fair/TracedRaster.h"
#include "Fair/UncrossedMove.h"
#include "Mesh/TriangleComponents.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace recon
{
namespace
{
/// Of the slices' distance: edges, down to the second where triangles are few, and how far the surface
/// may be from contours that were drawn.
constexpr double EdgePart = 0.3;
constexpr double LeastEdgePart = 0.15;
constexpr double TolerancePart = 0.05;
/// Edges are shorter where triangles are fewer than the first, which costs little and is nearer; they
/// become longer rather than triangles more than the second, as memory and time grow faster than these.
constexpr double FewTriangles = 25000;
constexpr double MostTriangles = 150000;
/// More are refused: twenty times what automatic lengths come to, and the end of what an edge length can ask for.
constexpr double MostTrianglesAtAll = 3e6;
/// Of the slices' distance, how far from the rim of a flat end the polyhedral surface's bend is kept: all
/// of it up to the half of this, then less.
constexpr double EndReach = 1.5;
/// Of the pitch of the raster that contours were traced on: edges are no shorter, as what is smaller
/// was not drawn.
constexpr double RasterEdgePart = 0.8;
/// How far the surface may be from contours that were traced on a raster, of what they are unsteady by.
constexpr double UnsteadyTolerance = 2.5;
/// Of pulls: drawn contours are followed, the staircase of pixels is evened out.
constexpr double DrawnWeight = 1e4;
constexpr double StaircaseWeight = 30;
/// Of a staircase's step, how far the surface may leave it.
constexpr double StaircaseTolerance = 0.5;
/// Of the tolerance, within which the even mesh passes the contours' vertices, so that what is held back
/// can come to lie there; to which they are pulled; and all but what may be rounding.
constexpr double EvenPart = 0.9;
constexpr double FitPart = 0.99;
constexpr double KeptPart = 0.999;
/// Of the largest coordinate: tolerances below are none.
constexpr double Rounding = 1e-12;

double AreaOf(const TriangleMesh& mesh)
{
  double area = 0;
  for (const auto& t : mesh.Triangles)
  {
    area += 0.5 *
      Norm(Cross(mesh.Points[t[1]] - mesh.Points[t[0]], mesh.Points[t[2]] - mesh.Points[t[0]]));
  }
  return area;
}

/// About how many triangles with such edges take the place of the given ones: equilateral ones of the
/// same area, and at least as many along a needle as its sides have edges.
double TrianglesOf(const TriangleMesh& mesh, double edgeLength)
{
  double along = 0;
  for (const auto& t : mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      // A side is two triangles'.
      along += 0.5 * Norm(mesh.Points[t[(k + 1) % 3]] - mesh.Points[t[k]]) / edgeLength;
    }
  }
  return along + AreaOf(mesh) * 4 / (std::sqrt(3.0) * edgeLength * edgeLength);
}

/// @throws Error where that would be more than there may be
void CheckTriangles(const TriangleMesh& mesh, double edgeLength)
{
  const double wanted = TrianglesOf(mesh, edgeLength);
  if (!(wanted <= MostTrianglesAtAll))
  {
    throw Error("Edges of " + Text(edgeLength) + " would make about " + Text(wanted) +
      " triangles, more than the " + Text(MostTrianglesAtAll) +
      " allowed: choose a larger Edge Length.");
  }
}

/// From contours to a surface, step by step.
class Fairer
{
public:
  Fairer(const ContourSet& contours, const FairOptions& options, Monitor& monitor)
    : Contours(contours),
      Options(options),
      Observer(monitor),
      Silent(monitor),
      Spacing(contours.Spacing()),
      Step(StaircaseStep(contours)),
      Raster(FindTracedRaster(contours))
  {
  }

  FairSurface Make()
  {
    this->BuildPolyhedral();
    if (this->Polyhedral.Mesh.Triangles.empty())
    {
      return std::move(this->Result);
    }
    this->ChooseLengths();
    this->Timed("even mesh", [&] { this->MakeEven(); });
    this->Timed("fair", [&] { this->Fair(); });
    this->Timed("keep within tolerance", [&] { this->Finish(); });
    this->Tell();
    this->Observer.Update(1, "fairing");
    return std::move(this->Result);
  }

private:
  template <typename Work>
  void Timed(const char* name, const Work& work)
  {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    this->Result.StageSeconds.emplace_back(name, seconds.count());
  }

  void BuildPolyhedral()
  {
    SubMonitor part(this->Observer, 0, 0.2);
    PolyhedralOptions options = this->Options.Polyhedral;
    options.Threads = this->Options.Threads;
    this->Polyhedral = BuildPolyhedralSurface(this->Contours, options, part);
    this->Result.Report = this->Polyhedral.Report;
    this->Result.StageSeconds = this->Polyhedral.StageSeconds;
    this->Result.EndCapVolume = this->Polyhedral.EndCapVolume;
    this->Result.IsolatedVolume = this->Polyhedral.IsolatedVolume;
    this->CountLeftOut();
  }

  void CountLeftOut()
  {
    std::vector<Point3> points = this->Polyhedral.Mesh.Points;
    std::sort(points.begin(), points.end());
    this->Result.LeftOut =
      std::count_if(this->Contours.Contours.begin(), this->Contours.Contours.end(),
        [&](const Contour& contour)
        {
          return std::none_of(contour.Points.begin(), contour.Points.end(),
            [&](int p)
            { return std::binary_search(points.begin(), points.end(), this->Contours.Points[p]); });
        });
  }

  void ChooseLengths()
  {
    this->Result.EdgeLength = this->Options.EdgeLength > 0
      ? this->Options.EdgeLength
      : std::max(AutomaticEdgeLength(this->Polyhedral.Mesh, this->Spacing),
          RasterEdgePart * this->Raster.Pitch);
    CheckTriangles(this->Polyhedral.Mesh, this->Result.EdgeLength);
    const double ofStaircase = StaircaseTolerance * this->Step;
    const double ofRaster = UnsteadyTolerance * this->Raster.Unsteadiness;
    const double ofDrawn = TolerancePart * this->Spacing;
    const bool isUneven = this->Step > 0 || ofRaster > ofDrawn;
    this->Result.Tolerance = this->Options.Tolerance >= 0 ? this->Options.Tolerance
      : this->Step > 0                                    ? ofStaircase
                                                          : std::max(ofDrawn, ofRaster);
    this->Fit.Tolerance = FitPart * this->Result.Tolerance;
    this->Fit.EdgeLength = this->Result.EdgeLength;
    this->Fit.Weight = isUneven && this->Result.Tolerance > 0 ? StaircaseWeight : DrawnWeight;
    this->Fit.MostWeight = DrawnWeight;
    this->Fit.Scale = this->Spacing;
    this->Fit.Threads = this->Options.Threads;
  }

  void MakeEven()
  {
    SubMonitor part(this->Observer, 0.2, 0.6);
    this->Samples = SampleContours(this->Contours, this->Polyhedral.Mesh, this->Result.EdgeLength);
    this->Even = MakeEvenMesh(this->Polyhedral.Mesh, this->PartsOfPolyhedral(),
      this->VerticesWithin(EvenPart), this->Result.EdgeLength, this->Options.Threads, part);
    this->KeepEnds();
  }

  double LargestCoordinate() const
  {
    double largest = 0;
    for (const Point3& p : this->Polyhedral.Mesh.Points)
    {
      largest = std::max({ largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
    }
    return largest;
  }

  /// The contours' vertices, to be kept within a part of the tolerance.
  PlacesToKeep VerticesWithin(double part) const
  {
    PlacesToKeep keep;
    const double rounding = Rounding * this->LargestCoordinate();
    keep.Within = this->Result.Tolerance > rounding ? part * this->Result.Tolerance : 0;
    for (const ContourSample& sample : this->Samples)
    {
      if (sample.IsVertex)
      {
        keep.Places.push_back(sample.Place);
      }
    }
    return keep;
  }

  /// Flat ends are parts of their own: their rim is a crease.
  std::vector<char> PartsOfPolyhedral() const
  {
    const PolyhedralOptions::EndCapsType ends = this->Options.Polyhedral.EndCaps;
    std::vector<char> parts;
    if (ends == PolyhedralOptions::Flat || ends == PolyhedralOptions::HalfSlice)
    {
      for (const auto kind : this->Polyhedral.FaceKind)
      {
        parts.push_back(kind == PolyhedralSurface::Cap ? 1 : 0);
      }
    }
    return parts;
  }

  /// On the rim of a flat end the surface bends as it likes; the slab beside it keeps the bend of the
  /// polyhedral surface, as a free end would flare.
  void KeepEnds()
  {
    const std::vector<Point3>& points = this->Even.Mesh.Points;
    std::vector<char> seen(points.size(), 0);
    for (std::size_t t = 0; t < this->Even.Mesh.Triangles.size(); ++t)
    {
      for (const int v : this->Even.Mesh.Triangles[t])
      {
        seen[v] |= this->Even.Parts[t] ? 2 : 1;
      }
    }
    std::vector<Point3> rim;
    for (std::size_t v = 0; v < seen.size(); ++v)
    {
      if (seen[v] == 3)
      {
        rim.push_back(points[v]);
      }
    }
    this->Fit.Kept.assign(rim.empty() ? 0 : points.size(), 0);
    const double reach = EndReach * this->Spacing;
    const PointGrid grid(rim, reach);
    for (std::size_t v = 0; v < this->Fit.Kept.size(); ++v)
    {
      const int nearest = grid.Nearest(points[v], reach);
      const double far = nearest < 0 ? reach : Norm(points[v] - rim[nearest]);
      this->Fit.Kept[v] = seen[v] == 3 ? Crease : std::min(1.0, 2 * (1 - far / reach));
    }
  }

  /// Pieces of a single slice have nothing that holds them up beside it but their own bend.
  void KeepFlatPieces(const std::vector<Pull>& pulls)
  {
    const TriangleMesh& mesh = this->Even.Mesh;
    const TriangleComponents pieces = FindTriangleComponents(mesh);
    const Vector3 up = this->Contours.Levels.front().Frame.Normal;
    const double most = std::numeric_limits<double>::max();
    std::vector<std::pair<double, double>> heights(pieces.Count, { most, -most });
    for (const Pull& pull : pulls)
    {
      auto& [low, high] = heights[pieces.Of[pull.From.Triangle]];
      low = std::min(low, Dot(up, pull.To));
      high = std::max(high, Dot(up, pull.To));
    }
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      const auto& [low, high] = heights[pieces.Of[t]];
      if (high - low < 0.5 * this->Spacing)
      {
        this->Fit.Kept.resize(mesh.Points.size(), 0);
        for (const int v : mesh.Triangles[t])
        {
          this->Fit.Kept[v] = this->Fit.Kept[v] == Crease ? Crease : 1;
        }
      }
    }
  }

  void Fair()
  {
    SubMonitor part(this->Observer, 0.6, 0.85);
    const SurfacePlaces places(this->Even.Mesh);
    std::vector<Pull> pulls = PullsOf(places, this->Samples, this->Fit, this->Silent);
    this->KeepFlatPieces(pulls);
    const FairSolution solution =
      SolveWithin(this->Even.Mesh, pulls, this->Options.Tension, this->Fit, part);
    this->Result.Tension = solution.Tension;
    UncrossedMove made =
      MoveUncrossed(this->Even.Mesh, solution.Points, 0, {}, this->Options.Threads, this->Silent);
    this->Result.HeldBack = made.HeldBack;
    this->Result.Mesh = std::move(made.Mesh);
  }

  void Finish()
  {
    SubMonitor part(this->Observer, 0.85, 1);
    PulledMesh pulled = PullWithin(this->Result.Mesh, this->Samples, this->Fit, part);
    this->Result.Mesh = std::move(pulled.Mesh);
    const PlacesToKeep keep = this->VerticesWithin(KeptPart);
    if (!pulled.IsWithin)
    {
      UncrossedMove kept = MoveUncrossed(
        this->Even.Mesh, this->Result.Mesh.Points, 0, keep, this->Options.Threads, this->Silent);
      this->Result.HeldBack += kept.HeldBack;
      this->Result.Mesh = std::move(kept.Mesh);
    }
    this->Result.Mesh = MendMesh(this->Result.Mesh, this->Even.Parts, keep, this->Result.EdgeLength,
      this->Options.Threads, this->Silent);
    const SampleMisfit misfit = this->Measure();
    this->Result.Farthest = misfit.Farthest;
    this->Result.Beyond = misfit.Beyond;
    this->Result.Thin = std::count_if(this->Result.Mesh.Triangles.begin(),
      this->Result.Mesh.Triangles.end(),
      [&](const auto& t)
      {
        const auto& points = this->Result.Mesh.Points;
        return SmallestAngle(points[t[0]], points[t[1]], points[t[2]]) < FairLeastAngle * Pi / 180;
      });
  }

  SampleMisfit Measure()
  {
    return MeasureMisfit(this->Result.Mesh, this->Samples, this->Result.Tolerance,
      this->Options.Threads, this->Silent);
  }

  void Tell()
  {
    const FairSurface& made = this->Result;
    std::string chosen = "Edges of " + Text(made.EdgeLength) + ", a tension of " +
      Text(made.Tension) + (this->Options.Tension < 0 ? " on average" : "") + ", a tolerance of " +
      Text(made.Tolerance) +
      (this->Step > 0 ? " (contours follow pixels in steps of " + Text(this->Step) + ")" : "") +
      "; the contour vertex farthest from the surface is " + Text(made.Farthest) + " away.";
    this->Result.Report.push_back(chosen);
    this->TellOf(made.Beyond, "contour vertex",
      " is farther from the surface than the tolerance, by rounding.");
    this->TellOf(made.Thin, "triangle",
      " has an angle below 5 degrees, where sheets touch or contours ask for it.");
    this->TellOf(made.HeldBack, "point",
      " of the surface was held back, so that it does not cross itself or leave a contour.");
  }

  void TellOf(std::size_t count, const std::string& noun, const std::string& rest)
  {
    if (count > 0)
    {
      this->Result.Report.push_back(Counted(count, noun) + rest);
    }
  }

  const ContourSet& Contours;
  const FairOptions& Options;
  Monitor& Observer;
  AbortMonitor Silent;
  double Spacing;
  double Step; ///< of a staircase; 0: contours do not follow pixels
  TracedRaster Raster;
  PolyhedralSurface Polyhedral;
  EvenMesh Even;
  std::vector<ContourSample> Samples;
  FairFitOptions Fit;
  FairSurface Result;
};
}

double AutomaticEdgeLength(const TriangleMesh& surface, double spacing)
{
  const double area = AreaOf(surface);
  const auto lengthOf = [&](double triangles)
  { return std::sqrt(area * 4 / std::sqrt(3.0) / triangles); }; // equilateral ones
  const double fine =
    std::clamp(lengthOf(FewTriangles), LeastEdgePart * spacing, EdgePart * spacing);
  return std::max(fine, lengthOf(MostTriangles));
}

FairSurface BuildFairSurface(
  const ContourSet& contours, const FairOptions& options, Monitor& monitor)
{
  return Fairer(contours, options, monitor).Make();
}
}
