// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file BoundedField.h
 * @brief The implicit function, cut by a box: what is meshed and traced.
 *
 * Notation: f the implicit function, b(x) the distance to the box (> 0 inside), g = min(f, b), the
 * solid is g > 0.
 */
#ifndef recon_BoundedField_h
#define recon_BoundedField_h

#include "Base/SubMonitor.h"
#include "Implicit/FastMultipole/FunctionEvaluator.h"

#include <array>
#include <memory>
#include <vector>

namespace recon
{
/// xmin, xmax, ymin, ymax, zmin, zmax in the units of the input.
using Bounds = std::array<double, 6>;

/**
 * @class BoundedField
 * @brief g = min(f, b), or f alone where the surface is not to be closed at the box.
 *
 * The zero set of g is closed whatever f does outside (thesis 11.1: "a surface that grows with no
 * control").
 */
class BoundedField
{
public:
  /// @param monitor is asked, while values are computed, whether to stop; outlives this.
  BoundedField(const ImplicitFunction& function, const Bounds& box, bool closed, int threads,
    Monitor& monitor);

  std::vector<double> Values(const std::vector<Point3>& points) const;
  /// Values and gradients of g at once.
  void Evaluate(const std::vector<Point3>& points, std::vector<double>& values,
    std::vector<Vector3>& gradients) const;

  const Bounds& Box() const { return this->Limits; }
  bool Closed() const { return this->ClosedAtBox; }
  /// f alone, in the same box.
  BoundedField Open() const;

  /**
   * Moves points onto the surface along the gradient (Newton), none further than limit; normals
   * point out of the solid. done[i] = 0 where the surface was not reached to within tolerance; that
   * point stays.
   */
  void Project(std::vector<Point3>& points, std::vector<Vector3>& normals, std::vector<char>& done,
    double limit, double tolerance) const;

private:
  double BoxValue(const Point3& x, int& axis, double& sign) const;

  std::shared_ptr<const FunctionEvaluator> Function;
  Bounds Limits;
  bool ClosedAtBox;
  mutable AbortMonitor Stop;
};

/// The bounding box of points; throws Error where there is none or one holds a NaN.
Bounds BoundsOf(const std::vector<Point3>& points);
double DiagonalOf(const Bounds& box);

/// @throws Error where a box is empty, inverted or not finite.
void CheckBounds(const Bounds& box);
}

#endif
