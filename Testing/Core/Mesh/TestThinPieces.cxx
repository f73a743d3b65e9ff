// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ThinPieces.h"

#include <gtest/gtest.h>

using namespace recon;

TEST(ThinPieces, AreToldByVolumeAndArea)
{
  // A tetrahedron with three edges of length 1 at a right angle, and one of height h beside it.
  for (const double h : { 1.0, 1e-6 })
  {
    const TriangleMesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 5, 0, 0 },
                               { 6, 0, 0 }, { 5, 1, 0 }, { 5, 0, h } },
      { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 4, 6, 5 }, { 4, 5, 7 }, { 5, 6, 7 },
        { 6, 4, 7 } } };
    const std::vector<int> pieces{ 0, 0, 0, 0, 1, 1, 1, 1 };
    EXPECT_EQ(HasThinPiece(mesh, pieces, { 1.0 / 6, h / 6 }, 1e-5), h < 1);
    EXPECT_EQ(HasThinPiece(mesh, pieces, { -1.0 / 6, -h / 6 }, 1e-5), h < 1);
    EXPECT_TRUE(HasThinPiece(mesh, pieces, { 1.0 / 6, h / 6 }, 1));
  }
}
