// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file Expansions.h
 * @brief The Chebyshev series of a tree's boxes, and the translations between them
 * (ChebyshevOperators.h), several side by side.
 */
#ifndef recon_Expansions_h
#define recon_Expansions_h

#include "Implicit/FastMultipole/ExpansionLoops.h"
#include "Implicit/FastMultipole/KernelOctree.h"

#include <array>
#include <vector>

namespace recon
{
/// Expansions of all boxes of a tree, one after the other; their length goes with the level.
class Expansions
{
public:
  void Reset(const KernelOctree& tree, const std::vector<int>& orderOfLevel)
  {
    this->Start.assign(1, 0);
    for (const OctreeBox& box : tree.Boxes())
    {
      this->Start.push_back(this->Start.back() + CoefficientCount(orderOfLevel[box.Level]));
    }
    this->Values.assign(this->Start.back(), 0);
  }
  double* Of(std::int32_t box) { return this->Values.data() + this->Start[box]; }
  const double* Of(std::int32_t box) const { return this->Values.data() + this->Start[box]; }

private:
  std::vector<std::size_t> Start;
  std::vector<double> Values;
};

/// Up to ExpansionLanes translations by one operator, side by side.
class Translator
{
public:
  Translator(const SparseOperator& op, int fromOrder, int toOrder)
    : Op(op),
      From(ChebyshevOperators::OfOrder(fromOrder)),
      To(ChebyshevOperators::OfOrder(toOrder)),
      X(static_cast<std::size_t>(CoefficientCount(fromOrder)) * ExpansionLanes),
      Y(static_cast<std::size_t>(CoefficientCount(toOrder)) * ExpansionLanes)
  {
  }

  void Add(const double* from, double* to, int turn)
  {
    const Orientation& turned = this->From.Turned(turn);
    const std::size_t count = turned.Source.size();
    double* x = this->X.data() + this->Count;
    for (std::size_t s = 0; s < count; ++s)
    {
      x[s * ExpansionLanes] = turned.Sign[s] * from[turned.Source[s]];
    }
    this->Targets[this->Count] = to;
    this->TargetTurns[this->Count] = turn;
    ++this->Count;
  }

  bool Full() const { return this->Count == ExpansionLanes; }

  /// Adds scale times the results to their targets, in the order in which they came.
  void Flush(double scale)
  {
    if (this->Count == 0)
    {
      return;
    }
    Apply(this->Op, this->X.data(), this->Y.data());
    for (int b = 0; b < this->Count; ++b)
    {
      const Orientation& turned = this->To.Turned(this->TargetTurns[b]);
      const std::size_t count = turned.Source.size();
      const double* y = this->Y.data() + b;
      double* to = this->Targets[b];
      for (std::size_t s = 0; s < count; ++s)
      {
        to[turned.Source[s]] += scale * turned.Sign[s] * y[s * ExpansionLanes];
      }
    }
    this->Count = 0;
  }

private:
  const SparseOperator& Op;
  const ChebyshevOperators& From;
  const ChebyshevOperators& To;
  std::vector<double> X;
  std::vector<double> Y;
  std::array<double*, ExpansionLanes> Targets{};
  std::array<int, ExpansionLanes> TargetTurns{};
  int Count = 0;
};

/// The axes on whose negative side of its parent a box lies.
int SideOf(const OctreeBox& box);

/// Some points of a box side by side, in its own coordinates. The last one fills a short block.
LanePoints LocalBlock(
  const std::vector<Point3>& points, const OctreeBox& box, std::int32_t from, std::int32_t to);

LanePoints UnitBlock(const std::vector<Point3>& points, std::int32_t from, std::int32_t to);
}

#endif
