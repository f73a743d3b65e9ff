// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairSurface.h"

#include "Base/Angles.h"
#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Fair/EvenMesh.h"
#include "Fair/EvenPasses.h"
#include "Fair/FairFit.h"
#include "Fair/StaircaseStep.h"
#include "Fair/UncrossedMove.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <algorithm>
#include <chrono>
#include <cmath>

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
constexpr double AutomaticTension = 0.1;
/// Of pulls: drawn contours are followed, the staircase of pixels is evened out.
constexpr double DrawnWeight = 1e4;
constexpr double StaircaseWeight = 30;
/// Of a staircase's step, how far the surface may leave it.
constexpr double StaircaseTolerance = 0.5;

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
      Step(StaircaseStep(contours))
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
      : AutomaticEdgeLength(this->Polyhedral.Mesh, this->Spacing);
    this->Result.Tolerance = this->Options.Tolerance >= 0 ? this->Options.Tolerance
      : this->Step > 0                                    ? StaircaseTolerance * this->Step
                                                          : TolerancePart * this->Spacing;
    this->Result.Tension = this->Options.Tension >= 0 ? this->Options.Tension : AutomaticTension;
    this->Fit.Tolerance = this->Result.Tolerance;
    this->Fit.EdgeLength = this->Result.EdgeLength;
    this->Fit.Weight = this->Step > 0 && this->Result.Tolerance > 0 ? StaircaseWeight : DrawnWeight;
    this->Fit.Threads = this->Options.Threads;
  }

  void MakeEven()
  {
    SubMonitor part(this->Observer, 0.2, 0.6);
    this->Even =
      MakeEvenMesh(this->Polyhedral.Mesh, this->Result.EdgeLength, this->Options.Threads, part)
        .Mesh;
    this->Samples = SampleContours(this->Contours, this->Polyhedral.Mesh, this->Result.EdgeLength);
  }

  void Fair()
  {
    SubMonitor part(this->Observer, 0.6, 0.85);
    const SurfacePlaces places(this->Even);
    std::vector<Pull> pulls = PullsOf(places, this->Samples, this->Fit, this->Silent);
    const std::vector<Point3> moved =
      SolveWithin(this->Even, pulls, this->Spacing, this->Result.Tension, this->Fit, part);
    UncrossedMove made = MoveUncrossed(this->Even, moved, 0, this->Options.Threads, this->Silent);
    this->Result.HeldBack = made.HeldBack;
    this->Result.Mesh =
      MendMesh(made.Mesh, this->Result.EdgeLength, this->Options.Threads, this->Silent);
  }

  void Finish()
  {
    SubMonitor part(this->Observer, 0.85, 1);
    this->Result.Mesh = PullWithin(this->Result.Mesh, this->Samples, this->Fit, part);
    const SampleMisfit misfit = MeasureMisfit(this->Result.Mesh, this->Samples,
      this->Result.Tolerance, this->Options.Threads, this->Silent);
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

  void Tell()
  {
    const FairSurface& made = this->Result;
    std::string chosen = "Edges of " + Text(made.EdgeLength) + ", a tension of " +
      Text(made.Tension) + ", a tolerance of " + Text(made.Tolerance) +
      (this->Step > 0 ? " (contours follow pixels in steps of " + Text(this->Step) + ")" : "") +
      "; the contour vertex farthest from the surface is " + Text(made.Farthest) + " away.";
    this->Result.Report.push_back(chosen);
    this->TellOf(made.Beyond, "contour vertex",
      " is farther from the surface than the tolerance; a smaller Edge Length brings it nearer.");
    this->TellOf(made.Thin, "triangle",
      " has an angle below 5 degrees, where sheets touch or contours ask for it.");
    this->TellOf(
      made.HeldBack, "point", " of the surface was held back, so that it does not cross itself.");
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
  double Step; ///< of a staircase; 0: contours were drawn
  PolyhedralSurface Polyhedral;
  TriangleMesh Even;
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
