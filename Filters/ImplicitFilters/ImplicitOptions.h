// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ImplicitOptions.h
 * @brief The properties that several filters of the implicit method share, as the core's options.
 */
#ifndef ImplicitOptions_h
#define ImplicitOptions_h

#include "Implicit/Constraints/Constraints.h"
#include "Implicit/Solver/FitImplicitFunction.h"
#include "Implicit/ZeroSet/Polygonizer.h"

#include <algorithm>

namespace recon
{
template <typename Filter>
ConstraintOptions ConstraintOptionsOf(Filter* filter)
{
  ConstraintOptions options;
  options.Mode = static_cast<ConstraintOptions::ModeType>(filter->GetMode());
  options.Values = static_cast<ConstraintOptions::ValuesType>(filter->GetValues());
  options.Normals = static_cast<ConstraintOptions::NormalsType>(filter->GetNormals());
  options.MarginDistance = filter->GetMarginDistance();
  options.ReachAcrossSteps = filter->GetReachAcrossSteps();
  options.MergeBox = filter->GetMergeBox();
  options.ThinOut = filter->GetThinOut();
  options.FillLongEdges = filter->GetFillLongEdges();
  options.FollowDrawnPlanes = filter->GetFollowDrawnPlanes();
  options.ResampleSpacing = filter->GetResampleSpacing();
  options.ResampleTolerance = filter->GetResampleTolerance();
  return options;
}

template <typename Filter>
FunctionOptions FunctionOptionsOf(Filter* filter)
{
  FunctionOptions options;
  options.Kind = static_cast<Kernel::KindType>(filter->GetKernel());
  options.SupportRadius = filter->GetSupportRadius();
  options.Solver = static_cast<FunctionOptions::SolverType>(filter->GetSolver());
  options.Tolerance = filter->GetTolerance();
  options.CentreReduction = filter->GetCentreReduction();
  options.Smoothing = filter->GetSmoothing();
  options.Threads = filter->GetThreads();
  return options;
}

/// The box, where it is to be used.
template <typename Filter>
std::optional<Bounds> BoxOf(Filter* filter)
{
  if (!filter->GetUseBounds())
  {
    return std::nullopt;
  }
  Bounds box{};
  std::copy_n(filter->GetBounds(), 6, box.begin());
  return box;
}

template <typename Filter>
PolygonizerOptions PolygonizerOptionsOf(Filter* filter)
{
  PolygonizerOptions options;
  options.Detail = static_cast<PolygonizerOptions::DetailType>(filter->GetDetail());
  options.CellSize = filter->GetCellSize();
  options.Box = BoxOf(filter);
  options.ClosedAtBounds = filter->GetClosedAtBounds();
  options.CleanUp = filter->GetCleanUp();
  options.SnapToSeeds = filter->GetSnapToContours();
  options.MaximumCells = filter->GetMaximumCells();
  options.Threads = filter->GetThreads();
  return options;
}
}

#endif
