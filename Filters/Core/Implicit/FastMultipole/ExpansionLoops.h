// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ExpansionLoops.h
 * @brief The inner loops of the fast sum, for the width of registers that the processor has.
 *
 * All work on blocks of ExpansionLanes side by side, each lane on its own and without fused
 * operations, so no result depends on what stands beside it, nor on the processor.
 */
#ifndef recon_ExpansionLoops_h
#define recon_ExpansionLoops_h

#include "Implicit/FastMultipole/ChebyshevOperators.h"

#include <array>
#include <cstddef>
#include <vector>

namespace recon
{
using Lane = std::array<double, ExpansionLanes>;

/// Points or directions side by side.
struct LanePoints
{
  alignas(64) Lane X{};
  alignas(64) Lane Y{};
  alignas(64) Lane Z{};
};

/// Weighted points as one array a coordinate.
struct SourcePoints
{
  std::vector<double> X;
  std::vector<double> Y;
  std::vector<double> Z;
  std::vector<double> W;
};

/// A run [From, To) of source points.
struct SourceRange
{
  std::int32_t From = 0;
  std::int32_t To = 0;
};

/// y = op x, where coefficient s of lane b is at [s ExpansionLanes + b].
void Apply(const SparseOperator& op, const double* x, double* y);

/// A product of dense matrices stored by rows, c = a b; ld are the lengths of their rows.
struct DenseProduct
{
  int Rows;
  int Columns;
  int Depth;
  const double* A;
  int LdA;
  const double* B;
  int LdB;
  double* C;
  int LdC;
};
void Multiply(const DenseProduct& product);

/// moments[s] += sum over lanes of w T_s(at), at in the box's own coordinates.
void AddMoments(int order, const LanePoints& at, const Lane& w, double* moments);

/// values = sum_s local[s] T_s(at).
void ExpandValues(int order, const double* local, const LanePoints& at, Lane& values);
/// The same with derivatives by the box's own coordinates.
void ExpandGradients(
  int order, const double* local, const LanePoints& at, Lane& values, LanePoints& gradients);

/// values += sum over the ranges of w |at - source|^3.
void AddNearValues(const SourcePoints& sources, const SourceRange* ranges, std::size_t count,
  const LanePoints& at, Lane& values);
/// The same with gradients.
void AddNearGradients(const SourcePoints& sources, const SourceRange* ranges, std::size_t count,
  const LanePoints& at, Lane& values, LanePoints& gradients);
}

#endif
