// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SurfacePromises.h
 * @brief What README promises of a polyhedral surface, asked of one that a fuzz target made.
 */
#ifndef SurfacePromises_h
#define SurfacePromises_h

#include "FuzzTarget.h"

#include "Core/Polyhedral/DegenerateStacks.h"
#include "Mesh/Certificate.h"
#include "Mesh/CertificateText.h"
#include "Readers/Soundness.h"

#include <algorithm>
#include <string>
#include <vector>

namespace fuzz
{
/// The certificate of a surface of these contours.
inline recon::SurfaceCertificate CertificateOf(
  const recon::TriangleMesh& mesh, const recon::ContourSet& contours)
{
  recon::CertificateOptions options;
  options.Threads = 1;
  recon::Monitor monitor;
  return recon::Certify(mesh, &contours, options, monitor);
}

inline void RequireSound(const recon::SurfaceCertificate& certificate)
{
  Require(certificate.Total.IsSound(), recon::ToVerdict(certificate, false));
}

/// Whether Report has a line with these words.
inline bool Says(const std::vector<std::string>& report, const char* words)
{
  return std::any_of(report.begin(), report.end(),
    [words](const std::string& line) { return line.find(words) != std::string::npos; });
}

/// Sound by its certificate, every contour vertex on it or named in Report.
inline void RequirePromises(const recon::PolyhedralSurface& surface,
  const recon::ContourSet& contours, const recon::PolyhedralOptions& options)
{
  RequireNone(readertesting::FaultOf(contours.Report));
  RequireNone(readertesting::FaultOf(surface.Report));
  RequireNone(recon::testing::BrokenPromises(surface, contours, options));
  if (surface.Mesh.Triangles.empty())
  {
    return;
  }
  const recon::SurfaceCertificate certificate = CertificateOf(surface.Mesh, contours);
  if (options.EndCaps == recon::PolyhedralOptions::NoCaps)
  {
    Require(certificate.Total.Topology.Manifold(), "open, and no manifold");
    RequireNone(recon::testing::IntersectionsOf(surface.Mesh));
    return;
  }
  RequireSound(certificate);
  Require(options.PinchGap == 0 || certificate.Welded.Manifold() ||
      Says(surface.Report, "no way apart was found"),
    "no manifold by coordinates, and Report does not say so");
}
}

#endif
