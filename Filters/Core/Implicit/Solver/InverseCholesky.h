// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file InverseCholesky.h
 * @brief A sparse factor of the inverse of the triharmonic system: the preconditioner that lets
 * conjugate gradients end in tens of steps whatever the number of constraints.
 *
 * Notation (Schaefer, Katzfuss, Owhadi: Sparse Cholesky factorization by Kullback-Leibler
 * minimization, 2021):
 *   points are ordered from coarse to fine (MaximinOrder); the first four are the simplex a
 *   l_a(x)   the linear function that is 1 at simplex point a and 0 at the other three
 *   E        n x (n - 4), [-l^T; I]: its columns span the weights orthogonal to linear polynomials
 *   K        E^T (Phi + lambda I) E, positive definite: K_ij = phi_ij - l_a(i) phi_aj - ...
 *   S_i      a few points of lower rank near i, and some of the first
 *   u_i      K(S_i + i, S_i + i)^-1 e_i / sqrt(its entry i): column i of U
 *   U U^T    the approximation of K^-1: of all factors with these sparsity sets the one that is
 *            nearest in the sense of Kullback and Leibler
 *
 * Neighbours that have nearly the same S share one factorisation (their supernodes): the Cholesky
 * factor of the union holds the columns of all of them.
 */
#ifndef recon_InverseCholesky_h
#define recon_InverseCholesky_h

#include "Implicit/Solver/MaximinOrder.h"

#include <array>
#include <cstdint>
#include <vector>

namespace recon
{
struct InverseCholeskyOptions
{
  int Exact = 1024;        ///< points of lowest rank whose columns are exact
  int Members = 16;        ///< points that share a factorisation
  int First = 8;           ///< points of lowest rank in every set
  int Neighbours = 60;     ///< nearest points of lower rank, of every member
  double LevelRatio = 0.5; ///< members' distances l_i differ by at most this factor
  double Lambda = 0;       ///< smoothing, as in RbfProblem
  int Threads = 0;
};

/**
 * @class InverseCholesky
 * @brief Built once (n small dense factorisations, in threads), applied in O(n).
 *
 * Everything is by rank of the order given. Results are the same for any number of threads.
 */
class InverseCholesky
{
public:
  InverseCholesky(
    const MaximinOrder& order, const InverseCholeskyOptions& options, Monitor& monitor);

  /// E^T r, as n numbers of which the first four are 0: r less the linear function that is r at the
  /// simplex.
  std::vector<double> Project(const std::vector<double>& r) const;

  /// E U U^T r for a projected r: weights orthogonal to the linear polynomials.
  std::vector<double> Apply(const std::vector<double>& projected, Monitor& monitor) const;

  /// Coefficients (1, x, y, z) of the linear function that takes four values at the simplex.
  std::array<double, 4> PolynomialThrough(const std::array<double, 4>& atSimplex) const;

private:
  using Row = std::array<double, 4>;

  struct Group
  {
    std::size_t Set;     ///< where its set begins in Sets and Slots
    std::size_t Columns; ///< where its columns begin in Entries
    int SetSize;
    int Member; ///< where its members begin in MemberAt
    int Members;
  };

  class Workspace;

  void FindSimplex();
  void FindGroups();
  void GroupLevel(std::vector<int> ranks);
  void FindSets(Monitor& monitor);
  void Factorise(int group, Workspace& work);
  void FactoriseWide(int group, Workspace& work);
  void FindSlots();
  Row Barycentric(const Point3& x) const;

  const MaximinOrder& Order;
  InverseCholeskyOptions Options;
  std::array<Row, 4> Inverse{}; ///< of the matrix with rows (1, simplex point)
  std::vector<Row> L;           ///< l_a of every point
  std::vector<Row> Q;           ///< phi_a. - 0.5 Phi_aa l: K_ij = phi_ij - l_i.q_j - l_j.q_i

  std::vector<Group> Groups;
  std::vector<std::vector<int>> MembersOf; ///< ranks; while building only
  std::vector<std::int32_t> Sets;          ///< ranks in increasing order, without the simplex
  std::vector<std::int32_t> MemberAt;      ///< places of the members in their group's set
  std::vector<double> Entries;             ///< columns of U, each down to its member
  std::vector<std::size_t> SlotBegin;      ///< by rank, into SlotsOf
  std::vector<std::uint32_t> SlotsOf;      ///< places in Sets where a rank occurs
};
}

#endif
