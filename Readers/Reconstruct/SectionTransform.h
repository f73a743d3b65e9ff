// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file SectionTransform.h
 * @brief How Reconstruct and PyReconstruct place a section in the series.
 */
#ifndef recon_SectionTransform_h
#define recon_SectionTransform_h

#include "Base/Geometry.h"

#include <array>
#include <string>

namespace recon
{
/// A polynomial of at most second order in x and y, or its inverse; see ReconstructParser.h.
class SectionTransform
{
public:
  /// Leaves points where they are.
  SectionTransform() = default;

  /// From the place in the series to the trace's coordinates, as Reconstruct's files have it.
  static SectionTransform FromInverse(
    const std::array<double, 6>& x, const std::array<double, 6>& y);

  /// X = t[0] x + t[1] y + t[2], Y = t[3] x + t[4] y + t[5].
  static SectionTransform FromAffine(const std::array<double, 6>& t);

  /// Returns false where the place cannot be found: the polynomial has no inverse there.
  bool Place(const Point2& trace, Point2& place) const;

private:
  Point2 Evaluate(const Point2& p) const;
  bool Solve(const Point2& trace, Point2& place) const;

  bool IsInverse = false;
  std::array<double, 6> X{ 0, 1, 0, 0, 0, 0 };
  std::array<double, 6> Y{ 0, 0, 1, 0, 0, 0 };
};

/// Six numbers in a text; returns false for any other.
bool ParseCoefficients(const std::string& text, std::array<double, 6>& numbers);
}

#endif
