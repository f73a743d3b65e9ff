// SPDX-License-Identifier: GPL-3.0-or-later
// The order of directions around a point, against angles where these are far apart, and exactly.
#include "Planar/TurnOrder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace recon;

namespace
{
constexpr double Pi = 3.14159265358979323846;

Point2 Direction(const Point2& at, int twelfth)
{
  return { at[0] + std::cos(twelfth * Pi / 6), at[1] + std::sin(twelfth * Pi / 6) };
}

TEST(TurnOrder, FromBelow)
{
  // -2 is to the right of straight down, 9 straight down itself, which is last.
  for (int a = -2; a <= 9; ++a)
  {
    for (int b = -2; b <= 9; ++b)
    {
      const Point2 at{ 0, 0 };
      const Point2 down{ 0, -1 };
      const Point2 up{ 0, 1 };
      const auto place = [&](int k) { return k == 9 ? down : k == 3 ? up : Direction(at, k); };
      EXPECT_EQ(ComesFirstFromBelow(at, place(a), place(b)), a < b) << a << " " << b;
    }
  }
}

TEST(TurnOrder, Clockwise)
{
  const Point2 at{ 3, -2 };
  for (int from = 0; from < 12; ++from)
  {
    // Straight on, which the cosines do not hit, is left out.
    for (int a : { 1, 2, 4, 5, 7, 8, 10, 11, 12 })
    {
      for (int b : { 1, 2, 4, 5, 7, 8, 10, 11, 12 })
      {
        const auto place = [&](int turned)
        { return Direction(at, turned == 12 ? from : from - turned + 12); };
        EXPECT_EQ(ComesFirstClockwise(at, Direction(at, from), place(a % 12 == 0 ? 12 : a),
                    place(b % 12 == 0 ? 12 : b)),
          a < b)
          << from << " " << a << " " << b;
      }
    }
  }
}

TEST(TurnOrder, StraightOnAndStraightBack)
{
  const Point2 at{ 0.1, 0.1 };
  const Point2 from{ 0.3, 0.1 };
  const Point2 on{ -0.5, 0.1 };
  const Point2 back{ 0.2, 0.1 };
  const Point2 hardlyRight{ 0.3, std::nextafter(0.1, 0.0) };
  const Point2 hardlyLeft{ 0.3, std::nextafter(0.1, 1.0) };
  const std::vector<Point2> order{ hardlyRight, on, hardlyLeft, back };
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    for (std::size_t j = 0; j < order.size(); ++j)
    {
      EXPECT_EQ(ComesFirstClockwise(at, from, order[i], order[j]), i < j) << i << " " << j;
    }
  }
}
}
