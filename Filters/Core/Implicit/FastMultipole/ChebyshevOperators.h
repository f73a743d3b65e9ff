// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ChebyshevOperators.h
 * @brief How |x - y|^3 acts between two boxes of one size, as sparse matrices between Chebyshev
 * expansions.
 *
 * Notation:
 *   p      order of an expansion: products T_i(x) T_j(y) T_k(z) with i + j + k <= p
 *   xi     coordinates of a box, -1..1 from face to face
 *   o      offset of the target's box from the source's, in boxes; -3..3 an axis, at least one
 *          beyond 1 (what Greengard and Rokhlin call the interaction list)
 *   m, l   moments sum_j w_j T(xi_j) of a source box, coefficients of the local expansion
 */
#ifndef recon_ChebyshevOperators_h
#define recon_ChebyshevOperators_h

#include "Base/Monitor.h"

#include <array>
#include <cstdint>
#include <vector>

namespace recon
{
/// Expansions of one order side by side in the inner loops: one interaction a lane.
constexpr int ExpansionLanes = 16;
constexpr int LeastOrder = 3;
constexpr int LargestOrder = 20;
/// Operators of higher orders take 2.5 CPU s to compute, once in a process, and 140 MB.
constexpr int LargestQuickOrder = 17;

/// Products T_i T_j T_k with i + j + k <= order.
constexpr int CoefficientCount(int order)
{
  return (order + 1) * (order + 2) * (order + 3) / 6;
}

/// Compressed rows.
struct SparseOperator
{
  std::vector<std::int32_t> RowStart{ 0 };
  std::vector<std::int32_t> Column;
  std::vector<double> Value;

  int Rows() const { return static_cast<int>(this->RowStart.size()) - 1; }
};

/**
 * What a reflection and permutation of the axes does to coefficients: the canonical one s is
 * Sign[s] times the box's own Source[s].
 */
struct Orientation
{
  std::vector<std::int32_t> Source;
  std::vector<double> Sign;
};

/// An offset as one of the canonical ones (3 >= o0 >= o1 >= o2 >= 0) and its orientation.
struct OffsetClass
{
  int Class = -1; ///< -1: boxes that touch, which the expansions are not for
  int Turn = 0;   ///< index of the orientation
};

/**
 * @class ChebyshevOperators
 * @brief Everything that expansions of one order need; built once in a process, then shared.
 *
 * The kernel is homogeneous (degree 3), so one set serves boxes of all sizes; the 316 offsets are
 * 16 classes up to reflections and permutations. A coefficient of the kernel falls off so quickly
 * with i + j + k on either side that entries below half the truncation's own error are left
 * out: at p = 7 most of the 14 400 go.
 */
class ChebyshevOperators
{
public:
  static constexpr int Classes = 16; ///< offsets of cells that are not one turned over
  static constexpr int Turns = 48;   ///< of the cube, mirrored ones included

  /// @param order LeastOrder..LargestOrder
  static const ChebyshevOperators& OfOrder(int order);
  /// Has OfOrder's ready before it is asked, by several threads. @throws Aborted, none the worse.
  static void Prepare(int order, int threads, Monitor& monitor);

  int Order() const { return this->P; }
  /// l += (moments) for a canonical offset and boxes of half-width 1; times h^3 otherwise.
  const SparseOperator& FarField(int offsetClass) const { return this->Far[offsetClass]; }
  const Orientation& Turned(int turn) const { return this->Turned48[turn]; }

  /// Root mean square of the truncation, relative to the kernel between the boxes' centres.
  static double RelativeError(int order);
  /// The lowest order whose error is at most that.
  static int OrderFor(double relativeError);

  static OffsetClass Classify(const std::array<int, 3>& offset);
  /// The orientation that reflects the axes whose bit is set.
  static int Reflection(int bits);

private:
  static const ChebyshevOperators& Shared(int order, int threads, Monitor& monitor);

  explicit ChebyshevOperators(int order);
  void Compute(int threads, Monitor& monitor);
  /// The series' coefficients do not depend on where it is cut off.
  void TakeFrom(const ChebyshevOperators& higher);

  int P;
  std::array<SparseOperator, Classes> Far;
  std::array<Orientation, Turns> Turned48;
};

/**
 * From a child's moments to its parent's, for the child on the positive side of all axes (others by
 * Reflection). A parent of higher order gets what the child's order tells: the error is that of the
 * child, whose boxes are twice as far apart by its own size.
 */
const SparseOperator& UpwardOperator(int childOrder, int parentOrder);
/// From a parent's local expansion to that child's: the transpose.
const SparseOperator& DownwardOperator(int childOrder, int parentOrder);
}

#endif
