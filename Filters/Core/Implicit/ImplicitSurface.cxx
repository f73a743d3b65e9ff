// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ImplicitSurface.h"

#include "Base/Median.h"
#include "Base/SubMonitor.h"
#include "Implicit/Constraints/ContourPreview.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Contour points of previews: what is solved for directly in a fraction of a second.
constexpr std::size_t CoarsePoints = 700;
constexpr std::size_t MediumPoints = 1000;
/// A contour that reaches beyond the outermost level by less than this part of the gap lies in it.
constexpr double LeastReach = 1e-3;

/// Where the levels perpendicular to a coordinate axis lie on it, in rising order.
std::vector<double> HeightsOn(const ContourSet& contours, int axis)
{
  std::vector<double> heights;
  for (const Level& level : contours.Levels)
  {
    if (std::abs(level.Frame.Normal[axis]) > 1 - 1e-9)
    {
      heights.push_back(level.Offset * level.Frame.Normal[axis]);
    }
  }
  std::sort(heights.begin(), heights.end());
  return heights;
}

double MedianGap(const std::vector<double>& heights)
{
  std::vector<double> gaps;
  for (std::size_t l = 1; l < heights.size(); ++l)
  {
    gaps.push_back(heights[l] - heights[l - 1]);
  }
  return Median(std::move(gaps));
}

/// Points of the contours as they were given, of their edges too: resampling leaves out points, and
/// the surface has to be found there all the same.
std::vector<Point3> WitnessesOf(const ContourSet& contours)
{
  std::vector<Point3> witnesses;
  for (const Contour& contour : contours.Contours)
  {
    for (std::size_t i = 0; i < contour.Points.size(); ++i)
    {
      const Point3& a = contours.Points[contour.Points[i]];
      const Point3& b = contours.Points[contour.Points[(i + 1) % contour.Points.size()]];
      witnesses.push_back(a);
      witnesses.push_back(0.5 * a + 0.5 * b);
    }
  }
  return witnesses;
}

void Append(const std::vector<std::string>& from, std::vector<std::string>& to)
{
  to.insert(to.end(), from.begin(), from.end());
}
}

std::vector<Point3> SeedsOf(const ContourSet& contours)
{
  std::vector<Point3> seeds;
  for (const Contour& contour : contours.Contours)
  {
    for (const int p : contour.Points)
    {
      seeds.push_back(contours.Points[p]);
    }
  }
  return seeds;
}

Bounds ChooseBoundsOf(const ContourSet& contours, double endsBeyond)
{
  const std::vector<Point3> seeds = SeedsOf(contours);
  Bounds box = ChooseBounds(seeds, std::nullopt);
  const Bounds tight = BoundsOf(seeds);
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double> heights = HeightsOn(contours, axis);
    const double gap = MedianGap(heights);
    if (!(gap > 0))
    {
      continue;
    }
    // Contours of other planes that reach farther tell where the solid ends there.
    const double drawn = LeastReach * gap;
    if (heights.front() <= tight[2 * axis] + drawn)
    {
      box[2 * axis] = heights.front() - endsBeyond * gap;
    }
    if (heights.back() >= tight[2 * axis + 1] - drawn)
    {
      box[2 * axis + 1] = heights.back() + endsBeyond * gap;
    }
  }
  return box;
}

namespace
{
ImplicitSurface FitAndMesh(const ContourSet& contours, const ImplicitSurfaceOptions& options,
  const PolygonizerOptions& meshing, Monitor& monitor)
{
  ImplicitSurface surface;
  SubMonitor fitting(monitor, 0, 0.6);
  surface.Fit = FitContours(contours, options.Constraints, options.Function, fitting);
  SubMonitor polygonizing(monitor, 0.6, 1);
  // Seeds are the contours that were fitted: resampling may leave the others a little off the
  // surface.
  surface.Mesh =
    Polygonize(surface.Fit.Function, SeedsOf(surface.Fit.Contours), meshing, polygonizing);
  Append(surface.Fit.Constraints.Report, surface.Report);
  Append(surface.Fit.Function.Report, surface.Report);
  Append(surface.Mesh.Report, surface.Report);
  return surface;
}

ImplicitSurface BuildPreview(const ContourSet& contours, const ImplicitSurfaceOptions& options,
  const PolygonizerOptions& meshing, Monitor& monitor)
{
  const bool coarse = meshing.Detail == PolygonizerOptions::Coarse;
  const ContourSet shown =
    PreviewOf(contours, meshing.CellSize, coarse ? CoarsePoints : MediumPoints);
  ImplicitSurfaceOptions quick = options;
  quick.Constraints.Normals = ConstraintOptions::InPlane;
  quick.Constraints.ThinOut = false;
  quick.Constraints.FillLongEdges = false;
  quick.Constraints.FollowDrawnPlanes = false;
  quick.Constraints.ResampleSpacing = 0;
  quick.Constraints.ResampleTolerance = 0;
  quick.Function.CentreReduction = 0;
  ImplicitSurface surface = FitAndMesh(shown, quick, meshing, monitor);
  surface.Report.push_back("The preview knows " + std::to_string(shown.Points.size()) +
    " contour points on " + std::to_string(shown.Levels.size()) + " of " +
    std::to_string(contours.Levels.size()) + " planes, with margins in these.");
  return surface;
}
}

ImplicitSurface BuildImplicitSurface(
  const ContourSet& contours, const ImplicitSurfaceOptions& options, Monitor& monitor)
{
  // What is refused is refused at once, not after the fit.
  CheckConstraintInput(contours, options.Constraints);
  if (!(options.EndsBeyond >= 0) || !std::isfinite(options.EndsBeyond))
  {
    throw Error("EndsBeyond must be 0 or positive, in parts of the slices' distance: 0.5 is half a "
                "slice, 0 ends at the outermost slices.");
  }
  PolygonizerOptions meshing = options.Polygonizer;
  if (!meshing.Box)
  {
    meshing.Box = ChooseBoundsOf(contours, options.EndsBeyond);
  }
  CheckBounds(*meshing.Box);
  const std::vector<Point3> seeds = SeedsOf(contours);
  const double cellSize = ChooseCellSize(seeds, meshing);
  CheckCellCount(BoundsOf(seeds), *meshing.Box, cellSize, meshing.MaximumCells);

  const bool full = meshing.Detail == PolygonizerOptions::Full;
  if (full)
  {
    meshing.Witnesses = WitnessesOf(contours);
  }
  else
  {
    // The cells of all contours, not of those that the preview knows.
    meshing.CellSize = cellSize;
  }
  ImplicitSurface surface = full ? FitAndMesh(contours, options, meshing, monitor)
                                 : BuildPreview(contours, options, meshing, monitor);
  surface.Report.insert(surface.Report.begin(), contours.Report.begin(), contours.Report.end());
  return surface;
}
}
