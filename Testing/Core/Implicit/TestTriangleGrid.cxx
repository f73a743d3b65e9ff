// SPDX-License-Identifier: GPL-3.0-or-later
#include "Base/BoundingBox.h"
#include "Implicit/ZeroSet/TriangleGrid.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <vector>

using namespace recon;

TEST(TriangleGrid, MissesNoTriangleWhoseBoxMeets)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-4, 4), size(0, 1.5);
  const auto makeBox = [&]
  {
    const Point3 low{ place(random), place(random), place(random) };
    return Box3(low, low + Vector3{ size(random), size(random), size(random) });
  };
  TriangleGrid grid(0.7);
  std::vector<Box3> boxes;
  for (int t = 0; t < 200; ++t)
  {
    boxes.push_back(makeBox());
    grid.Put(t, boxes[t].Low, boxes[t].High);
  }
  for (int t = 0; t < 200; t += 3) // some move
  {
    boxes[t] = makeBox();
    grid.Put(t, boxes[t].Low, boxes[t].High);
  }
  for (int n = 0; n < 50; ++n)
  {
    const Box3 query = makeBox();
    std::set<int> found;
    EXPECT_FALSE(grid.AnyNear(query.Low, query.High,
      [&](int t)
      {
        found.insert(t);
        return false;
      }));
    for (int t = 0; t < 200; ++t)
    {
      EXPECT_TRUE(!boxes[t].Meets(query) || found.count(t) > 0);
    }
  }
}

TEST(TriangleGrid, StopsAtTheFirstYes)
{
  TriangleGrid grid(1);
  grid.Put(0, { 0, 0, 0 }, { 1, 1, 1 });
  int asked = 0;
  EXPECT_TRUE(grid.AnyNear({ 0, 0, 0 }, { 1, 1, 1 }, [&](int) { return ++asked == 1; }));
  EXPECT_EQ(asked, 1);
  EXPECT_FALSE(grid.AnyNear({ 5, 5, 5 }, { 6, 6, 6 }, [&](int) { return true; }));
}
