// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file TurnOrder.h
 * @brief The order of directions around a point of a plane; exact.
 */
#ifndef recon_TurnOrder_h
#define recon_TurnOrder_h

#include "Base/Predicates.h"

namespace recon
{
/// On turning counterclockwise from straight down (which comes last): whether a is met before b.
/// Directions that are the same come in no order.
inline bool ComesFirstFromBelow(const Point2& at, const Point2& a, const Point2& b)
{
  // In the order of points: what is greater lies to the right, straight up included.
  const bool rightA = at < a;
  const bool rightB = at < b;
  return rightA != rightB ? rightA : Orientation2(at, a, b) > 0;
}

/// On turning clockwise from the direction to another point (which comes last): whether a is met
/// before b. Where a walk comes from there, the first one bounds the same bit to its left.
inline bool ComesFirstClockwise(
  const Point2& at, const Point2& from, const Point2& a, const Point2& b)
{
  // Quarters of the turn: less than half, half, more than half, the whole.
  const auto quarter = [&](const Point2& to)
  {
    const int turn = Orientation2(at, from, to);
    const bool back = turn == 0 && (at < from) == (at < to);
    return back ? 3 : turn < 0 ? 0 : turn == 0 ? 1 : 2;
  };
  const int ofA = quarter(a);
  const int ofB = quarter(b);
  return ofA != ofB ? ofA < ofB : Orientation2(at, a, b) < 0;
}
}

#endif
