// SPDX-License-Identifier: GPL-3.0-or-later
#include "Implicit/ZeroSet/Lattice.h"

#include <gtest/gtest.h>

#include <set>

using namespace recon;

namespace
{
const Bounds Box{ 0, 1, -2, 2, 10, 13 };
}

TEST(Lattice, OpenPlanesLieInTheBounds)
{
  const Lattice lattice(Box, 0.3, false);
  const Point3 first = lattice.At({ 0, 0, 0 });
  const Point3 last = lattice.At({ lattice.Cells[0], lattice.Cells[1], lattice.Cells[2] });
  for (int a = 0; a < 3; ++a)
  {
    EXPECT_DOUBLE_EQ(first[a], Box[2 * a]);
    EXPECT_DOUBLE_EQ(last[a], Box[2 * a + 1]);
    EXPECT_LE(lattice.Step[a], 0.3);
    EXPECT_GT(lattice.Step[a], 0.15);
  }
}

TEST(Lattice, ClosedHasALayerAroundTheBounds)
{
  const Lattice lattice(Box, 0.3, true);
  const LatticeIndex most{ lattice.Cells[0] - 1, lattice.Cells[1] - 1, lattice.Cells[2] - 1 };
  for (int a = 0; a < 3; ++a)
  {
    // To the last bit: the surface is cut there.
    EXPECT_EQ(lattice.At({ 1, 1, 1 })[a], Box[2 * a]);
    EXPECT_EQ(lattice.At(most)[a], Box[2 * a + 1]);
  }
  EXPECT_FALSE(lattice.IsBeyond({ 1, 1, 1 }));
  EXPECT_FALSE(lattice.IsBeyond(most));
  EXPECT_TRUE(lattice.IsBeyond({ 0, 1, 1 }));
  EXPECT_TRUE(lattice.IsBeyond({ 1, 1, lattice.Cells[2] }));
}

TEST(Lattice, FacesOfTheBoundsAreNumbered)
{
  const Lattice lattice(Box, 0.3, true);
  EXPECT_EQ(lattice.FaceInside({ 1, 1, 1 }), 0);
  EXPECT_EQ(lattice.FaceInside({ 0, 1, 1 }), 1);
  EXPECT_EQ(lattice.FaceInside({ 1, lattice.Cells[1] - 1, 1 }), 4);
  EXPECT_EQ(lattice.FaceInside({ 1, 1, lattice.Cells[2] - 1 }), 6);
  EXPECT_EQ(lattice.FaceInside({ 0, 0, 1 }), -1);
  EXPECT_EQ(Lattice(Box, 0.3, false).FaceInside({ 0, 0, 0 }), 0);
}

TEST(Lattice, EachCubeHoldsItsMiddle)
{
  const Lattice lattice(Box, 0.4, true);
  std::set<std::uint64_t> keys;
  for (int i = 0; i < lattice.Cells[0]; ++i)
  {
    for (int j = 0; j < lattice.Cells[1]; ++j)
    {
      for (int k = 0; k < lattice.Cells[2]; ++k)
      {
        const Point3 middle =
          0.5 * lattice.At({ i, j, k }) + 0.5 * lattice.At({ i + 1, j + 1, k + 1 });
        EXPECT_EQ(lattice.CubeOf(middle), (LatticeIndex{ i, j, k }));
        EXPECT_TRUE(lattice.HasCube({ i, j, k }));
        EXPECT_TRUE(keys.insert(Lattice::Key({ i, j, k })).second);
      }
    }
  }
}

TEST(Lattice, FarOutsideIsOutside)
{
  const Lattice lattice(Box, 0.4, false);
  EXPECT_FALSE(lattice.HasCube(lattice.CubeOf({ 1e300, 0, 11 })));
  EXPECT_FALSE(lattice.HasCube(lattice.CubeOf({ 0.5, -1e300, 11 })));
}
