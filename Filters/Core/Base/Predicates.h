// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Predicates.h
 * @brief Exact answers about points of a plane; every decision about topology is made by these.
 *
 * Includes CGAL: for .cxx files only.
 */
#ifndef recon_Predicates_h
#define recon_Predicates_h

#include "Base/Geometry.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

namespace recon
{
using PlaneKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// +1 where a, b, c turn left, -1 right, 0 on a line.
inline int Turn(const Point2& a, const Point2& b, const Point2& c)
{
  return static_cast<int>(CGAL::orientation(PlaneKernel::Point_2(a[0], a[1]),
    PlaneKernel::Point_2(b[0], b[1]), PlaneKernel::Point_2(c[0], c[1])));
}

/// For p on the line through a and b: does it lie strictly between them?
inline bool StrictlyBetween(const Point2& a, const Point2& b, const Point2& p)
{
  return (a < p && p < b) || (b < p && p < a);
}
}

#endif
