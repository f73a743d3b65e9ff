// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Kernel.h
 * @brief Radial basis functions of the implicit method.
 *
 * Notation (thesis 8.2, 8.3, 12.3): phi is the kernel, r the distance to a centre c_j in the units
 * of the input.
 */
#ifndef recon_Kernel_h
#define recon_Kernel_h

#include <cmath>

namespace recon
{
/**
 * @class Kernel
 * @brief phi(r), and phi'(r)/r for the gradient.
 */
struct Kernel
{
  enum KindType
  {
    /// |r|^3 (Duchon): minimises the bending energy in 3D, needs a linear polynomial beside it.
    Triharmonic = 0,
    /// (1 - r/R)^4 (4 r/R + 1) for r < R, else 0 (Wendland, twice differentiable): sparse systems.
    Wendland = 1
  };

  KindType Kind = Triharmonic;
  double Radius = 1; ///< R, the support of Wendland's function; Triharmonic does not use it

  /// phi at the square of a distance.
  double Value(double r2) const
  {
    if (this->Kind == Triharmonic)
    {
      return r2 * std::sqrt(r2);
    }
    const double q = std::sqrt(r2) / this->Radius;
    const double rest = q < 1 ? 1 - q : 0;
    return rest * rest * rest * rest * (4 * q + 1);
  }

  /// phi'(r) / r at the square of a distance: times (x - c) it is the gradient, finite at the
  /// centre.
  double SlopeOverRadius(double r2) const
  {
    if (this->Kind == Triharmonic)
    {
      return 3 * std::sqrt(r2);
    }
    const double q = std::sqrt(r2) / this->Radius;
    const double rest = q < 1 ? 1 - q : 0;
    return -20 * rest * rest * rest / (this->Radius * this->Radius);
  }
};
}

#endif
