// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/ChebyshevOperators.h"

#include "Base/Angles.h"
#include "Base/Parallel.h"
#include "Implicit/FastMultipole/ExpansionLoops.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>

namespace recon
{
namespace
{
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Degrees = std::array<int, 3>;

/// An order's operators are part of those of the next one of these, which alone are computed: high
/// ones take long.
constexpr std::array<int, 3> ComputedOrders{ 10, LargestQuickOrder, LargestOrder };
/// Entries below this part of the truncation's error are left out; a tenth would take 1.6 times the
/// time for an error that is half as large at most.
constexpr double NegligiblePart = 0.5;

/// The degrees of all coefficients, in the order in which they are stored: k runs fastest.
std::vector<Degrees> DegreesOf(int order)
{
  std::vector<Degrees> all;
  for (int i = 0; i <= order; ++i)
  {
    for (int j = 0; i + j <= order; ++j)
    {
      for (int k = 0; i + j + k <= order; ++k)
      {
        all.push_back({ i, j, k });
      }
    }
  }
  return all;
}

/// Where coefficient (i, j, k) is stored.
class Positions
{
public:
  explicit Positions(int order) : Side(order + 1), At(Side * Side * Side, -1)
  {
    int next = 0;
    for (const Degrees& d : DegreesOf(order))
    {
      this->At[(d[0] * this->Side + d[1]) * this->Side + d[2]] = next++;
    }
  }
  int Of(const Degrees& d) const
  {
    return this->At[(d[0] * this->Side + d[1]) * this->Side + d[2]];
  }

private:
  int Side;
  std::vector<int> At;
};

double Node(int a, int count)
{
  return std::cos(Pi * (a + 0.5) / count);
}

double ChebyshevAt(int degree, double x)
{
  return std::cos(degree * std::acos(std::min(1.0, std::max(-1.0, x))));
}

/// (rows) x (nodes): from values at Chebyshev's nodes to the first coefficients.
Matrix CoefficientsFromNodes(int rows, int nodes)
{
  Matrix d(rows, nodes);
  for (int k = 0; k < rows; ++k)
  {
    for (int a = 0; a < nodes; ++a)
    {
      d(k, a) = (k == 0 ? 1.0 : 2.0) / nodes * std::cos(k * Pi * (a + 0.5) / nodes);
    }
  }
  return d;
}

/// g[i (p + 1) + j](l): T_l((x - y) / 2) = sum g T_i(x) T_j(y), l < count.
Matrix DifferenceTable(int order, int count)
{
  const int side = order + 1;
  const Matrix toCoefficients = CoefficientsFromNodes(side, count);
  Matrix table(side * side, count);
  for (int l = 0; l < count; ++l)
  {
    Matrix values(count, count);
    for (int a = 0; a < count; ++a)
    {
      for (int b = 0; b < count; ++b)
      {
        values(a, b) = ChebyshevAt(l, 0.5 * (Node(a, count) - Node(b, count)));
      }
    }
    const Matrix g = toCoefficients * values * toCoefficients.transpose();
    for (int i = 0; i < side; ++i)
    {
      for (int j = 0; j < side; ++j)
      {
        table(i * side + j, l) = g(i, j);
      }
    }
  }
  return table;
}

Matrix Product(const Eigen::Ref<const Matrix>& a, const Eigen::Ref<const Matrix>& b)
{
  Matrix c(a.rows(), b.cols());
  Multiply({ static_cast<int>(a.rows()), static_cast<int>(b.cols()), static_cast<int>(a.cols()),
    a.data(), static_cast<int>(a.outerStride()), b.data(), static_cast<int>(b.outerStride()),
    c.data(), static_cast<int>(c.cols()) });
  return c;
}

/// Coefficients of |2 o + u|^3 in products of T_l(u / 2), u in [-2, 2]^3: (l0) x (l1 count + l2).
Matrix KernelSeries(const Degrees& offset, int count)
{
  Matrix f(count, count * count);
  for (int a = 0; a < count; ++a)
  {
    for (int b = 0; b < count; ++b)
    {
      for (int c = 0; c < count; ++c)
      {
        const double x = 2 * (offset[0] + Node(a, count));
        const double y = 2 * (offset[1] + Node(b, count));
        const double z = 2 * (offset[2] + Node(c, count));
        const double r2 = x * x + y * y + z * z;
        f(a, b * count + c) = r2 * std::sqrt(r2);
      }
    }
  }
  // One axis after the other; each turn moves the transformed axis to the end.
  const Matrix toCoefficients = CoefficientsFromNodes(count, count);
  for (int axis = 0; axis < 3; ++axis)
  {
    const Matrix turned = Product(toCoefficients, f).transpose();
    f = Eigen::Map<const Matrix>(turned.data(), count, count * count);
  }
  return f;
}

/// The rows (i, j) of the table with i <= most[0], j <= most[1].
Matrix RowsUpTo(const Matrix& table, int side, const std::array<int, 2>& most)
{
  Matrix rows((most[0] + 1) * (most[1] + 1), table.cols());
  for (int i = 0; i <= most[0]; ++i)
  {
    for (int j = 0; j <= most[1]; ++j)
    {
      rows.row(i * (most[1] + 1) + j) = table.row(i * side + j);
    }
  }
  return rows;
}

/// Degrees i of a target and j <= i of a source on the first axis.
struct DegreePair
{
  int Target;
  int Source;
};

std::vector<DegreePair> LowerPairs(int order)
{
  std::vector<DegreePair> pairs;
  for (int i = 0; i <= order; ++i)
  {
    for (int j = 0; j <= i; ++j)
    {
      pairs.push_back({ i, j });
    }
  }
  return pairs;
}

/// The rows of all pairs.
Matrix RowsOf(const Matrix& table, int side, const std::vector<DegreePair>& pairs)
{
  Matrix rows(static_cast<Eigen::Index>(pairs.size()), table.cols());
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    rows.row(static_cast<Eigen::Index>(p)) = table.row(pairs[p].Target * side + pairs[p].Source);
  }
  return rows;
}

/**
 * The kernel between two boxes as a full matrix, targets by sources. It depends on x - y alone, so
 * that target and source change places when both are reflected: T_i(-x) = (-1)^i T_i(x). Half of
 * the pairs of degrees on the first axis tell the others.
 */
Matrix FarFieldMatrix(int order, const Degrees& offset, const Matrix& table)
{
  const int side = order + 1;
  const int count = static_cast<int>(table.cols());
  const Positions positions(order);
  Matrix full = Matrix::Zero(CoefficientCount(order), CoefficientCount(order));
  const std::vector<DegreePair> pairs = LowerPairs(order);
  const Matrix first = Product(RowsOf(table, side, pairs), KernelSeries(offset, count));
  for (std::size_t p = 0; p < pairs.size(); ++p)
  {
    const int i0 = pairs[p].Target;
    const int j0 = pairs[p].Source;
    const Eigen::Map<const Matrix> slice(
      first.row(static_cast<Eigen::Index>(p)).data(), count, count);
    const int di = order - i0;
    const int dj = order - j0;
    const Matrix rows = RowsUpTo(table, side, { di, dj });
    const Matrix left = Product(rows, slice);
    const Matrix right = rows.transpose();
    Matrix block(dj + 1, (di + 1) * (dj + 1));
    for (int i1 = 0; i1 <= di; ++i1)
    {
      Multiply({ dj + 1, (di - i1 + 1) * (dj + 1), count, left.row(i1 * (dj + 1)).data(), count,
        right.data(), static_cast<int>(right.cols()), block.data(),
        static_cast<int>(block.cols()) });
      for (int j1 = 0; j1 <= dj; ++j1)
      {
        for (int i2 = 0; i1 + i2 <= di; ++i2)
        {
          const int target = positions.Of({ i0, i1, i2 });
          for (int j2 = 0; j1 + j2 <= dj; ++j2)
          {
            const int source = positions.Of({ j0, j1, j2 });
            const double k = block(j1, i2 * (dj + 1) + j2);
            full(target, source) = k;
            if (i0 != j0)
            {
              const int odd = (i0 + i1 + i2 + j0 + j1 + j2) % 2;
              full(source, target) = odd == 0 ? k : -k;
            }
          }
        }
      }
    }
  }
  return full;
}

SparseOperator Compress(const Matrix& full, double negligible)
{
  SparseOperator op;
  for (Eigen::Index i = 0; i < full.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < full.cols(); ++j)
    {
      if (std::abs(full(i, j)) > negligible)
      {
        op.Column.push_back(static_cast<std::int32_t>(j));
        op.Value.push_back(full(i, j));
      }
    }
    op.RowStart.push_back(static_cast<std::int32_t>(op.Column.size()));
  }
  return op;
}

const std::array<Degrees, ChebyshevOperators::Classes>& CanonicalOffsets()
{
  static const std::array<Degrees, ChebyshevOperators::Classes> offsets = []
  {
    std::array<Degrees, ChebyshevOperators::Classes> all{};
    int next = 0;
    for (int a = 2; a <= 3; ++a)
    {
      for (int b = 0; b <= a; ++b)
      {
        for (int c = 0; c <= b; ++c)
        {
          all[next++] = { a, b, c };
        }
      }
    }
    return all;
  }();
  return offsets;
}

constexpr std::array<Degrees, 6> Permutations{ { { 0, 1, 2 }, { 0, 2, 1 }, { 1, 0, 2 }, { 1, 2, 0 },
  { 2, 0, 1 }, { 2, 1, 0 } } };

/// Canonical axis a is the box's axis permutation[a], reflected where that axis' bit is set.
Orientation MakeOrientation(int order, const Degrees& permutation, int reflected)
{
  const Positions positions(order);
  Orientation turn;
  for (const Degrees& d : DegreesOf(order))
  {
    Degrees own{};
    int odd = 0;
    for (int a = 0; a < 3; ++a)
    {
      own[permutation[a]] = d[a];
      odd += ((reflected >> permutation[a]) & 1) * d[a];
    }
    turn.Source.push_back(positions.Of(own));
    turn.Sign.push_back(odd % 2 == 0 ? 1 : -1);
  }
  return turn;
}

/// a(i', i): T_i((t + 1) / 2) = sum a T_i'(t).
Matrix HalfIntervalTable(int order)
{
  const int count = order + 1;
  const Matrix toCoefficients = CoefficientsFromNodes(count, count);
  Matrix values(count, count);
  for (int a = 0; a < count; ++a)
  {
    for (int i = 0; i < count; ++i)
    {
      values(a, i) = ChebyshevAt(i, 0.5 * (Node(a, count) + 1));
    }
  }
  return toCoefficients * values;
}

Matrix UpwardMatrix(int childOrder, int parentOrder)
{
  const Matrix table = HalfIntervalTable(std::max(childOrder, parentOrder));
  const std::vector<Degrees> parents = DegreesOf(parentOrder);
  const std::vector<Degrees> children = DegreesOf(childOrder);
  Matrix full = Matrix::Zero(CoefficientCount(parentOrder), CoefficientCount(childOrder));
  for (std::size_t s = 0; s < parents.size(); ++s)
  {
    for (std::size_t c = 0; c < children.size(); ++c)
    {
      double product = 1;
      for (int a = 0; a < 3; ++a)
      {
        product *= children[c][a] <= parents[s][a] ? table(children[c][a], parents[s][a]) : 0;
      }
      full(static_cast<Eigen::Index>(s), static_cast<Eigen::Index>(c)) = product;
    }
  }
  return full;
}

/// Built on first use, kept for the process.
template <typename Value, std::size_t Count, typename Make>
const Value& Kept(std::array<std::unique_ptr<const Value>, Count>& all, std::mutex& mutex,
  std::size_t index, const Make& make)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (!all[index])
  {
    all[index] = make();
  }
  return *all[index];
}

double Negligible(int order, int offsetClass)
{
  const Degrees& o = CanonicalOffsets()[offsetClass];
  const double distance =
    2 * std::sqrt(static_cast<double>(o[0] * o[0] + o[1] * o[1] + o[2] * o[2]));
  return NegligiblePart * ChebyshevOperators::RelativeError(order) * distance * distance * distance;
}

/// The rows and columns that have a new name (others: -1), in their order.
SparseOperator Part(const SparseOperator& whole, const std::vector<int>& renamed, double negligible)
{
  SparseOperator part;
  for (int i = 0; i < whole.Rows(); ++i)
  {
    if (renamed[i] < 0)
    {
      continue;
    }
    for (std::int32_t e = whole.RowStart[i]; e < whole.RowStart[i + 1]; ++e)
    {
      const int column = renamed[whole.Column[e]];
      if (column >= 0 && std::abs(whole.Value[e]) > negligible)
      {
        part.Column.push_back(column);
        part.Value.push_back(whole.Value[e]);
      }
    }
    part.RowStart.push_back(static_cast<std::int32_t>(part.Column.size()));
  }
  return part;
}

constexpr std::size_t OrderPairs = (LargestOrder + 1) * (LargestOrder + 1); ///< pairs of orders
}

ChebyshevOperators::ChebyshevOperators(int order) : P(order)
{
  for (int t = 0; t < Turns; ++t)
  {
    this->Turned48[t] = MakeOrientation(order, Permutations[t / 8], t % 8);
  }
}

void ChebyshevOperators::Compute(int threads, Monitor& monitor)
{
  // |2 o + u|^3 is less smooth in u than in x and y; what a few more terms add is below 1e-13.
  const Matrix table = DifferenceTable(this->P, 2 * this->P + 10);
  ParallelFor(Classes, threads,
    [&](int c)
    {
      this->Far[c] =
        Compress(FarFieldMatrix(this->P, CanonicalOffsets()[c], table), Negligible(this->P, c));
    },
    monitor, { 0, 1, "preparing the evaluation" });
}

void ChebyshevOperators::TakeFrom(const ChebyshevOperators& higher)
{
  const Positions own(this->P);
  std::vector<int> renamed;
  for (const Degrees& d : DegreesOf(higher.P))
  {
    renamed.push_back(d[0] + d[1] + d[2] <= this->P ? own.Of(d) : -1);
  }
  for (int c = 0; c < Classes; ++c)
  {
    this->Far[c] = Part(higher.Far[c], renamed, Negligible(this->P, c));
  }
}

const ChebyshevOperators& ChebyshevOperators::Shared(int order, int threads, Monitor& monitor)
{
  static std::mutex mutex;
  static std::array<std::unique_ptr<ChebyshevOperators>, LargestOrder + 1> all;
  const std::lock_guard<std::mutex> lock(mutex);
  // Always from the same series, so that no bit depends on what was asked for before.
  const int computed = *std::lower_bound(ComputedOrders.begin(), ComputedOrders.end(), order);
  for (const int wanted : { computed, order })
  {
    if (!all[wanted])
    {
      std::unique_ptr<ChebyshevOperators> made(new ChebyshevOperators(wanted));
      wanted == computed ? made->Compute(threads, monitor) : made->TakeFrom(*all[computed]);
      all[wanted] = std::move(made);
    }
  }
  return *all[order];
}

const ChebyshevOperators& ChebyshevOperators::OfOrder(int order)
{
  Monitor silent;
  return ChebyshevOperators::Shared(order, 1, silent);
}

void ChebyshevOperators::Prepare(int order, int threads, Monitor& monitor)
{
  ChebyshevOperators::Shared(order, threads, monitor);
}

double ChebyshevOperators::RelativeError(int order)
{
  // Measured for p = 4..10: 3.1e-5 3.7e-6 5.8e-7 1.1e-7 2.2e-8 5.0e-9 1.3e-9; then more slowly.
  const int steep = std::min(order, 10);
  const int quick = std::min(order, LargestQuickOrder);
  return 3.1e-5 * std::pow(0.186, steep - 4) * std::pow(0.22, quick - steep) *
    std::pow(0.31, order - quick);
}

int ChebyshevOperators::OrderFor(double relativeError)
{
  int order = LeastOrder;
  while (order < LargestOrder && RelativeError(order) > relativeError)
  {
    ++order;
  }
  return order;
}

OffsetClass ChebyshevOperators::Classify(const std::array<int, 3>& offset)
{
  Degrees size{};
  int reflected = 0;
  for (int a = 0; a < 3; ++a)
  {
    size[a] = std::abs(offset[a]);
    reflected |= offset[a] < 0 ? 1 << a : 0;
  }
  for (std::size_t p = 0; p < Permutations.size(); ++p)
  {
    const Degrees& order = Permutations[p];
    const Degrees sorted{ size[order[0]], size[order[1]], size[order[2]] };
    const auto found = std::find(CanonicalOffsets().begin(), CanonicalOffsets().end(), sorted);
    if (found != CanonicalOffsets().end())
    {
      return { static_cast<int>(found - CanonicalOffsets().begin()),
        static_cast<int>(8 * p) + reflected };
    }
  }
  return {};
}

int ChebyshevOperators::Reflection(int bits)
{
  return bits;
}

const SparseOperator& UpwardOperator(int childOrder, int parentOrder)
{
  static std::mutex mutex;
  static std::array<std::unique_ptr<const SparseOperator>, OrderPairs> all;
  return Kept(all, mutex, childOrder * (LargestOrder + 1) + parentOrder,
    [&]
    {
      return std::make_unique<const SparseOperator>(
        Compress(UpwardMatrix(childOrder, parentOrder), 0));
    });
}

const SparseOperator& DownwardOperator(int childOrder, int parentOrder)
{
  static std::mutex mutex;
  static std::array<std::unique_ptr<const SparseOperator>, OrderPairs> all;
  return Kept(all, mutex, childOrder * (LargestOrder + 1) + parentOrder,
    [&]
    {
      return std::make_unique<const SparseOperator>(
        Compress(UpwardMatrix(childOrder, parentOrder).transpose(), 0));
    });
}
}
