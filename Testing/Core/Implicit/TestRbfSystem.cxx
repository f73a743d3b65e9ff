// SPDX-License-Identifier: GPL-3.0-or-later
// The ways to factorise a system: each must solve it. DenseRbfSystem, SparseRbfSystem, RbfSystem.
#include "Base/Monitor.h"
#include "Implicit/Solver/DenseRbfSystem.h"
#include "Implicit/Solver/RbfSystem.h"
#include "Implicit/Solver/SparseRbfSystem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace recon;

namespace
{
RbfProblem MakeProblem(Kernel::KindType kind, int count)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> anywhere(-1, 1);
  RbfProblem problem;
  problem.Phi = { kind, 0.7 };
  for (int i = 0; i < count; ++i)
  {
    problem.Points.push_back({ anywhere(random), anywhere(random), anywhere(random) });
  }
  return problem;
}

std::vector<double> MakeValues(std::size_t count)
{
  std::vector<double> h;
  for (std::size_t i = 0; i < count; ++i)
  {
    h.push_back(std::cos(static_cast<double>(i)));
  }
  return h;
}

/// Every constraint holds, and the weights are orthogonal to linear polynomials where there is one.
void ExpectSolved(const RbfProblem& problem, const RbfSolution& solution,
  const std::vector<double>& h, bool polynomial)
{
  ASSERT_EQ(solution.Weights.size(), h.size());
  std::array<double, 4> moments{};
  for (std::size_t i = 0; i < h.size(); ++i)
  {
    const Point3& p = problem.Points[i];
    double value = solution.Polynomial[0] + solution.Polynomial[1] * p[0] +
      solution.Polynomial[2] * p[1] + solution.Polynomial[3] * p[2];
    value += problem.Lambda * solution.Weights[i];
    for (std::size_t j = 0; j < h.size(); ++j)
    {
      const Vector3 d = p - problem.Points[j];
      value += solution.Weights[j] * problem.Phi.Value(Dot(d, d));
    }
    EXPECT_NEAR(value, h[i], 1e-9);
    moments[0] += solution.Weights[i];
    for (int k = 0; k < 3; ++k)
    {
      moments[k + 1] += solution.Weights[i] * p[k];
    }
  }
  for (int k = 0; k < 4 && polynomial; ++k)
  {
    EXPECT_NEAR(moments[k], 0, 1e-9);
  }
}
}

TEST(DenseRbfSystem, BothFactorisationsSolve)
{
  Monitor monitor;
  RbfProblem problem = MakeProblem(Kernel::Triharmonic, 60);
  const auto h = MakeValues(60);
  for (const double lambda : { 0.0, 0.01 })
  {
    problem.Lambda = lambda;
    for (const auto factorise : { FactoriseProjected, FactoriseLU })
    {
      const auto system = factorise(problem, monitor);
      ASSERT_TRUE(system);
      ExpectSolved(problem, system->Solve(h), h, true);
    }
  }
}

TEST(DenseRbfSystem, PointsOfAPlaneHaveNoSolutionThatIsOne)
{
  Monitor monitor;
  RbfProblem problem = MakeProblem(Kernel::Triharmonic, 20);
  for (Point3& p : problem.Points)
  {
    p[2] = 0;
  }
  EXPECT_FALSE(FactoriseLU(problem, monitor));
}

TEST(DenseRbfSystem, MemoryGrowsWithTheSquare)
{
  EXPECT_NEAR(LUGigabytes(20000) / LUGigabytes(10000), 4, 0.2);
  EXPECT_NEAR(ProjectedGigabytes(20000) / ProjectedGigabytes(10000), 4, 0.2);
  EXPECT_GE(LUGigabytes(10000), 8e8 / 1.1e9); // a matrix of doubles
}

TEST(SparseRbfSystem, Solves)
{
  Monitor monitor;
  RbfProblem problem = MakeProblem(Kernel::Wendland, 150);
  const auto h = MakeValues(150);
  const auto system = FactoriseSparse(problem, monitor);
  ASSERT_TRUE(system);
  const RbfSolution solution = system->Solve(h);
  EXPECT_EQ(solution.Polynomial, (std::array<double, 4>{ 0, 0, 0, 0 }));
  ExpectSolved(problem, solution, h, false);
}

TEST(SparseRbfSystem, APointThatIsThereTwiceHasNoFactor)
{
  Monitor monitor;
  RbfProblem problem = MakeProblem(Kernel::Wendland, 30);
  problem.Points[29] = problem.Points[0];
  EXPECT_FALSE(FactoriseSparse(problem, monitor));
}
