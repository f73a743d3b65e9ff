// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/SparseRbfSystem.h"
#include "Base/PointGrid.h"

#include <Eigen/SparseCholesky>

namespace recon
{
namespace
{
using Matrix = Eigen::SparseMatrix<double>;

class SparseSystem final : public RbfSystem
{
public:
  bool Factorise(const RbfProblem& problem, Monitor& monitor)
  {
    const Matrix a = Fill(problem, monitor);
    monitor.Update(0.3, "fitting");
    this->Factors.compute(a);
    monitor.Update(1, "fitting");
    return this->Factors.info() == Eigen::Success;
  }

  RbfSolution Solve(const std::vector<double>& h) const override
  {
    const Eigen::Index n = static_cast<Eigen::Index>(h.size());
    const Eigen::VectorXd w = this->Factors.solve(Eigen::Map<const Eigen::VectorXd>(h.data(), n));
    return { std::vector<double>(w.data(), w.data() + n), { 0, 0, 0, 0 } };
  }

private:
  static Matrix Fill(const RbfProblem& problem, Monitor& monitor)
  {
    const int n = static_cast<int>(problem.Points.size());
    const PointGrid grid(problem.Points, problem.Phi.Radius);
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < n; ++j)
    {
      grid.ForNear(problem.Points[j], problem.Phi.Radius,
        [&](int i, double r2)
        {
          if (i >= j)
          {
            entries.emplace_back(i, j, problem.Phi.Value(r2) + (i == j ? problem.Lambda : 0));
          }
        });
      if (j % 64 == 0)
      {
        monitor.Update(0.3 * j / n, "preparing the fit");
      }
    }
    Matrix a(n, n);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
  }

  Eigen::SimplicialLLT<Matrix, Eigen::Lower> Factors;
};
}

std::unique_ptr<RbfSystem> FactoriseSparse(const RbfProblem& problem, Monitor& monitor)
{
  auto system = std::make_unique<SparseSystem>();
  if (!system->Factorise(problem, monitor))
  {
    return nullptr;
  }
  return system;
}
}
