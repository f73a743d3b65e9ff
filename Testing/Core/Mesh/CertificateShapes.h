// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file CertificateShapes.h
 * @brief A mesh's certificate in one line, and contours to compare it with.
 */
#ifndef recon_testing_CertificateShapes_h
#define recon_testing_CertificateShapes_h

#include "Mesh/Certificate.h"

namespace recon::testing
{
inline SurfaceCertificate CertifyMesh(const TriangleMesh& mesh,
  const ContourSet* contours = nullptr, CertificateOptions options = CertificateOptions())
{
  Monitor monitor;
  return Certify(mesh, contours, options, monitor);
}

/// A unit square at (x, 0), alone on its level.
inline ContourSet MakeSquareLevel(double offset, double x)
{
  ContourSet set;
  set.Levels.emplace_back();
  set.Levels.back().Offset = offset;
  set.Levels.back().Contours = { 0 };
  Contour contour;
  contour.Level = 0;
  for (const auto& p : { Point2{ 0, 0 }, Point2{ 1, 0 }, Point2{ 1, 1 }, Point2{ 0, 1 } })
  {
    contour.Points.push_back(static_cast<int>(set.Points.size()));
    set.Points.push_back({ p[0] + x, p[1], offset });
    set.Planar.push_back({ p[0] + x, p[1] });
  }
  set.Contours.push_back(contour);
  return set;
}
}

#endif
