// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/FairSystem.h"

#include "Base/Median.h"
#include "Base/Parallel.h"
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

/// What tension 1/2 weighs, membrane against thin plate.
constexpr double TensionScale = 10;
/// An edge's cotangents, and a point's area, count at least so much (of a regular mesh's: cotangents
/// .58, area 1), and cotangents at most so much (5 degrees): slivers would make the system singular.
constexpr double LeastCotangent = 0.02;
constexpr double MostCotangent = 6;
constexpr double LeastArea = 0.1;
/// So much of the diagonal's median keeps points without any pull around from drifting.
constexpr double Anchorage = 1e-10;
/// Of means of each point and those beside it, by which a bend is evened out. Measured on half of the sets of
/// Data/TRUTH_FAIR.md: mean distances are 1.001, .978, .962 of the better other method's with 4, 8 and 16 rounds, and
/// .974 with as many as reach over the slices' distance.
constexpr int RoundsOfEvening = 16;
constexpr std::size_t ColumnsABlock = 2048;

/// A matrix with zeros at the rows given, a list a column, in increasing order.
Matrix WithEntriesAt(const std::vector<std::vector<int>>& rows)
{
  const auto count = static_cast<Eigen::Index>(rows.size());
  Matrix matrix(count, count);
  std::size_t entries = 0;
  for (std::size_t column = 0; column < rows.size(); ++column)
  {
    matrix.outerIndexPtr()[column] = static_cast<int>(entries);
    entries += rows[column].size();
  }
  matrix.outerIndexPtr()[rows.size()] = static_cast<int>(entries);
  matrix.resizeNonZeros(static_cast<Eigen::Index>(entries));
  int* place = matrix.innerIndexPtr();
  for (const std::vector<int>& column : rows)
  {
    place = std::copy(column.begin(), column.end(), place);
  }
  std::fill_n(matrix.valuePtr(), entries, 0.0);
  return matrix;
}

/// Where an entry that the matrix has is among its values.
int PlaceOf(const Matrix& matrix, int row, int column)
{
  const int* begin = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column];
  const int* end = matrix.innerIndexPtr() + matrix.outerIndexPtr()[column + 1];
  return static_cast<int>(std::lower_bound(begin, end, row) - matrix.innerIndexPtr());
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
  Matrix Tense;                 ///< the same, by the points' tension
  std::vector<std::array<int, 6>>
    Places; ///< of a triangle's sides among the membrane's values, both ways
  Eigen::VectorXd Areas;
  Eigen::VectorXd InverseAreas; ///< by what the plate weighs there
  Eigen::VectorXd Kept;
  Eigen::VectorXd Creased; ///< 0 where the surface bends as it likes, else 1
  Eigen::MatrixXd Rest;
  Matrix System; ///< the lower triangle
  std::unique_ptr<FrontalCholesky> Factor;

  Implementation(const TriangleMesh& mesh, const std::vector<double>& kept, double scale,
    int threads, Monitor& monitor)
    : Mesh(mesh),
      Scale(scale),
      Threads(threads),
      Observer(monitor),
      Order(DissectMesh(mesh)),
      Rank(Order.Rank)
  {
    this->FindEntriesOfMembrane();
    this->FindEntriesOfSystem();
    this->Rest.resize(this->Count(), 3);
    this->Kept = Eigen::VectorXd::Zero(this->Count());
    this->Creased = Eigen::VectorXd::Ones(this->Count());
    for (std::size_t p = 0; p < mesh.Points.size(); ++p)
    {
      const int row = this->Rank[p];
      this->Rest.row(row) << mesh.Points[p][0], mesh.Points[p][1], mesh.Points[p][2];
      if (!kept.empty())
      {
        this->Creased[row] = kept[p] == Crease ? 0 : 1;
        this->Kept[row] = kept[p] == Crease ? 0 : kept[p];
      }
    }
    this->Factor = std::make_unique<FrontalCholesky>(this->Order.Nodes, this->System);
  }

  Eigen::Index Count() const { return static_cast<Eigen::Index>(this->Mesh.Points.size()); }

  /// Every point with itself and those beside it.
  void FindEntriesOfMembrane()
  {
    std::vector<std::vector<int>> rows(this->Mesh.Points.size());
    for (const auto& t : this->Mesh.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        rows[this->Rank[t[k]]].push_back(this->Rank[t[(k + 1) % 3]]);
        rows[this->Rank[t[k]]].push_back(this->Rank[t[(k + 2) % 3]]);
      }
    }
    for (std::size_t column = 0; column < rows.size(); ++column)
    {
      rows[column].push_back(static_cast<int>(column));
      std::sort(rows[column].begin(), rows[column].end());
      rows[column].erase(std::unique(rows[column].begin(), rows[column].end()), rows[column].end());
    }
    this->Membrane = WithEntriesAt(rows);
    for (const auto& t : this->Mesh.Triangles)
    {
      std::array<int, 6> places{};
      for (int k = 0; k < 3; ++k)
      {
        const int u = this->Rank[t[(k + 1) % 3]];
        const int v = this->Rank[t[(k + 2) % 3]];
        places[2 * k] = PlaceOf(this->Membrane, u, v);
        places[2 * k + 1] = PlaceOf(this->Membrane, v, u);
      }
      this->Places.push_back(places);
    }
  }

  /// Every point with those of later columns that are no more than two edges away.
  void FindEntriesOfSystem()
  {
    std::vector<std::vector<int>> rows(this->Mesh.Points.size());
    ParallelForBlocks(rows.size(), ColumnsABlock, this->Threads,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t column = from; column < to; ++column)
        {
          const int least = static_cast<int>(column);
          std::vector<int>& found = rows[column];
          for (Matrix::InnerIterator beside(this->Membrane, least); beside; ++beside)
          {
            for (Matrix::InnerIterator next(this->Membrane, beside.row()); next; ++next)
            {
              if (next.row() >= least)
              {
                found.push_back(static_cast<int>(next.row()));
              }
            }
          }
          std::sort(found.begin(), found.end());
          found.erase(std::unique(found.begin(), found.end()), found.end());
        }
      },
      this->Observer, { 0, 0, "fairing" });
    this->System = WithEntriesAt(rows);
  }

  /// Membrane and areas of the mesh in this shape.
  void Measure(const std::vector<Point3>& shape)
  {
    double* values = this->Membrane.valuePtr();
    std::fill_n(values, this->Membrane.nonZeros(), 0.0);
    Eigen::VectorXd areas = Eigen::VectorXd::Zero(this->Count());
    for (std::size_t i = 0; i < this->Mesh.Triangles.size(); ++i)
    {
      const auto& t = this->Mesh.Triangles[i];
      const std::array<Vector3, 3> sides{ shape[t[2]] - shape[t[1]], shape[t[0]] - shape[t[2]],
        shape[t[1]] - shape[t[0]] };
      const double twice = Norm(Cross(sides[1], sides[2]));
      for (int k = 0; k < 3; ++k)
      {
        const double cotangent =
          -Dot(sides[(k + 1) % 3], sides[(k + 2) % 3]) / std::max(twice, 1e-300);
        const double weight = std::clamp(0.5 * cotangent, LeastCotangent, MostCotangent);
        values[this->Places[i][2 * k]] -= weight;
        values[this->Places[i][2 * k + 1]] -= weight;
        areas[this->Rank[t[k]]] += twice / 6;
      }
    }
    // What a column adds up to is nothing.
    for (int column = 0; column < this->Count(); ++column)
    {
      double sum = 0;
      double* diagonal = nullptr;
      for (Matrix::InnerIterator entry(this->Membrane, column); entry; ++entry)
      {
        sum += entry.value();
        diagonal = entry.row() == column ? &entry.valueRef() : diagonal;
      }
      *diagonal = -sum;
    }
    const double least = LeastArea * areas.mean();
    this->Areas = areas.cwiseMax(least);
    this->InverseAreas = this->Areas.cwiseInverse().cwiseProduct(this->Creased);
  }

  /// Each edge of the membrane by the mean of its ends' tension, and areas by what is left for the plate.
  void MakeTense(const std::vector<double>& tension)
  {
    Eigen::VectorXd tensions(this->Count());
    for (std::size_t p = 0; p < tension.size(); ++p)
    {
      tensions[this->Rank[p]] = tension[p];
    }
    const double stiffness = TensionScale / (this->Scale * this->Scale);
    this->Tense = this->Membrane;
    for (int column = 0; column < this->Count(); ++column)
    {
      double sum = 0;
      double* diagonal = nullptr;
      for (Matrix::InnerIterator entry(this->Tense, column); entry; ++entry)
      {
        if (entry.row() == column)
        {
          diagonal = &entry.valueRef();
          continue;
        }
        entry.valueRef() *= 0.5 * stiffness * (tensions[entry.row()] + tensions[column]);
        sum += entry.value();
      }
      *diagonal = -sum;
    }
    this->InverseAreas =
      this->InverseAreas.cwiseProduct(Eigen::VectorXd::Ones(this->Count()) - tensions);
  }

  /// The sum of thin plate and membrane, without pulls.
  void FillSystem()
  {
    ParallelForBlocks(this->Mesh.Points.size(), ColumnsABlock, this->Threads,
      [&](std::size_t from, std::size_t to)
      {
        // A row's place in the column that is filled.
        std::vector<int> placeOf(this->Mesh.Points.size());
        for (std::size_t column = from; column < to; ++column)
        {
          this->FillColumn(static_cast<int>(column), placeOf);
        }
      },
      this->Observer, { 0, 0, "fairing" });
  }

  void FillColumn(int column, std::vector<int>& placeOf)
  {
    double* values = this->System.valuePtr();
    const int begin = this->System.outerIndexPtr()[column];
    const int end = this->System.outerIndexPtr()[column + 1];
    for (int place = begin; place < end; ++place)
    {
      placeOf[this->System.innerIndexPtr()[place]] = place;
      values[place] = 0;
    }
    for (Matrix::InnerIterator tense(this->Tense, column); tense; ++tense)
    {
      if (tense.row() >= column)
      {
        values[placeOf[tense.row()]] += tense.value();
      }
    }
    for (Matrix::InnerIterator beside(this->Membrane, column); beside; ++beside)
    {
      const int row = static_cast<int>(beside.row());
      const double share = beside.value() * this->InverseAreas[row];
      for (Matrix::InnerIterator next(this->Membrane, row); next; ++next)
      {
        if (next.row() >= column)
        {
          values[placeOf[next.row()]] += share * next.value();
        }
      }
    }
  }

  void AddPulls(const std::vector<Pull>& pulls, Eigen::MatrixXd& right)
  {
    const double cube = this->Scale * this->Scale * this->Scale;
    double* values = this->System.valuePtr();
    for (const Pull& pull : pulls)
    {
      const auto& t = this->Mesh.Triangles[pull.From.Triangle];
      for (int i = 0; i < 3; ++i)
      {
        const int row = this->Rank[t[i]];
        const double weight = pull.Weight / cube * pull.From.Shares[i];
        for (int j = 0; j < 3; ++j)
        {
          if (row >= this->Rank[t[j]])
          {
            values[PlaceOf(this->System, row, this->Rank[t[j]])] += weight * pull.From.Shares[j];
          }
        }
        for (int k = 0; k < 3; ++k)
        {
          right(row, k) += weight * pull.To[k];
        }
      }
    }
  }

  /// Of each column the first entry is that of the diagonal.
  void Anchor(Eigen::MatrixXd& right)
  {
    std::vector<double> diagonal(this->Count());
    for (Eigen::Index v = 0; v < this->Count(); ++v)
    {
      diagonal[v] = this->System.valuePtr()[this->System.outerIndexPtr()[v]];
    }
    // Not the mean: a single sliver, or a strong pull, would hold all points where they are.
    const double anchorage = Anchorage * Median(diagonal);
    for (Eigen::Index v = 0; v < this->Count(); ++v)
    {
      this->System.valuePtr()[this->System.outerIndexPtr()[v]] += anchorage;
    }
    right += anchorage * this->Rest;
  }

  /// Unit normals, a row a point.
  Eigen::MatrixXd NormalsOf(const Eigen::MatrixXd& at) const
  {
    Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(this->Count(), 3);
    for (const auto& t : this->Mesh.Triangles)
    {
      const Eigen::RowVector3d from = at.row(this->Rank[t[0]]);
      const Eigen::RowVector3d u = at.row(this->Rank[t[1]]) - from;
      const Eigen::RowVector3d v = at.row(this->Rank[t[2]]) - from;
      const Eigen::RowVector3d normal = u.cross(v);
      for (const int p : t)
      {
        normals.row(this->Rank[p]) += normal;
      }
    }
    // One of no direction stays nothing.
    normals.rowwise().normalize();
    return normals;
  }

  /// Of each point the mean of itself and those beside it, by their areas, again and again; what bends as
  /// it likes says nothing.
  Eigen::VectorXd EvenedOut(Eigen::VectorXd values) const
  {
    const Eigen::VectorXd weights = this->Areas.cwiseProduct(this->Creased);
    Eigen::VectorXd next(this->Count());
    for (int round = 0; round < RoundsOfEvening; ++round)
    {
      ParallelForBlocks(static_cast<std::size_t>(this->Count()), ColumnsABlock, this->Threads,
        [&](std::size_t from, std::size_t to)
        {
          for (int p = static_cast<int>(from); p < static_cast<int>(to); ++p)
          {
            // A point is a corner of half as many triangles as those beside it together.
            const int* column = this->Membrane.outerIndexPtr() + p;
            const double own = 0.5 * (column[1] - column[0] - 3);
            double sum = own * weights[p] * values[p];
            double weight = own * weights[p];
            for (Matrix::InnerIterator beside(this->Membrane, p); beside; ++beside)
            {
              sum += weights[beside.row()] * values[beside.row()];
              weight += weights[beside.row()];
            }
            next[p] = weight > 0 ? sum / weight : values[p];
          }
        },
        this->Observer, { 0, 0, "fairing" });
      values.swap(next);
    }
    return values;
  }

  /// What the right side gets so that the surface bends as this one does, evened out.
  Eigen::MatrixXd EvenBend(const Eigen::MatrixXd& at) const
  {
    const Eigen::MatrixXd normals = this->NormalsOf(at);
    const Eigen::MatrixXd bent = this->Membrane * at;
    const Eigen::VectorXd bends = this->EvenedOut(
      bent.cwiseProduct(normals).rowwise().sum().cwiseProduct(this->Areas.cwiseInverse()));
    const Eigen::VectorXd wanted =
      this->InverseAreas.cwiseProduct(this->Areas)
        .cwiseProduct(Eigen::VectorXd::Ones(this->Count()) - this->Kept)
        .cwiseProduct(bends);
    return this->Membrane * (wanted.asDiagonal() * normals);
  }

  std::vector<Point3> Solve(const std::vector<Point3>& shape, const std::vector<Pull>& pulls,
    const std::vector<double>& tension, int evenings)
  {
    this->Measure(shape);
    this->MakeTense(tension);
    Eigen::MatrixXd right = this->Tense * this->Rest;
    const Eigen::VectorXd kept = this->Kept.cwiseProduct(this->InverseAreas);
    right += this->Membrane * (kept.asDiagonal() * (this->Membrane * this->Rest));
    this->FillSystem();
    this->AddPulls(pulls, right);
    this->Anchor(right);
    if (!this->Factor->Factorise(this->System, this->Threads, this->Observer))
    {
      throw Error("The equations of the fair surface could not be solved; choose a larger Edge "
                  "Length or Tolerance.");
    }
    Eigen::MatrixXd solved = this->Factor->Solve(right, this->Threads, this->Observer);
    for (int evening = 0; evening < evenings; ++evening)
    {
      this->Observer.Update(0, "fairing");
      solved = this->Factor->Solve(right + this->EvenBend(solved), this->Threads, this->Observer);
    }
    std::vector<Point3> places(this->Mesh.Points.size());
    for (std::size_t p = 0; p < places.size(); ++p)
    {
      const auto row = solved.row(this->Rank[p]);
      places[p] = { row[0], row[1], row[2] };
    }
    return places;
  }

  std::vector<double> BendOf(const std::vector<Point3>& shape)
  {
    this->Measure(shape);
    Eigen::MatrixXd at(this->Count(), 3);
    for (std::size_t p = 0; p < shape.size(); ++p)
    {
      at.row(this->Rank[p]) << shape[p][0], shape[p][1], shape[p][2];
    }
    const Eigen::MatrixXd bent = this->InverseAreas.asDiagonal() * (this->Membrane * at);
    std::vector<double> bends(shape.size());
    for (std::size_t p = 0; p < shape.size(); ++p)
    {
      bends[p] = this->Scale * bent.row(this->Rank[p]).norm();
    }
    return bends;
  }
};

FairSystem::FairSystem(const TriangleMesh& mesh, const std::vector<double>& kept, double scale,
  int threads, Monitor& monitor)
  : Impl(std::make_unique<Implementation>(mesh, kept, scale, threads, monitor))
{
}

FairSystem::~FairSystem() = default;

std::vector<Point3> FairSystem::Solve(const std::vector<Point3>& shape,
  const std::vector<Pull>& pulls, const std::vector<double>& tension, int evenings)
{
  return this->Impl->Solve(shape, pulls, tension, evenings);
}

std::vector<double> FairSystem::BendOf(const std::vector<Point3>& shape)
{
  return this->Impl->BendOf(shape);
}
}
