// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Solver/InverseCholesky.h"

#include "Base/Parallel.h"
#include "Implicit/Solver/SmallCholesky.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace recon
{
namespace
{
constexpr const char* Stage = "preparing the fit";
constexpr int Simplex = MaximinOrder::Simplex;
constexpr int GroupsPerPiece = 8;     ///< of parallel work
constexpr int GroupsPerUpdate = 1024; ///< between looks at the progress and for an abort
constexpr int RowsPerPiece = 4096;    ///< of parallel work
/// Below this, weights would grow so large that the products' own rounding, in doubles, were more
/// than the values: to working precision the point repeats those before it. It gets no weight; what
/// the others make there is its misfit.
constexpr double LeastPivot = 1e-13;
int PiecesOf(std::size_t count, int perPiece)
{
  return static_cast<int>((count + perPiece - 1) / perPiece);
}
}

/// What one factorisation needs, kept from group to group.
class InverseCholesky::Workspace
{
public:
  std::vector<double> Matrix;
  std::vector<double> Right;
  std::vector<double> X, Y, Z;
  std::vector<double> LQ;        ///< points and the eight rows l, q side by side
  std::vector<long double> Wide; ///< the matrix again, row after row, where doubles do not suffice

  /// The lower triangle of K on a set of ranks.
  void Fill(const InverseCholesky& self, const std::int32_t* set, int size);
};

void InverseCholesky::Workspace::Fill(
  const InverseCholesky& self, const std::int32_t* set, int size)
{
  this->LQ.resize(static_cast<std::size_t>(size) * 11);
  this->Matrix.resize(static_cast<std::size_t>(size) * size);
  for (int i = 0; i < size; ++i)
  {
    const int rank = set[i];
    for (int a = 0; a < 3; ++a)
    {
      this->LQ[i + static_cast<std::size_t>(a) * size] = self.Order.Points()[rank][a];
    }
    for (int a = 0; a < 4; ++a)
    {
      this->LQ[i + static_cast<std::size_t>(3 + a) * size] = self.L[rank][a];
      this->LQ[i + static_cast<std::size_t>(7 + a) * size] = self.Q[rank][a];
    }
  }
  for (int j = 0; j < size; ++j)
  {
    FillProjectedColumn(this->LQ.data(), size, j, self.Options.Lambda,
      this->Matrix.data() + static_cast<std::size_t>(j) * size);
  }
}

InverseCholesky::InverseCholesky(
  const MaximinOrder& order, const InverseCholeskyOptions& options, Monitor& monitor)
  : Order(order),
    Options(options)
{
  this->FindSimplex();
  monitor.Update(0, Stage);
  this->FindGroups();
  monitor.Update(0, Stage);
  this->FindSets(monitor);
  const int pieces = PiecesOf(this->Groups.size(), GroupsPerPiece);
  ParallelFor(pieces, options.Threads,
    [&](int piece)
    {
      Workspace work;
      const int from = piece * GroupsPerPiece;
      const int to = std::min(static_cast<int>(this->Groups.size()), from + GroupsPerPiece);
      for (int g = from; g < to; ++g)
      {
        this->Factorise(g, work);
      }
    },
    monitor, { 0.2, 1, Stage });
  this->FindSlots();
}

InverseCholesky::Row InverseCholesky::Barycentric(const Point3& x) const
{
  Row l{};
  for (int a = 0; a < 4; ++a)
  {
    l[a] = this->Inverse[0][a] + x[0] * this->Inverse[1][a] + x[1] * this->Inverse[2][a] +
      x[2] * this->Inverse[3][a];
  }
  return l;
}

void InverseCholesky::FindSimplex()
{
  const std::vector<Point3>& points = this->Order.Points();
  Eigen::Matrix4d rows;
  for (int a = 0; a < Simplex; ++a)
  {
    rows.row(a) << 1, points[a][0], points[a][1], points[a][2];
  }
  const Eigen::Matrix4d inverse = rows.fullPivLu().inverse();
  Eigen::Matrix4d phi;
  for (int a = 0; a < Simplex; ++a)
  {
    for (int b = 0; b < Simplex; ++b)
    {
      this->Inverse[a][b] = inverse(a, b);
      const double r = Norm(points[a] - points[b]);
      phi(a, b) = r * r * r;
    }
  }
  this->L.resize(points.size());
  this->Q.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    this->L[i] = this->Barycentric(points[i]);
    for (int a = 0; a < Simplex; ++a)
    {
      const double r = Norm(points[i] - points[a]);
      double half = 0;
      for (int b = 0; b < Simplex; ++b)
      {
        half += 0.5 * phi(a, b) * this->L[i][b];
      }
      this->Q[i][a] = r * r * r - half;
    }
  }
}

/// The first ones together, the others by level and, within a level, by place.
void InverseCholesky::FindGroups()
{
  const int n = static_cast<int>(this->Order.Points().size());
  const int exact = std::min(n, this->Options.Exact + Simplex);
  std::vector<int> level(exact - Simplex);
  for (int i = Simplex; i < exact; ++i)
  {
    level[i - Simplex] = i;
  }
  if (!level.empty())
  {
    this->MembersOf.push_back(level);
  }
  const std::vector<double>& l = this->Order.Distances();
  for (int from = exact; from < n;)
  {
    level.clear();
    int to = from;
    while (to < n && l[to] >= this->Options.LevelRatio * l[from])
    {
      level.push_back(to++);
    }
    this->GroupLevel(level);
    from = to;
  }
}

/// Halved across its longest side until it is small enough.
void InverseCholesky::GroupLevel(std::vector<int> ranks)
{
  if (static_cast<int>(ranks.size()) <= this->Options.Members)
  {
    std::sort(ranks.begin(), ranks.end());
    this->MembersOf.push_back(std::move(ranks));
    return;
  }
  const std::vector<Point3>& points = this->Order.Points();
  Point3 low = points[ranks.front()];
  Point3 high = low;
  for (const int i : ranks)
  {
    for (int a = 0; a < 3; ++a)
    {
      low[a] = std::min(low[a], points[i][a]);
      high[a] = std::max(high[a], points[i][a]);
    }
  }
  const Vector3 size = high - low;
  const int axis = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  // Whole multiples of the group's size on one side, so that few groups are left half full.
  const std::size_t groups =
    (ranks.size() + this->Options.Members - 1) / static_cast<std::size_t>(this->Options.Members);
  const std::size_t half = groups / 2 * this->Options.Members;
  const auto middle = ranks.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(ranks.begin(), middle, ranks.end(),
    [&](int i, int j)
    { return std::make_pair(points[i][axis], i) < std::make_pair(points[j][axis], j); });
  this->GroupLevel(std::vector<int>(ranks.begin(), middle));
  this->GroupLevel(std::vector<int>(middle, ranks.end()));
}

void InverseCholesky::FindSets(Monitor& monitor)
{
  std::vector<std::vector<int>> sets(this->MembersOf.size());
  const auto find = [&](int g)
  {
    const std::vector<int>& members = this->MembersOf[g];
    std::vector<int> set = members;
    if (members.front() > Simplex)
    {
      for (int i = Simplex; i < Simplex + this->Options.First; ++i)
      {
        set.push_back(i);
      }
      for (const int i : members)
      {
        const auto near = this->Order.Nearest(this->Order.Points()[i], i, this->Options.Neighbours);
        set.insert(set.end(), near.begin(), near.end());
      }
    }
    std::sort(set.begin(), set.end());
    set.erase(std::unique(set.begin(), set.end()), set.end());
    set.erase(set.begin(), std::lower_bound(set.begin(), set.end(), Simplex));
    sets[g] = std::move(set);
  };
  const int count = static_cast<int>(sets.size());
  ParallelFor(PiecesOf(sets.size(), GroupsPerPiece), this->Options.Threads,
    [&](int piece)
    {
      for (int g = piece * GroupsPerPiece; g < std::min(count, (piece + 1) * GroupsPerPiece); ++g)
      {
        find(g);
      }
    },
    monitor, { 0, 0.2, Stage });

  std::size_t entries = 0;
  for (int g = 0; g < count; ++g)
  {
    if (g % GroupsPerUpdate == 0)
    {
      monitor.Update(0.2, Stage);
    }
    const std::vector<int>& members = this->MembersOf[g];
    const std::vector<int>& set = sets[g];
    this->Groups.push_back({ this->Sets.size(), entries, static_cast<int>(set.size()),
      static_cast<int>(this->MemberAt.size()), static_cast<int>(members.size()) });
    this->Sets.insert(this->Sets.end(), set.begin(), set.end());
    for (const int i : members)
    {
      const auto at = std::lower_bound(set.begin(), set.end(), i) - set.begin();
      this->MemberAt.push_back(static_cast<std::int32_t>(at));
      entries += static_cast<std::size_t>(at) + 1;
    }
    sets[g] = {};
  }
  this->MembersOf = {};
  monitor.Update(0.2, Stage);
  this->Entries.resize(entries);
}

void InverseCholesky::Factorise(int at, Workspace& work)
{
  const Group& group = this->Groups[at];
  const int size = group.SetSize;
  work.Fill(*this, this->Sets.data() + group.Set, size);
  if (!FactoriseSmall(work.Matrix.data(), size))
  {
    this->FactoriseWide(at, work);
    return;
  }
  double* out = this->Entries.data() + group.Columns;
  for (int from = 0; from < group.Members; from += SolvedTogether)
  {
    const int count = std::min(SolvedTogether, group.Members - from);
    const std::int32_t* places = this->MemberAt.data() + group.Member + from;
    const int last = places[count - 1];
    work.Right.assign(static_cast<std::size_t>(last + 1) * SolvedTogether, 0);
    // Column i of U is L^-T e_i: below its own place a right-hand side stays 0.
    for (int l = 0; l < count; ++l)
    {
      work.Right[static_cast<std::size_t>(places[l]) * SolvedTogether + l] = 1;
    }
    SolveTransposed(work.Matrix.data(), size, last, work.Right.data());
    for (int l = 0; l < count; ++l)
    {
      for (int i = 0; i <= places[l]; ++i)
      {
        *out++ = work.Right[static_cast<std::size_t>(i) * SolvedTogether + l];
      }
    }
  }
}

void InverseCholesky::FactoriseWide(int at, Workspace& work)
{
  using Wide = long double;
  const Group& group = this->Groups[at];
  const int size = group.SetSize;
  const Wide lambda = this->Options.Lambda;
  const double* rows = work.LQ.data();
  const auto of = [&](int i, int column)
  { return static_cast<Wide>(rows[i + static_cast<std::size_t>(column) * size]); };
  work.Wide.assign(static_cast<std::size_t>(size) * size, 0);
  Wide* factor = work.Wide.data();
  for (int i = 0; i < size; ++i)
  {
    Wide* row = factor + static_cast<std::size_t>(i) * size;
    for (int j = 0; j <= i; ++j)
    {
      const Wide x = of(i, 0) - of(j, 0);
      const Wide y = of(i, 1) - of(j, 1);
      const Wide z = of(i, 2) - of(j, 2);
      const Wide square = x * x + y * y + z * z;
      Wide k = square * std::sqrt(square) + (i == j ? lambda : 0);
      for (int a = 0; a < 4; ++a)
      {
        k -= of(i, 3 + a) * of(j, 7 + a) + of(j, 3 + a) * of(i, 7 + a);
        k += lambda * of(i, 3 + a) * of(j, 3 + a);
      }
      const Wide* before = factor + static_cast<std::size_t>(j) * size;
      for (int q = 0; q < j; ++q)
      {
        k -= row[q] * before[q];
      }
      // A diagonal of 0 is a point that repeats others and takes no part.
      row[j] = i == j ? (k > LeastPivot ? std::sqrt(k) : 0) : (before[j] > 0 ? k / before[j] : 0);
    }
  }
  double* out = this->Entries.data() + group.Columns;
  std::vector<Wide> column;
  for (int m = 0; m < group.Members; ++m)
  {
    const int last = this->MemberAt[group.Member + m];
    column.assign(last + 1, 0);
    column[last] = 1;
    for (int i = last; i >= 0; --i)
    {
      const Wide* row = factor + static_cast<std::size_t>(i) * size;
      column[i] = row[i] > 0 ? column[i] / row[i] : 0;
      for (int q = 0; q < i; ++q)
      {
        column[q] -= row[q] * column[i];
      }
    }
    out = std::transform(
      column.begin(), column.end(), out, [](Wide x) { return static_cast<double>(x); });
  }
}

void InverseCholesky::FindSlots()
{
  const std::size_t n = this->Order.Points().size();
  this->SlotBegin.assign(n + 1, 0);
  for (const std::int32_t rank : this->Sets)
  {
    ++this->SlotBegin[rank + 1];
  }
  for (std::size_t i = 0; i < n; ++i)
  {
    this->SlotBegin[i + 1] += this->SlotBegin[i];
  }
  this->SlotsOf.resize(this->Sets.size());
  std::vector<std::size_t> next(this->SlotBegin.begin(), this->SlotBegin.end() - 1);
  for (std::size_t s = 0; s < this->Sets.size(); ++s)
  {
    this->SlotsOf[next[this->Sets[s]]++] = static_cast<std::uint32_t>(s);
  }
}

std::vector<double> InverseCholesky::Project(const std::vector<double>& r) const
{
  std::vector<double> projected(r.size());
  for (std::size_t i = Simplex; i < r.size(); ++i)
  {
    const Row& l = this->L[i];
    projected[i] = r[i] - (l[0] * r[0] + l[1] * r[1] + l[2] * r[2] + l[3] * r[3]);
  }
  return projected;
}

std::vector<double> InverseCholesky::Apply(
  const std::vector<double>& projected, Monitor& monitor) const
{
  const std::size_t n = projected.size();
  std::vector<double> slots(this->Sets.size());
  const int count = static_cast<int>(this->Groups.size());
  ParallelFor(PiecesOf(this->Groups.size(), 16 * GroupsPerPiece), this->Options.Threads,
    [&](int piece)
    {
      std::vector<double> r;
      const int from = piece * 16 * GroupsPerPiece;
      for (int g = from; g < std::min(count, from + 16 * GroupsPerPiece); ++g)
      {
        const Group& group = this->Groups[g];
        const std::int32_t* set = this->Sets.data() + group.Set;
        double* out = slots.data() + group.Set;
        r.resize(group.SetSize);
        for (int i = 0; i < group.SetSize; ++i)
        {
          r[i] = projected[set[i]];
        }
        const double* column = this->Entries.data() + group.Columns;
        for (int m = 0; m < group.Members; ++m)
        {
          const int length = this->MemberAt[group.Member + m] + 1;
          SubtractColumn(out, column, -DotOf(column, r.data(), length), length);
          column += length;
        }
      }
    },
    monitor, { 0, 0.5, "fitting" });

  std::vector<double> weights(n);
  ParallelFor(PiecesOf(n, RowsPerPiece), this->Options.Threads,
    [&](int piece)
    {
      const std::size_t from = static_cast<std::size_t>(piece) * RowsPerPiece;
      for (std::size_t i = from; i < std::min(n, from + RowsPerPiece); ++i)
      {
        double sum = 0;
        for (std::size_t s = this->SlotBegin[i]; s < this->SlotBegin[i + 1]; ++s)
        {
          sum += slots[this->SlotsOf[s]];
        }
        weights[i] = sum;
      }
    },
    monitor, { 0.5, 1, "fitting" });
  for (std::size_t i = Simplex; i < n; ++i)
  {
    for (int a = 0; a < Simplex; ++a)
    {
      weights[a] -= this->L[i][a] * weights[i];
    }
  }
  return weights;
}

std::array<double, 4> InverseCholesky::PolynomialThrough(
  const std::array<double, 4>& atSimplex) const
{
  std::array<double, 4> p{};
  for (int k = 0; k < 4; ++k)
  {
    for (int a = 0; a < 4; ++a)
    {
      p[k] += this->Inverse[k][a] * atSimplex[a];
    }
  }
  return p;
}
}
