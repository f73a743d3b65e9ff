// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file RbfSystem.h
 * @brief Equation 8.4 of the thesis, factorised once and solved for any right-hand side.
 *
 * Notation:
 *   n      number of constraints
 *   Phi    n x n, Phi_ij = phi(|c_i - c_j|), plus lambda on the diagonal
 *   P      n x 4, rows (1, c_i)
 *   Q R    P = Q R; Q1 its first four columns, Q2 the others: a basis of the space orthogonal to
 *          the polynomials
 *   w, p   weights and polynomial: Phi w + P p = h, P^T w = 0
 */
#ifndef recon_RbfSystem_h
#define recon_RbfSystem_h

#include "Base/Geometry.h"
#include "Base/Monitor.h"
#include "Implicit/Kernel.h"

#include <array>
#include <memory>
#include <vector>

namespace recon
{
struct RbfSolution
{
  std::vector<double> Weights;
  std::array<double, 4> Polynomial{ 0, 0, 0, 0 };
};

/**
 * @class RbfSystem
 * @brief A factorised system; the ways to factorise it are behind the functions below.
 */
class RbfSystem
{
public:
  virtual ~RbfSystem() = default;
  virtual RbfSolution Solve(const std::vector<double>& h) const = 0;
};

/// What a system is made of, in coordinates near the unit ball.
struct RbfProblem
{
  Kernel Phi;
  std::vector<Point3> Points;
  double Lambda = 0; ///< smoothing
  int Threads = 0;
};
}

#endif
