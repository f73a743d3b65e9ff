// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/Constraints/SquarePatches.h"

#include <gtest/gtest.h>

using namespace recon;

TEST(SquarePatches, HangTogetherByEdgesAndCornersAndAcrossSizes)
{
  // Two by two, one by its corner, a halved one by an edge; and one apart.
  const std::vector<PlaneSquare> squares = { { { 0.5, 0.5 }, 1, 5 }, { { 1.5, 0.5 }, 1, 5 },
    { { 2.5, 1.5 }, 1, 5 }, { { 3.25, 1.25 }, 0.5, 5 }, { { 9.5, 0.5 }, 1, 5 } };
  EXPECT_DOUBLE_EQ(LargestDetachedPatch(squares), 3.25);
}

TEST(SquarePatches, OneSquareAtAContourAttachesAllOfThem)
{
  std::vector<PlaneSquare> squares = { { { 0.5, 0.5 }, 1, 3 }, { { 0.5, 1.5 }, 1, 2 },
    { { 0.5, 2.5 }, 1, 1 }, { { 7.5, 2.5 }, 1, 1.2 } };
  EXPECT_DOUBLE_EQ(LargestDetachedPatch(squares), 1) << "only the one apart is free";
  squares.pop_back();
  EXPECT_EQ(LargestDetachedPatch(squares), 0);
  EXPECT_EQ(LargestDetachedPatch({}), 0);
}
