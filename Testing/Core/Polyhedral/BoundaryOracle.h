// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BoundaryOracle.h
 * @brief The surface from all tetrahedra beside that from those at its boundary: the same bytes.
 */
#ifndef recon_Testing_BoundaryOracle_h
#define recon_Testing_BoundaryOracle_h

#include "Polyhedral/PolyhedralSurface.h"
#include "PolyhedralShapes.h"
#include "SameSurface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace recon::testing
{
inline PolyhedralSurface BuildWith(
  const ContourSet& contours, const PolyhedralOptions& options, TetrahedraWanted wanted)
{
  Monitor monitor;
  return BuildPolyhedralSurface(contours, options, monitor, wanted);
}

inline void ExpectSameFromBoundary(const ContourSet& contours, const PolyhedralOptions& options)
{
  const PolyhedralSurface all = BuildWith(contours, options, TetrahedraWanted::All);
  const PolyhedralSurface few = BuildWith(contours, options, TetrahedraWanted::BoundaryOnly);
  ExpectSameSurface(few, all);
}

/// The thesis's own method, and what users get.
inline std::vector<PolyhedralOptions> UsualOptions()
{
  PolyhedralOptions thesis;
  thesis.Threads = 1;
  PolyhedralOptions usual = thesis;
  usual.Mapping = PolyhedralOptions::Overlap;
  usual.EndCaps = PolyhedralOptions::Tapered;
  return { thesis, usual };
}

inline void ExpectSameFromBoundary(const ContourSet& contours)
{
  for (const PolyhedralOptions& options : UsualOptions())
  {
    SCOPED_TRACE(options.EndCaps == PolyhedralOptions::Flat ? "thesis" : "as users get it");
    ExpectSameFromBoundary(contours, options);
  }
}

/// A smooth outline that turns and swells from level to level.
inline Ring Blob(int points, double level, const Point2& middle = { 0, 0 })
{
  Ring ring;
  for (int i = 0; i < points; ++i)
  {
    const double t = FullTurn * i / points;
    const double r = 1 + 0.2 * std::sin(3 * t + 0.25 * level) + 0.1 * std::sin(5 * t + 0.5 * level);
    ring.push_back({ middle[0] + r * std::cos(t), middle[1] + r * std::sin(t) });
  }
  return ring;
}

inline ContourSet BlobStack(int points, int levels)
{
  RingStack stack;
  for (int l = 0; l < levels; ++l)
  {
    stack.push_back({ Blob(points, l) });
  }
  return BuildStack(stack, 0.2);
}
}

#endif
