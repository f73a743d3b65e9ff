// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairSystem.h"

#include "Base/Monitor.h"
#include "Fair/DissectionOrder.h"
#include "Fair/FrontalCholesky.h"

#include <Eigen/Sparse>

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
using Matrix = Eigen::SparseMatrix<double>;
using Entry = Eigen::Triplet<double>;

/// What tension 1/2 weighs, membrane against thin plate.
constexpr double TensionScale = 10;
/// An edge's cotangents, and a point's area, count at least so much (of a regular mesh's: cotangents
/// .58, area 1): slivers would make the system singular.
constexpr double LeastCotangent = 0.02;
constexpr double LeastArea = 0.1;
/// So much of the diagonal keeps points without any pull around from drifting.
constexpr double Anchorage = 1e-10;

double CotangentAt(const Point3& a, const Point3& b, const Point3& c)
{
  const Vector3 u = b - a;
  const Vector3 v = c - a;
  return Dot(u, v) / std::max(Norm(Cross(u, v)), 1e-300);
}
}

struct FairSystem::Implementation
{
  const TriangleMesh& Mesh;
  double Scale;
  int Threads;
  Monitor& Observer;
  DissectionOrder Order;
  const std::vector<int>& Rank; ///< of a point among the unknowns
  Matrix Membrane;              ///< positive semidefinite
  Matrix ThinPlate;
  Eigen::VectorXd Kept; ///< over the points' areas
  Eigen::MatrixXd Places;
  std::unique_ptr<FrontalCholesky> Factor;

  Implementation(const TriangleMesh& mesh, const std::vector<double>& kept,
    const std::vector<Point3>& rest, double scale, int threads, Monitor& monitor)
    : Mesh(mesh),
      Scale(scale),
      Threads(threads),
      Observer(monitor),
      Order(DissectMesh(mesh)),
      Rank(Order.Rank)
  {
    this->BuildMembrane();
    this->BuildThinPlate(kept);
    this->Places.resize(static_cast<Eigen::Index>(mesh.Points.size()), 3);
    for (std::size_t p = 0; p < mesh.Points.size(); ++p)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Places(this->Rank[p], k) = rest[p][k];
      }
    }
  }

  Eigen::Index Count() const { return static_cast<Eigen::Index>(this->Mesh.Points.size()); }

  void BuildMembrane()
  {
    std::vector<Entry> entries;
    entries.reserve(12 * this->Mesh.Triangles.size());
    for (const auto& t : this->Mesh.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int u = this->Rank[t[(k + 1) % 3]];
        const int v = this->Rank[t[(k + 2) % 3]];
        const double weight = std::max(LeastCotangent,
          0.5 *
            CotangentAt(this->Mesh.Points[t[k]], this->Mesh.Points[t[(k + 1) % 3]],
              this->Mesh.Points[t[(k + 2) % 3]]));
        entries.emplace_back(u, u, weight);
        entries.emplace_back(v, v, weight);
        entries.emplace_back(u, v, -weight);
        entries.emplace_back(v, u, -weight);
      }
    }
    this->Membrane.resize(this->Count(), this->Count());
    this->Membrane.setFromTriplets(entries.begin(), entries.end());
  }

  void BuildThinPlate(const std::vector<double>& kept)
  {
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(this->Count());
    for (const auto& t : this->Mesh.Triangles)
    {
      const auto& points = this->Mesh.Points;
      const double area = Norm(Cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]])) / 6;
      for (const int v : t)
      {
        areas[this->Rank[v]] += area;
      }
    }
    const double least = LeastArea * areas.mean();
    Eigen::VectorXd inverse = areas.cwiseMax(least).cwiseInverse();
    this->Kept = Eigen::VectorXd::Zero(this->Count());
    for (std::size_t p = 0; p < kept.size(); ++p)
    {
      const bool creased = kept[p] == Crease;
      inverse[this->Rank[p]] *= creased ? 0 : 1;
      this->Kept[this->Rank[p]] = creased ? 0 : kept[p];
    }
    this->Kept.array() *= inverse.array();
    this->ThinPlate = this->Membrane * inverse.asDiagonal() * this->Membrane;
  }

  Matrix Pulling(const std::vector<Pull>& pulls, Eigen::MatrixXd& right) const
  {
    const double cube = this->Scale * this->Scale * this->Scale;
    std::vector<Entry> entries;
    entries.reserve(9 * pulls.size());
    for (const Pull& pull : pulls)
    {
      const auto& t = this->Mesh.Triangles[pull.From.Triangle];
      for (int i = 0; i < 3; ++i)
      {
        const double weight = pull.Weight / cube * pull.From.Shares[i];
        for (int j = 0; j < 3; ++j)
        {
          entries.emplace_back(this->Rank[t[i]], this->Rank[t[j]], weight * pull.From.Shares[j]);
        }
        for (int k = 0; k < 3; ++k)
        {
          right(this->Rank[t[i]], k) += weight * pull.To[k];
        }
      }
    }
    Matrix pulling(this->Count(), this->Count());
    pulling.setFromTriplets(entries.begin(), entries.end());
    return pulling;
  }

  std::vector<Point3> Solve(const std::vector<Pull>& pulls, double tension)
  {
    const double membrane = TensionScale * tension / (this->Scale * this->Scale);
    const Eigen::MatrixXd bent = this->Membrane * this->Places;
    Eigen::MatrixXd right = membrane * bent;
    right += (1 - tension) * (this->Membrane * (this->Kept.asDiagonal() * bent));
    Matrix system =
      (1 - tension) * this->ThinPlate + membrane * this->Membrane + this->Pulling(pulls, right);
    const double anchorage = Anchorage * system.diagonal().mean();
    for (Eigen::Index v = 0; v < this->Count(); ++v)
    {
      system.coeffRef(v, v) += anchorage;
    }
    right += anchorage * this->Places;
    if (!this->Factor)
    {
      this->Factor = std::make_unique<FrontalCholesky>(this->Order.Nodes, system);
    }
    if (!this->Factor->Factorise(system, this->Threads, this->Observer))
    {
      throw Error("The equations of the fair surface could not be solved; choose a larger Edge "
                  "Length or Tolerance.");
    }
    const Eigen::MatrixXd solved = this->Factor->Solve(right);
    std::vector<Point3> places(this->Mesh.Points.size());
    for (std::size_t p = 0; p < places.size(); ++p)
    {
      const auto row = solved.row(this->Rank[p]);
      places[p] = { row[0], row[1], row[2] };
    }
    return places;
  }
};

FairSystem::FairSystem(const TriangleMesh& mesh, const std::vector<double>& kept,
  const std::vector<Point3>& rest, double scale, int threads, Monitor& monitor)
  : Impl(std::make_unique<Implementation>(mesh, kept, rest, scale, threads, monitor))
{
}

FairSystem::~FairSystem() = default;

std::vector<Point3> FairSystem::Solve(const std::vector<Pull>& pulls, double tension)
{
  return this->Impl->Solve(pulls, tension);
}
}
