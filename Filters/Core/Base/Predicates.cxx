// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/Predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstddef>

namespace recon
{
namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_3 ToCGAL(const Point3& p)
{
  return { p[0], p[1], p[2] };
}

Kernel::Point_2 ToCGAL(const Point2& p)
{
  return { p[0], p[1] };
}
}

int ExactOrientation3(const Point3& a, const Point3& b, const Point3& c, const Point3& d)
{
  // What lies in a plane across an axis is what is asked most often here.
  for (std::size_t k = 0; k < 3; ++k)
  {
    if (a[k] == b[k] && a[k] == c[k] && a[k] == d[k])
    {
      return 0;
    }
  }
  return static_cast<int>(CGAL::orientation(ToCGAL(a), ToCGAL(b), ToCGAL(c), ToCGAL(d)));
}

int ExactOrientation2(const Point2& a, const Point2& b, const Point2& c)
{
  if ((a[0] == b[0] && a[0] == c[0]) || (a[1] == b[1] && a[1] == c[1]))
  {
    return 0;
  }
  return static_cast<int>(CGAL::orientation(ToCGAL(a), ToCGAL(b), ToCGAL(c)));
}

bool ExactCollinear(const Point3& a, const Point3& b, const Point3& c)
{
  return CGAL::collinear(ToCGAL(a), ToCGAL(b), ToCGAL(c));
}
}
