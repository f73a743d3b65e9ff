// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FrontalCholesky.h"

#include "Core/Mesh/MeshShapes.h"

#include <Eigen/SparseCholesky>

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
using Matrix = FrontalCholesky::Matrix;

/// Of points that share a triangle: I + s L, squared, so that it reaches two edges far.
Matrix EquationsOf(const TriangleMesh& mesh, const DissectionOrder& order, double s)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& t : mesh.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int u = order.Rank[t[k]];
      const int v = order.Rank[t[(k + 1) % 3]];
      entries.emplace_back(u, u, 2 * s);
      entries.emplace_back(u, v, -s);
      entries.emplace_back(v, u, -s);
    }
  }
  const auto count = static_cast<Eigen::Index>(mesh.Points.size());
  Matrix one(count, count);
  one.setIdentity();
  Matrix laplacian(count, count);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  one += laplacian;
  return one * one;
}

Eigen::MatrixXd SomeRight(Eigen::Index rows)
{
  Eigen::MatrixXd right(rows, 3);
  for (Eigen::Index i = 0; i < rows; ++i)
  {
    right.row(i) << std::sin(1.0 * static_cast<double>(i)), i % 7, i % 3 == 0;
  }
  return right;
}
}

TEST(FrontalCholesky, SolvesAsColumnByColumn)
{
  Monitor monitor;
  for (const TriangleMesh& mesh :
    { MakeTorus(3, 1, 80, 20), MakeSphere(24, 12), MakeTorus(3, 1, 5, 4) })
  {
    const DissectionOrder order = DissectMesh(mesh);
    const Matrix first = EquationsOf(mesh, order, 1);
    FrontalCholesky cholesky(order.Nodes, first);
    const Eigen::MatrixXd right = SomeRight(first.rows());
    // And once more with other entries at the same places.
    for (const Matrix& matrix : { first, EquationsOf(mesh, order, 20) })
    {
      ASSERT_TRUE(cholesky.Factorise(matrix, 2, monitor));
      const Eigen::SimplicialLDLT<Matrix> other(matrix);
      const Eigen::MatrixXd wanted = other.solve(right);
      EXPECT_LT((cholesky.Solve(right, 1, monitor) - wanted).norm(), 1e-10 * wanted.norm());
    }
  }
}

TEST(FrontalCholesky, SaysWhatIsNotPositiveDefinite)
{
  Monitor monitor;
  const TriangleMesh torus = MakeTorus(3, 1);
  const DissectionOrder order = DissectMesh(torus);
  Matrix matrix = EquationsOf(torus, order, 1);
  FrontalCholesky cholesky(order.Nodes, matrix);
  matrix.coeffRef(matrix.rows() / 2, matrix.rows() / 2) = -1;
  EXPECT_FALSE(cholesky.Factorise(matrix, 0, monitor));
}

TEST(FrontalCholesky, TheBytesDoNotDependOnTheThreads)
{
  Monitor monitor;
  const TriangleMesh torus = MakeTorus(3, 1, 80, 20);
  const DissectionOrder order = DissectMesh(torus);
  const Matrix matrix = EquationsOf(torus, order, 1);
  const Eigen::MatrixXd right = SomeRight(matrix.rows());
  FrontalCholesky one(order.Nodes, matrix);
  FrontalCholesky three(order.Nodes, matrix);
  ASSERT_TRUE(one.Factorise(matrix, 1, monitor));
  ASSERT_TRUE(three.Factorise(matrix, 3, monitor));
  EXPECT_TRUE(one.Solve(right, 1, monitor) == three.Solve(right, 3, monitor));
}
