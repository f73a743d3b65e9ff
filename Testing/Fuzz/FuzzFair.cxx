// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a stack of contours with options: its fair surface is as sound as the polyhedral one.
#include "DrawnContours.h"
#include "FuzzTarget.h"
#include "SurfacePromises.h"

#include "Fair/FairSurface.h"

void fuzz::Try(const std::string& bytes)
{
  InputBytes input(bytes);
  recon::FairOptions options;
  options.Tolerance = input.OneOf(std::vector<double>{ -1, -1, 0, 1e-3, 0.5, 1e3 });
  options.EdgeLength = input.OneOf(std::vector<double>{ 0, 0, 0, 2, 1e-4 });
  options.Tension = input.OneOf(std::vector<double>{ -1, -1, 0, 0.5, 1 });
  options.Threads = 1;
  const std::string drawn = input.Text(BytesOfOptions);
  recon::Monitor monitor;
  const recon::ContourSet contours = recon::BuildContourSet(DrawStack(input), {}, monitor);
  InputBytes choices(drawn);
  options.Polyhedral = DrawPolyhedralOptions(choices, static_cast<int>(contours.Contours.size()));
  const recon::FairSurface surface = recon::BuildFairSurface(contours, options, monitor);
  RequireNone(readertesting::FaultOf(surface.Report));
  if (surface.Mesh.Triangles.empty())
  {
    return;
  }
  const recon::SurfaceCertificate certificate = CertificateOf(surface.Mesh, contours);
  const bool isOpen = options.Polyhedral.EndCaps == recon::PolyhedralOptions::NoCaps;
  Require(isOpen ? certificate.Total.Topology.Manifold() : certificate.Total.IsSound(),
    recon::ToVerdict(certificate, false));
}
