// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/ContoursOnSlices.h"

#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Contours/ContourMeasures.h"
#include "Contours/ContourSetBuilder.h"
#include "Contours/Specks.h"
#include "Implicit/Constraints/ContourFit.h"
#include "Implicit/ImplicitSurface.h"
#include "Implicit/ZeroSet/ContourTracer.h"
#include "Mesh/SurfaceSections.h"
#include "Polyhedral/PolyhedralSurface.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// A drawn level is in a slice's plane where it is off by no more, mm: what text of DICOM rounds.
constexpr double InPlane = 1e-3;

double SmallestAreaOf(
  const ContourSet& drawn, const SlicesOfReference& slices, const SliceContourOptions& options)
{
  const double pixel = slices.Slices.empty() ? 0 : slices.Slices.front().PixelArea;
  return options.SmallestArea == 0 ? SpeckArea(pixel, SmallestArea(drawn))
                                   : std::max(0.0, options.SmallestArea);
}

std::vector<TracePlane> PlanesFor(const ContourSet& drawn, const SlicesOfReference& slices,
  bool extrapolate, std::vector<std::string>& report)
{
  std::vector<TracePlane> planes;
  for (const ReferenceSlice& slice : slices.Slices)
  {
    planes.push_back({ FrameAbout(slice.Normal), slice.Offset });
  }
  if (extrapolate)
  {
    return planes;
  }
  std::vector<TracePlane> within = PlanesWithin(planes, SeedsOf(drawn), slices.Tolerance);
  if (within.empty())
  {
    throw Error("None of the " + std::to_string(planes.size()) +
      " slices lies between the outermost drawn points: are they of the same patient, in the same "
      "frame of reference?");
  }
  report.push_back(Counted(within.size(), "slice") + " of " + std::to_string(planes.size()) +
    " lie" + (within.size() == 1 ? "s" : "") +
    " where something was drawn; the others are left out.");
  return within;
}

ContourSet TraceImplicit(const ContourSet& drawn, const std::vector<TracePlane>& planes,
  double smallest, int threads, Monitor& monitor)
{
  FunctionOptions fitting;
  fitting.Threads = threads;
  SubMonitor solving(monitor, 0, 0.7);
  const ContourFit fit = FitContours(drawn, ConstraintOptions(), fitting, solving);
  TracerOptions tracing;
  tracing.Threads = threads;
  tracing.SmallestArea = smallest;
  SubMonitor following(monitor, 0.7, 1);
  ContourSet contours =
    TraceContours(fit.Function, SeedsOf(fit.Contours), planes, tracing, following);
  contours.Report.insert(
    contours.Report.begin(), fit.Function.Report.begin(), fit.Function.Report.end());
  contours.Report.insert(
    contours.Report.begin(), fit.Constraints.Report.begin(), fit.Constraints.Report.end());
  return contours;
}

/// As Polyhedral Surface is set when nobody sets it.
PolyhedralOptions UsualOptions(int threads)
{
  PolyhedralOptions options;
  options.Mapping = PolyhedralOptions::Overlap;
  options.EndCaps = PolyhedralOptions::Tapered;
  options.IsolatedContours = PolyhedralOptions::Extrude;
  options.AlignLevels = LevelAlignmentMode::Automatic;
  options.Threads = threads;
  return options;
}

/// The drawn level whose contours a plane takes as they are; nullptr where it cuts the surface.
const Level* LevelFor(const ContourSet& drawn, const TracePlane& plane)
{
  const Level& first = drawn.Levels.front();
  const Level& last = drawn.Levels.back();
  if (!AreParallel(first.Frame.Normal, plane.Frame.Normal, Parallelism::UpToRounding))
  {
    return nullptr;
  }
  const double offset = OffsetAlong(first.Frame.Normal, plane.Frame.Normal, plane.Offset);
  if (offset <= first.Offset + InPlane)
  {
    return &first;
  }
  if (offset >= last.Offset - InPlane)
  {
    return &last;
  }
  const auto same = std::find_if(drawn.Levels.begin(), drawn.Levels.end(),
    [&](const Level& level) { return std::abs(level.Offset - offset) <= InPlane; });
  return same == drawn.Levels.end() ? nullptr : &*same;
}

/// Contours of a level, moved along the normal onto the plane.
void AppendLevel(
  const ContourSet& drawn, const Level& level, const TracePlane& plane, LoopSoup& soup)
{
  for (const int c : level.Contours)
  {
    std::vector<Point3> loop;
    for (const int p : drawn.Contours[c].Points)
    {
      const Point3& at = drawn.Points[p];
      loop.push_back(at + (plane.Offset - plane.Frame.OffsetOf(at)) * plane.Frame.Normal);
    }
    soup.Append(loop);
  }
}

ContourSet CutPolyhedral(const ContourSet& drawn, const std::vector<TracePlane>& planes,
  double smallest, int threads, Monitor& monitor)
{
  SubMonitor building(monitor, 0, 0.7);
  const PolyhedralSurface surface = BuildPolyhedralSurface(drawn, UsualOptions(threads), building);
  LoopSoup soup;
  for (std::size_t p = 0; p < planes.size(); ++p)
  {
    const double done = static_cast<double>(p) / static_cast<double>(planes.size());
    monitor.Update(0.7 + 0.2 * done, "cutting the surface");
    if (const Level* level = LevelFor(drawn, planes[p]))
    {
      AppendLevel(drawn, *level, planes[p], soup);
      continue;
    }
    AppendSection(surface.Mesh, planes[p].Frame, planes[p].Offset, soup);
  }
  const std::string specks = LeaveOutSpecks(smallest, soup);
  SubMonitor nesting(monitor, 0.9, 1);
  ContourSetOptions options;
  options.Parallel = true;
  ContourSet contours = BuildContourSet(soup, options, nesting);
  contours.Report.insert(contours.Report.begin(), surface.Report.begin(), surface.Report.end());
  if (!specks.empty())
  {
    contours.Report.push_back(specks);
  }
  return contours;
}
}

ContourSet ContoursOnSlices(const ContourSet& drawn, const SlicesOfReference& slices,
  const SliceContourOptions& options, Monitor& monitor)
{
  const bool isImplicit = options.Method == SliceContourOptions::Implicit;
  std::vector<std::string> report = drawn.Report;
  const std::vector<TracePlane> planes =
    PlanesFor(drawn, slices, options.Extrapolate && isImplicit, report);
  const double smallest = SmallestAreaOf(drawn, slices, options);
  ContourSet contours = isImplicit
    ? TraceImplicit(drawn, planes, smallest, options.Threads, monitor)
    : CutPolyhedral(drawn, planes, smallest, options.Threads, monitor);
  contours.Report.insert(contours.Report.begin(), report.begin(), report.end());
  return contours;
}
}
