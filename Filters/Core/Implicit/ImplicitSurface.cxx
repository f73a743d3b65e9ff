// SPDX-License-Identifier: GPL-3.0-or-later
#include "ImplicitSurface.h"

#include "SubMonitor.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// The coordinate axis that all levels are perpendicular to, or -1.
int CommonAxis(const ContourSet& contours)
{
  for (int a = 0; a < 3; ++a)
  {
    const bool all = std::all_of(contours.Levels.begin(), contours.Levels.end(),
      [a](const Level& level) { return std::abs(level.Frame.Normal[a]) > 1 - 1e-9; });
    if (all && !contours.Levels.empty())
    {
      return a;
    }
  }
  return -1;
}

double MedianGap(const ContourSet& contours, int axis)
{
  std::vector<double> heights;
  for (const Level& level : contours.Levels)
  {
    heights.push_back(level.Offset * level.Frame.Normal[axis]);
  }
  std::sort(heights.begin(), heights.end());
  std::vector<double> gaps;
  for (std::size_t l = 1; l < heights.size(); ++l)
  {
    gaps.push_back(heights[l] - heights[l - 1]);
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps.empty() ? 0 : gaps[gaps.size() / 2];
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

Bounds ChooseBoundsOf(const ContourSet& contours)
{
  const std::vector<Point3> seeds = SeedsOf(contours);
  Bounds box = ChooseBounds(seeds, std::nullopt);
  const int axis = CommonAxis(contours);
  const double gap = axis < 0 ? 0 : MedianGap(contours, axis);
  if (gap > 0)
  {
    const Bounds tight = BoundsOf(seeds);
    box[2 * axis] = tight[2 * axis] - 0.5 * gap;
    box[2 * axis + 1] = tight[2 * axis + 1] + 0.5 * gap;
  }
  return box;
}

ImplicitSurface BuildImplicitSurface(
  const ContourSet& contours, const ImplicitSurfaceOptions& options, Monitor& monitor)
{
  // What is refused is refused at once, not after the fit.
  CheckConstraintInput(contours, options.Constraints);
  PolygonizerOptions meshing = options.Polygonizer;
  if (!meshing.Box)
  {
    meshing.Box = ChooseBoundsOf(contours);
  }
  CheckBounds(*meshing.Box);
  const std::vector<Point3> seeds = SeedsOf(contours);
  CheckCellCount(
    BoundsOf(seeds), *meshing.Box, ChooseCellSize(seeds, meshing.CellSize), meshing.MaximumCells);

  ImplicitSurface surface;
  SubMonitor fitting(monitor, 0, 0.6);
  surface.Fit = FitContours(contours, options.Constraints, options.Function, fitting);
  SubMonitor polygonizing(monitor, 0.6, 1);
  // Seeds are the contours that were fitted: resampling may leave the others a little off the
  // surface.
  surface.Mesh =
    Polygonize(surface.Fit.Function, SeedsOf(surface.Fit.Contours), meshing, polygonizing);
  Append(contours.Report, surface.Report);
  Append(surface.Fit.Constraints.Report, surface.Report);
  Append(surface.Fit.Function.Report, surface.Report);
  Append(surface.Mesh.Report, surface.Report);
  return surface;
}
}
