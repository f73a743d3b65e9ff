// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/FastMultipole/FastKernelSum.h"

#include "Base/Parallel.h"
#include "Base/SubMonitor.h"
#include "Implicit/FastMultipole/DirectSums.h"
#include "Implicit/FastMultipole/Expansions.h"
#include "Implicit/FastMultipole/KernelSumPlan.h"

#include <algorithm>
#include <cmath>

namespace recon
{
namespace
{
/// Centres up to which a box is not split. For 30 000 centres 200 takes 0.69 of the time of 128 at
/// 1e-13, where translations cost most and the solver spends its time, and 1.2 of it at 1e-8.
constexpr std::int32_t LeafCentres = 200;
/// The first level with boxes that do not touch.
constexpr int FirstFarLevel = 2;
/// Orders are chosen by their root mean square error; of a few thousand centres the worst is this
/// much larger (fewer centres, less averaging).
constexpr double RmsOfLargest = 0.3;
/// How much more error, relative to its own kernels, a level may make than the one above: they are
/// an eighth as large. Less than 8, as weights of a contour's constraints cancel better in larger
/// boxes (measured on fitted weights: a factor of 3 to 10 in what levels contribute at one order).
constexpr double ErrorGrowth = 5;
/// Leaves, or parents, that a thread takes at a time.
constexpr int BoxesPerPiece = 32;
/// Points of one leaf that are summed in one go.
constexpr std::int32_t PointsPerRun = 256;

constexpr const char* Stage = "evaluating the fit";

/// Blocks side by side where there are enough of them to be worth a thread.
template <typename Body>
void ForBlocks(std::size_t count, int block, int threads, Monitor& monitor, const Body& body)
{
  constexpr std::size_t LeastBlocks = 4; ///< fewer are done by the calling thread
  ParallelForBlocks(count, block, threads, body, monitor, { 0, 1, Stage }, LeastBlocks);
}
}

class FastKernelSum::Implementation
{
public:
  Implementation(const std::vector<Point3>& centres, double accuracy, int threads)
    : Threads(threads),
      Given(centres),
      Cube(RootCube::Around(centres)),
      Tree(GrowTree(centres, this->Cube)),
      Self(this->Tree),
      Weights(centres.size(), 0)
  {
    this->SetAccuracy(accuracy);
    for (const Point3& p : this->Tree.Points())
    {
      this->Sources.X.push_back(p[0]);
      this->Sources.Y.push_back(p[1]);
      this->Sources.Z.push_back(p[2]);
    }
    this->Sources.W.assign(centres.size(), 0);
    this->UseOrders();
  }

  void SetAccuracy(double accuracy)
  {
    if (!(accuracy >= FinestAccuracy && accuracy <= CoarsestAccuracy))
    {
      throw Error("The accuracy of the fast sum must lie between 5e-15 and 1e-3.");
    }
    this->NextOrders.clear();
    double allowed = RmsOfLargest * accuracy;
    for (int level = 0; level <= KernelOctree::DeepestLevel; ++level)
    {
      this->NextOrders.push_back(ChebyshevOperators::OrderFor(allowed));
      allowed *= level >= FirstFarLevel ? ErrorGrowth : 1;
    }
  }

  void SetWeights(const std::vector<double>& weights, Monitor& monitor)
  {
    if (weights.size() != this->Weights.size())
    {
      throw Error("There are " + std::to_string(this->Weights.size()) + " centres but " +
        std::to_string(weights.size()) + " weights: give every centre one weight.");
    }
    this->Weights = weights;
    const std::vector<std::int32_t>& numbers = this->Tree.Numbers();
    for (std::size_t i = 0; i < numbers.size(); ++i)
    {
      this->Sources.W[i] = weights[numbers[i]];
    }
    this->UseOrders();
    // Ahead of the pieces of work that would wait for one of them to compute what is missing.
    for (int level = FirstFarLevel; level < this->Tree.Levels(); ++level)
    {
      ChebyshevOperators::Prepare(this->Orders[level], this->Threads, monitor);
    }
    this->Prepared = false;
    this->FillLeaves(monitor);
    for (int level = this->Tree.Levels() - 2; level >= FirstFarLevel; --level)
    {
      this->FillParents(level, monitor);
    }
  }

  std::vector<double> ValuesAtCentres(Monitor& monitor) const
  {
    std::vector<double> values(this->Weights.size());
    Expansions local;
    this->Expand(this->Self, local, monitor);
    const std::vector<std::int32_t>& leaves = this->Self.Leaves();
    ForBlocks(leaves.size(), BoxesPerPiece, this->Threads, monitor,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t i = from; i < to; ++i)
        {
          const OctreeBox& box = this->Tree.Boxes()[leaves[i]];
          this->SumRun(this->Self, local, { static_cast<std::int32_t>(i), box.From, box.To },
            { this->Tree.Points(), this->Tree.Numbers() }, values, nullptr);
        }
      });
    return values;
  }

  /// The local expansions of all boxes that points may lie in, once for all points.
  void Prepare(Monitor& monitor)
  {
    if (this->Prepared)
    {
      return;
    }
    if (!this->Around)
    {
      this->Around = std::make_unique<KernelSumPlan>(this->Tree, KernelSumPlan::Everywhere{});
      this->LeafNumber.assign(this->Around->Targets().Boxes().size(), -1);
      for (std::size_t i = 0; i < this->Around->Leaves().size(); ++i)
      {
        this->LeafNumber[this->Around->Leaves()[i]] = static_cast<std::int32_t>(i);
      }
    }
    this->Expand(*this->Around, this->LocalAround, monitor);
    this->Prepared = true;
  }

  void ValuesAt(const std::vector<Point3>& points, std::vector<double>& values,
    std::vector<Vector3>* gradients, Monitor& monitor)
  {
    values.assign(points.size(), 0);
    if (gradients)
    {
      gradients->assign(points.size(), Vector3{ 0, 0, 0 });
    }
    if (this->Weights.empty())
    {
      return;
    }
    this->Prepare(monitor);
    std::vector<std::int32_t> numbers;
    std::vector<std::size_t> beyond;
    const std::vector<Run> runs = this->RunsOf(points, numbers, beyond);
    std::vector<Point3> sorted;
    sorted.reserve(numbers.size());
    for (const std::int32_t number : numbers)
    {
      sorted.push_back(this->Cube.ToUnit(points[number]));
    }
    ForBlocks(runs.size(), BoxesPerPiece, this->Threads, monitor,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t i = from; i < to; ++i)
        {
          this->SumRun(
            *this->Around, this->LocalAround, runs[i], { sorted, numbers }, values, gradients);
        }
      });
    this->SumBeyond(points, beyond, values, gradients, monitor);
  }

  double SampledError(const std::vector<double>& values, int samples) const
  {
    const std::size_t n = this->Weights.size();
    const std::size_t step = std::max<std::size_t>(1, n / std::max(1, samples));
    std::vector<std::size_t> which;
    std::vector<Point3> points;
    // Along the curve of the tree, so that all parts of space are met.
    for (std::size_t i = step / 2; i < n; i += step)
    {
      which.push_back(this->Tree.Numbers()[i]);
      points.push_back(this->Given[which.back()]);
    }
    const std::vector<double> exact = this->Exact(points);
    double largest = 0;
    for (std::size_t k = 0; k < which.size(); ++k)
    {
      const double error = std::abs(values[which[k]] - exact[k]);
      largest = !(error <= largest) ? error : largest;
    }
    return largest;
  }

  std::size_t Size() const { return this->Weights.size(); }

private:
  static KernelOctree GrowTree(const std::vector<Point3>& centres, const RootCube& cube)
  {
    KernelOctree tree(centres, cube);
    while (
      tree.SplitLastLevel([&tree](int box) { return tree.Boxes()[box].Count() > LeafCentres; }))
    {
    }
    return tree;
  }

  void UseOrders()
  {
    this->Orders = this->NextOrders;
    this->Moments.Reset(this->Tree, this->Orders);
  }

  void FillLeaves(Monitor& monitor)
  {
    ForBlocks(this->Self.Leaves().size(), BoxesPerPiece, this->Threads, monitor,
      [&](std::size_t from, std::size_t to)
      {
        for (std::size_t i = from; i < to; ++i)
        {
          this->FillLeaf(this->Self.Leaves()[i]);
        }
      });
  }

  void FillLeaf(std::int32_t leaf)
  {
    const OctreeBox& box = this->Tree.Boxes()[leaf];
    for (std::int32_t from = box.From; from < box.To; from += ExpansionLanes)
    {
      const std::int32_t to = std::min(box.To, from + ExpansionLanes);
      Lane w{};
      std::copy(this->Sources.W.begin() + from, this->Sources.W.begin() + to, w.begin());
      AddMoments(this->Orders[box.Level], LocalBlock(this->Tree.Points(), box, from, to), w,
        this->Moments.Of(leaf));
    }
  }

  void FillParents(int level, Monitor& monitor)
  {
    const int begin = this->Tree.LevelBegin(level);
    const int childOrder = this->Orders[level + 1];
    const int order = this->Orders[level];
    const SparseOperator& op = UpwardOperator(childOrder, order);
    ForBlocks(this->Tree.LevelEnd(level) - begin, BoxesPerPiece, this->Threads, monitor,
      [&](std::size_t from, std::size_t to)
      {
        Translator up(op, childOrder, order);
        for (std::size_t i = from; i < to; ++i)
        {
          const auto parent = static_cast<std::int32_t>(begin + i);
          const OctreeBox& box = this->Tree.Boxes()[parent];
          for (std::int32_t c = 0; c < box.Children; ++c)
          {
            const std::int32_t child = box.FirstChild + c;
            up.Add(this->Moments.Of(child), this->Moments.Of(parent),
              ChebyshevOperators::Reflection(SideOf(this->Tree.Boxes()[child])));
            if (up.Full())
            {
              up.Flush(1);
            }
          }
        }
        up.Flush(1);
      });
  }

  /// Points [From, To) of a sorted list that lie in one leaf of a plan.
  struct Run
  {
    std::int32_t Leaf;
    std::int32_t From;
    std::int32_t To;
  };

  /// Places in the unit cube, and where their results go.
  struct SortedPlaces
  {
    const std::vector<Point3>& Places;
    const std::vector<std::int32_t>& Numbers;
  };

  /// Sorts points by the leaf around them; those beyond the cube are listed apart.
  std::vector<Run> RunsOf(const std::vector<Point3>& points, std::vector<std::int32_t>& numbers,
    std::vector<std::size_t>& beyond) const
  {
    std::vector<std::int32_t> leafOf(points.size(), -1);
    std::vector<std::int32_t> next(this->Around->Leaves().size() + 1, 0);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (!this->Cube.Contains(points[i]))
      {
        beyond.push_back(i);
        continue;
      }
      const KernelOctree& tree = this->Around->Targets();
      leafOf[i] = this->LeafNumber[tree.LeafAround(this->Cube.ToUnit(points[i]))];
      ++next[leafOf[i] + 1];
    }
    std::vector<Run> runs;
    for (std::size_t leaf = 0; leaf + 1 < next.size(); ++leaf)
    {
      next[leaf + 1] += next[leaf];
      for (std::int32_t from = next[leaf]; from < next[leaf + 1]; from += PointsPerRun)
      {
        runs.push_back(
          { static_cast<std::int32_t>(leaf), from, std::min(next[leaf + 1], from + PointsPerRun) });
      }
    }
    numbers.resize(points.size() - beyond.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      if (leafOf[i] >= 0)
      {
        numbers[next[leafOf[i]]++] = static_cast<std::int32_t>(i);
      }
    }
    return runs;
  }

  /// The local expansions of all boxes of a plan's targets.
  void Expand(const KernelSumPlan& plan, Expansions& local, Monitor& monitor) const
  {
    local.Reset(plan.Targets(), this->Orders);
    this->AddFar(plan, local, monitor);
    for (int level = FirstFarLevel + 1; level < plan.Targets().Levels(); ++level)
    {
      this->PassDown(plan, level, local, monitor);
    }
  }

  void AddFar(const KernelSumPlan& plan, Expansions& local, Monitor& monitor) const
  {
    ForBlocks(plan.Chunks().size(), 1, this->Threads, monitor,
      [&](std::size_t c, std::size_t)
      {
        const FarChunk& chunk = plan.Chunks()[c];
        const int order = this->Orders[chunk.Level];
        const double h = KernelOctree::HalfWidthOf(chunk.Level);
        const ChebyshevOperators& operators = ChebyshevOperators::OfOrder(order);
        for (int k = 0; k < ChebyshevOperators::Classes; ++k)
        {
          Translator across(operators.FarField(k), order, order);
          for (std::int32_t i = chunk.Start[k]; i < chunk.Start[k + 1]; ++i)
          {
            const FarPair& pair = plan.Pairs()[i];
            across.Add(this->Moments.Of(pair.Source), local.Of(pair.Target), pair.Turn);
            if (across.Full())
            {
              across.Flush(h * h * h);
            }
          }
          across.Flush(h * h * h);
        }
      });
  }

  void PassDown(const KernelSumPlan& plan, int level, Expansions& local, Monitor& monitor) const
  {
    const KernelOctree& targets = plan.Targets();
    const int begin = targets.LevelBegin(level);
    const int parentOrder = this->Orders[level - 1];
    const int order = this->Orders[level];
    const SparseOperator& op = DownwardOperator(order, parentOrder);
    ForBlocks(targets.LevelEnd(level) - begin, BoxesPerPiece, this->Threads, monitor,
      [&](std::size_t from, std::size_t to)
      {
        Translator down(op, parentOrder, order);
        for (std::size_t i = from; i < to; ++i)
        {
          const auto child = static_cast<std::int32_t>(begin + i);
          const OctreeBox& box = targets.Boxes()[child];
          if (!plan.HasFar(box.Parent))
          {
            continue;
          }
          down.Add(
            local.Of(box.Parent), local.Of(child), ChebyshevOperators::Reflection(SideOf(box)));
          if (down.Full())
          {
            down.Flush(1);
          }
        }
        down.Flush(1);
      });
  }

  void SumRun(const KernelSumPlan& plan, const Expansions& local, const Run& run,
    const SortedPlaces& places, std::vector<double>& values, std::vector<Vector3>* gradients) const
  {
    const std::int32_t leaf = plan.Leaves()[run.Leaf];
    const OctreeBox& box = plan.Targets().Boxes()[leaf];
    const SourceRange* near = plan.NearBegin(run.Leaf);
    const std::size_t count = plan.NearCount(run.Leaf);
    for (std::int32_t from = run.From; from < run.To; from += ExpansionLanes)
    {
      const std::int32_t to = std::min(run.To, from + ExpansionLanes);
      Lane value{};
      LanePoints gradient;
      if (plan.HasFar(leaf))
      {
        this->Expand(box, local.Of(leaf), LocalBlock(places.Places, box, from, to), value,
          gradients ? &gradient : nullptr);
      }
      const LanePoints at = UnitBlock(places.Places, from, to);
      gradients ? AddNearGradients(this->Sources, near, count, at, value, gradient)
                : AddNearValues(this->Sources, near, count, at, value);
      this->Store(places.Numbers.data() + from, to - from, value, gradient, values, gradients);
    }
  }

  void Expand(const OctreeBox& box, const double* local, const LanePoints& at, Lane& value,
    LanePoints* gradient) const
  {
    const int order = this->Orders[box.Level];
    if (!gradient)
    {
      ExpandValues(order, local, at, value);
      return;
    }
    ExpandGradients(order, local, at, value, *gradient);
    const double scale = 1 / KernelOctree::HalfWidthOf(box.Level);
    for (int b = 0; b < ExpansionLanes; ++b)
    {
      gradient->X[b] *= scale;
      gradient->Y[b] *= scale;
      gradient->Z[b] *= scale;
    }
  }

  /// Back from the unit cube: s has the third power of its size, its gradient the second.
  void Store(const std::int32_t* numbers, std::int32_t count, const Lane& value,
    const LanePoints& gradient, std::vector<double>& values, std::vector<Vector3>* gradients) const
  {
    const double size2 = this->Cube.Size * this->Cube.Size;
    for (std::int32_t b = 0; b < count; ++b)
    {
      values[numbers[b]] = size2 * this->Cube.Size * value[b];
      if (gradients)
      {
        (*gradients)[numbers[b]] = { size2 * gradient.X[b], size2 * gradient.Y[b],
          size2 * gradient.Z[b] };
      }
    }
  }

  void SumBeyond(const std::vector<Point3>& points, const std::vector<std::size_t>& which,
    std::vector<double>& values, std::vector<Vector3>* gradients, Monitor& monitor) const
  {
    std::vector<Point3> places;
    for (const std::size_t i : which)
    {
      places.push_back(points[i]);
    }
    const std::vector<double> sums =
      SumAllKernels({}, this->Given, this->Weights, places, this->Threads, monitor);
    for (std::size_t k = 0; k < which.size(); ++k)
    {
      values[which[k]] = sums[k];
    }
    if (!gradients)
    {
      return;
    }
    const std::vector<Vector3> slopes =
      SumAllKernelGradients({}, this->Given, this->Weights, places, this->Threads, monitor);
    for (std::size_t k = 0; k < which.size(); ++k)
    {
      (*gradients)[which[k]] = slopes[k];
    }
  }

  std::vector<double> Exact(const std::vector<Point3>& points) const
  {
    Monitor silent;
    return SumAllKernels({}, this->Given, this->Weights, points, this->Threads, silent);
  }

  int Threads;
  std::vector<Point3> Given;
  RootCube Cube;
  KernelOctree Tree;
  KernelSumPlan Self;
  std::vector<double> Weights; ///< in the order given
  SourcePoints Sources;        ///< in the order of the tree
  std::vector<int> NextOrders;
  std::vector<int> Orders; ///< of each level
  Expansions Moments;
  std::unique_ptr<KernelSumPlan> Around; ///< for points anywhere in the cube; made on first use
  std::vector<std::int32_t> LeafNumber;  ///< of each of its boxes
  Expansions LocalAround;
  bool Prepared = false;
};

FastKernelSum::FastKernelSum(const std::vector<Point3>& centres, double accuracy, int threads)
  : Inside(std::make_unique<Implementation>(centres, accuracy, threads))
{
}

FastKernelSum::~FastKernelSum() = default;
FastKernelSum::FastKernelSum(FastKernelSum&&) noexcept = default;
FastKernelSum& FastKernelSum::operator=(FastKernelSum&&) noexcept = default;

std::size_t FastKernelSum::Size() const
{
  return this->Inside->Size();
}

void FastKernelSum::SetAccuracy(double accuracy)
{
  this->Inside->SetAccuracy(accuracy);
}

void FastKernelSum::SetWeights(const std::vector<double>& weights, Monitor& monitor)
{
  this->Inside->SetWeights(weights, monitor);
}

std::vector<double> FastKernelSum::ValuesAtCentres(Monitor& monitor)
{
  return this->Inside->ValuesAtCentres(monitor);
}

std::vector<double> FastKernelSum::Values(const std::vector<Point3>& points, Monitor& monitor)
{
  std::vector<double> values;
  this->Inside->ValuesAt(points, values, nullptr, monitor);
  return values;
}

void FastKernelSum::ValuesAndGradients(const std::vector<Point3>& points,
  std::vector<double>& values, std::vector<Vector3>& gradients, Monitor& monitor)
{
  this->Inside->ValuesAt(points, values, &gradients, monitor);
}

double FastKernelSum::SampledError(const std::vector<double>& valuesAtCentres, int samples) const
{
  return this->Inside->SampledError(valuesAtCentres, samples);
}
}
