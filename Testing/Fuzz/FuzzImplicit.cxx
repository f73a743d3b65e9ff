// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as contours on planes of any direction with options: their implicit surface is closed, manifold and oriented.
#include "DrawnContours.h"
#include "FuzzTarget.h"

#include "Implicit/ImplicitSurface.h"
#include "Mesh/MeshTopology.h"
#include "Readers/Soundness.h"

#include <cmath>

namespace
{
recon::ImplicitSurfaceOptions DrawOptions(fuzz::InputBytes& bytes)
{
  recon::ImplicitSurfaceOptions options;
  recon::ConstraintOptions& constraints = options.Constraints;
  constraints.Mode = static_cast<recon::ConstraintOptions::ModeType>(bytes.Below(4) == 0);
  constraints.Values = static_cast<recon::ConstraintOptions::ValuesType>(bytes.Below(4) != 0);
  constraints.Normals = static_cast<recon::ConstraintOptions::NormalsType>(bytes.Flag());
  constraints.MarginDistance = bytes.OneOf(std::vector<double>{ 0, 0, 1e-6, 0.1, 100 });
  constraints.MergeBox = bytes.OneOf(std::vector<double>{ 0, 0, 0.05, 1 });
  constraints.ReachAcrossSteps = bytes.Flag();
  constraints.ThinOut = bytes.Flag();
  constraints.FillLongEdges = bytes.Flag();
  constraints.FollowDrawnPlanes = bytes.Flag();
  constraints.ResampleSpacing = bytes.OneOf(std::vector<double>{ 0, 0, 0, 0.5, 10 });
  recon::FunctionOptions& function = options.Function;
  function.Kind = static_cast<recon::Kernel::KindType>(bytes.Below(4) == 0);
  function.Solver = static_cast<recon::FunctionOptions::SolverType>(bytes.Below(4));
  function.Smoothing = bytes.OneOf(std::vector<double>{ 0, 0, 1e-6, 1 });
  function.CentreReduction = bytes.OneOf(std::vector<double>{ 0, 0, 0, 0.1 });
  function.MaxGigabytes = 0.2;
  function.Threads = 1;
  recon::PolygonizerOptions& polygonizer = options.Polygonizer;
  polygonizer.Detail =
    static_cast<recon::PolygonizerOptions::DetailType>(bytes.Below(8) == 0 ? 1 : 2);
  polygonizer.ClosedAtBounds = bytes.Below(4) != 0;
  polygonizer.CleanUp = bytes.Flag();
  polygonizer.SnapToSeeds = bytes.Flag();
  polygonizer.MaximumCells = 2e5;
  polygonizer.Threads = 1;
  options.EndsBeyond = bytes.OneOf(std::vector<double>{ 0.4, 0, 0.5, 3 });
  return options;
}
}

void fuzz::Try(const std::string& bytes)
{
  InputBytes input(bytes);
  const recon::ImplicitSurfaceOptions options = DrawOptions(input);
  recon::ContourSetOptions cleaning;
  cleaning.Parallel = input.Below(8) == 0;
  const recon::LoopSoup soup = cleaning.Parallel ? DrawStack(input) : DrawNetwork(input);
  recon::Monitor monitor;
  const recon::ContourSet contours = recon::BuildContourSet(soup, cleaning, monitor);
  const recon::ImplicitSurface surface = recon::BuildImplicitSurface(contours, options, monitor);
  RequireNone(readertesting::FaultOf(surface.Report));
  Require(surface.Mesh.Normals.size() == surface.Mesh.Mesh.Points.size(), "points without normal");
  const recon::TopologyFigures total = recon::CheckTopology(surface.Mesh.Mesh).Total;
  Require(total.EdgeManifold && total.VertexManifold, "no manifold");
  Require(total.MisorientedEdges == 0, "misoriented edges");
  Require(!options.Polygonizer.ClosedAtBounds || total.Closed, "open");
}
