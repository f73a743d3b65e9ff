// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/DenseRbfSystem.h"
#include "Base/Parallel.h"
#include "Implicit/Solver/Lapack.h"

#include <Eigen/Dense>

#include <algorithm>

namespace recon
{
namespace
{
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Index = Eigen::Index;

/// Columns that one thread fills at a time, and that one step of the factorisation takes.
constexpr int ColumnsPerPiece = 64;
constexpr int ColumnsPerStep = 384;
/// Multiplications and additions between two looks at whether to stop: a fraction of a second.
constexpr double OperationsPerLook = 6e9;

int PiecesOf(Index columns, int perPiece)
{
  return static_cast<int>((columns + perPiece - 1) / perPiece);
}

/// Phi + lambda I, its lower triangle or all of it, into the top left corner of a.
void FillKernels(const RbfProblem& problem, bool lowerOnly, MatrixXd& a, Monitor& monitor,
  const ProgressRange& range)
{
  const Index n = static_cast<Index>(problem.Points.size());
  const auto fill = [&](int piece)
  {
    const Index from = static_cast<Index>(piece) * ColumnsPerPiece;
    for (Index j = from; j < std::min<Index>(n, from + ColumnsPerPiece); ++j)
    {
      for (Index i = lowerOnly ? j : 0; i < n; ++i)
      {
        const Vector3 d = problem.Points[i] - problem.Points[j];
        a(i, j) = problem.Phi.Value(Dot(d, d));
      }
      a(j, j) += problem.Lambda;
    }
  };
  ParallelFor(PiecesOf(n, ColumnsPerPiece), problem.Threads, fill, monitor, range);
}

MatrixXd PolynomialsOf(const std::vector<Point3>& points)
{
  MatrixXd p(static_cast<Index>(points.size()), 4);
  for (Index i = 0; i < p.rows(); ++i)
  {
    p.row(i) << 1, points[i][0], points[i][1], points[i][2];
  }
  return p;
}

/// How many columns of what is left of a factorisation are brought up to date in one go.
int ColumnsPerLook(int rows, int depth)
{
  const double columns = OperationsPerLook / (2.0 * rows * depth);
  return std::max(ColumnsPerStep, static_cast<int>(std::min(columns, 1e6)));
}

/// Progress of a factorisation whose last `left` of m columns are still to be eliminated.
double ProgressOf(double left, int m, const ProgressRange& range)
{
  const double part = left / m;
  return range.From + (range.To - range.From) * (1 - part * part * part);
}

/// The lower triangle of the last `below` columns, less the panel's product with itself.
void SubtractPanel(double* panel, int width, int below, int stride, Monitor& monitor, int m,
  const ProgressRange& range)
{
  const double one = 1;
  const double minusOne = -1;
  double* rest = panel + static_cast<std::size_t>(width) * stride;
  const int columns = ColumnsPerLook(below, width);
  for (int from = 0; from < below; from += columns)
  {
    const int count = std::min(columns, below - from);
    const int rows = below - from - count;
    double* corner = rest + from + static_cast<std::size_t>(from) * stride;
    dsyrk_("L", "N", &count, &width, &minusOne, panel + from, &stride, &one, corner, &stride);
    if (rows > 0)
    {
      dgemm_("N", "T", &rows, &count, &width, &minusOne, panel + from + count, &stride,
        panel + from, &stride, &one, corner + count, &stride);
    }
    const double done = static_cast<double>(from + count) / below;
    monitor.Update(ProgressOf(below + (1 - done) * width, m, range), range.Stage);
  }
}

/**
 * Cholesky's factorisation of the lower triangle of an m x m matrix, in steps, so that a long one
 * shows progress and can be stopped. @returns false where it is not positive definite.
 */
bool CholeskyInSteps(double* a, int m, int stride, Monitor& monitor, const ProgressRange& range)
{
  const double one = 1;
  for (int from = 0; from < m; from += ColumnsPerStep)
  {
    const int width = std::min(ColumnsPerStep, m - from);
    const int below = m - from - width;
    double* corner = a + from + static_cast<std::size_t>(from) * stride;
    int info = 0;
    dpotrf_("L", &width, corner, &stride, &info);
    if (info != 0)
    {
      return false;
    }
    if (below > 0)
    {
      double* panel = corner + width;
      dtrsm_("R", "L", "T", "N", &below, &width, &one, corner, &stride, panel, &stride);
      monitor.Update(ProgressOf(below + width, m, range), range.Stage);
      SubtractPanel(panel, width, below, stride, monitor, m, range);
    }
  }
  monitor.Update(range.To, range.Stage);
  return true;
}

/// Swaps rows as a panel's pivots say, and eliminates, in the columns on the panel's right.
void EliminateRight(double* a, const int* pivots, int from, int width, int m, Monitor& monitor,
  const ProgressRange& range)
{
  const double one = 1;
  const double minusOne = -1;
  const int step = 1;
  const int first = from + 1; // as Fortran counts
  const int last = from + width;
  const int below = m - last;
  const double* corner = a + from + static_cast<std::size_t>(from) * m;
  const int columns = ColumnsPerLook(m - from, width);
  for (int column = last; column < m; column += columns)
  {
    const int count = std::min(columns, m - column);
    double* right = a + static_cast<std::size_t>(column) * m;
    dlaswp_(&count, right, &m, &first, &last, pivots, &step);
    dtrsm_("L", "L", "N", "U", &width, &count, &one, corner, &m, right + from, &m);
    if (below > 0)
    {
      dgemm_("N", "N", &below, &count, &width, &minusOne, corner + width, &m, right + from, &m,
        &one, right + last, &m);
    }
    const double done = static_cast<double>(column + count - last) / below;
    monitor.Update(ProgressOf(below + (1 - done) * width, m, range), range.Stage);
  }
}

/**
 * LU factorisation of an m x m matrix with partial pivoting, in steps as above; pivots as dgetrf
 * gives them. @returns false where it is singular.
 */
bool LUInSteps(double* a, int* pivots, int m, Monitor& monitor, const ProgressRange& range)
{
  const int step = 1;
  for (int from = 0; from < m; from += ColumnsPerStep)
  {
    const int width = std::min(ColumnsPerStep, m - from);
    const int rows = m - from;
    int info = 0;
    dgetrf_(&rows, &width, a + from + static_cast<std::size_t>(from) * m, &m, pivots + from, &info);
    if (info != 0)
    {
      return false;
    }
    for (int k = from; k < from + width; ++k)
    {
      pivots[k] += from;
    }
    const int first = from + 1; // as Fortran counts
    const int last = from + width;
    dlaswp_(&from, a, &m, &first, &last, pivots, &step);
    monitor.Update(ProgressOf(rows, m, range), range.Stage);
    EliminateRight(a, pivots, from, width, m, monitor, range);
  }
  monitor.Update(range.To, range.Stage);
  return true;
}

class ProjectedSystem final : public RbfSystem
{
public:
  /// @returns false where the projected matrix is not positive definite.
  bool Factorise(const RbfProblem& problem, Monitor& monitor)
  {
    this->N = static_cast<Index>(problem.Points.size());
    this->A.resize(this->N, this->N);
    FillKernels(problem, true, this->A, monitor, { 0, 0.15, "preparing the fit" });
    this->QR.compute(PolynomialsOf(problem.Points));
    for (int k = 0; k < 4; ++k)
    {
      this->Reflect(k, problem.Threads, monitor);
    }
    const int m = static_cast<int>(this->N) - 4;
    return CholeskyInSteps(this->A.data() + 4 + 4 * this->N, m, static_cast<int>(this->N), monitor,
      { 0.25, 1, "fitting" });
  }

  RbfSolution Solve(const std::vector<double>& h) const override
  {
    const int m = static_cast<int>(this->N) - 4;
    const int stride = static_cast<int>(this->N);
    const int one = 1;
    int info = 0;
    const auto q = this->QR.householderQ();

    VectorXd g = Eigen::Map<const VectorXd>(h.data(), this->N);
    g.applyOnTheLeft(q.adjoint());
    VectorXd z = g.tail(m);
    dpotrs_("L", &m, &one, this->A.data() + 4 + 4 * this->N, &stride, z.data(), &m, &info);

    // Rows Q1^T Phi Q2 stand, transposed, in the first four columns, which the factorisation left
    // alone.
    const Eigen::Vector4d rest = g.head<4>() - this->A.block(4, 0, m, 4).transpose() * z;
    const Eigen::Vector4d p =
      this->QR.matrixQR().topLeftCorner<4, 4>().triangularView<Eigen::Upper>().solve(rest);

    VectorXd w = VectorXd::Zero(this->N);
    w.tail(m) = z;
    w.applyOnTheLeft(q);
    return { std::vector<double>(w.data(), w.data() + this->N), { p[0], p[1], p[2], p[3] } };
  }

private:
  /// A := H A H with the k-th reflector of P, on the lower triangle only.
  void Reflect(int k, int threads, Monitor& monitor)
  {
    const ProgressRange range{ 0.15 + 0.025 * k, 0.15 + 0.025 * (k + 1), "preparing the fit" };
    VectorXd v = VectorXd::Zero(this->N);
    v[k] = 1;
    v.tail(this->N - k - 1) = this->QR.matrixQR().col(k).tail(this->N - k - 1);
    const double tau = this->QR.hCoeffs()[k];
    VectorXd u = tau * this->TimesLower(v, monitor, range);
    u -= 0.5 * tau * v.dot(u) * v;
    const auto update = [&](int piece)
    {
      const Index from = static_cast<Index>(piece) * ColumnsPerPiece;
      for (Index j = from; j < std::min(this->N, from + ColumnsPerPiece); ++j)
      {
        const Index below = this->N - j;
        this->A.col(j).tail(below) -= v[j] * u.tail(below) + u[j] * v.tail(below);
      }
    };
    ParallelFor(PiecesOf(this->N, ColumnsPerPiece), threads, update, monitor, range);
  }

  /// The symmetric matrix whose lower triangle A holds, times v.
  VectorXd TimesLower(const VectorXd& v, Monitor& monitor, const ProgressRange& range) const
  {
    VectorXd product = VectorXd::Zero(this->N);
    for (Index j = 0; j < this->N; ++j)
    {
      const Index below = this->N - j - 1;
      const auto column = this->A.col(j).tail(below);
      product[j] += this->A(j, j) * v[j] + column.dot(v.tail(below));
      product.tail(below) += v[j] * column;
      if (j % ColumnsPerStep == 0)
      {
        monitor.Update(range.From, range.Stage);
      }
    }
    return product;
  }

  Index N = 0;
  MatrixXd A;
  Eigen::HouseholderQR<MatrixXd> QR;
};

class LUSystem final : public RbfSystem
{
public:
  bool Factorise(const RbfProblem& problem, Monitor& monitor)
  {
    const Index n = static_cast<Index>(problem.Points.size());
    this->A.resize(n + 4, n + 4); // not set to zero: that alone takes a second where it is large
    this->A.bottomRightCorner(4, 4).setZero();
    FillKernels(problem, false, this->A, monitor, { 0, 0.15, "preparing the fit" });
    const MatrixXd p = PolynomialsOf(problem.Points);
    this->A.topRightCorner(n, 4) = p;
    this->A.bottomLeftCorner(4, n) = p.transpose();
    this->Pivots.resize(n + 4);
    const int size = static_cast<int>(n) + 4;
    return LUInSteps(this->A.data(), this->Pivots.data(), size, monitor, { 0.15, 1, "fitting" });
  }

  RbfSolution Solve(const std::vector<double>& h) const override
  {
    const int size = static_cast<int>(this->A.rows());
    const int one = 1;
    int info = 0;
    std::vector<double> x(h);
    x.resize(size, 0.0);
    dgetrs_("N", &size, &one, this->A.data(), &size, this->Pivots.data(), x.data(), &size, &info);
    RbfSolution solution;
    std::copy_n(x.end() - 4, 4, solution.Polynomial.begin());
    x.resize(h.size());
    solution.Weights = std::move(x);
    return solution;
  }

private:
  MatrixXd A;
  std::vector<int> Pivots;
};

template <typename System>
std::unique_ptr<RbfSystem> Factorise(const RbfProblem& problem, Monitor& monitor)
{
  auto system = std::make_unique<System>();
  if (!system->Factorise(problem, monitor))
  {
    return nullptr;
  }
  return system;
}
}

std::unique_ptr<RbfSystem> FactoriseProjected(const RbfProblem& problem, Monitor& monitor)
{
  return Factorise<ProjectedSystem>(problem, monitor);
}

std::unique_ptr<RbfSystem> FactoriseLU(const RbfProblem& problem, Monitor& monitor)
{
  return Factorise<LUSystem>(problem, monitor);
}

double ProjectedGigabytes(std::size_t constraints)
{
  const double n = static_cast<double>(constraints);
  return 8e-9 * n * n;
}

double LUGigabytes(std::size_t constraints)
{
  return ProjectedGigabytes(constraints + 4);
}
}
