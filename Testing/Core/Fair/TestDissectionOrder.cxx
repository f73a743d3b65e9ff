// SPDX-License-Identifier: GPL-3.0-or-later
#include "Fair/DissectionOrder.h"

#include "Core/Mesh/MeshShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace recon;
using namespace recon::testing;

TEST(DissectionOrder, NumbersEveryPointOnce)
{
  const TriangleMesh torus = MakeTorus(3, 1);
  std::vector<int> order = DissectionOrder(torus);
  std::sort(order.begin(), order.end());
  std::vector<int> wanted(torus.Points.size());
  std::iota(wanted.begin(), wanted.end(), 0);
  EXPECT_EQ(order, wanted);
}

TEST(DissectionOrder, EndsWithPointsThatPartTheRest)
{
  // A long box: the last numbers are in its middle, so that the equations fall into two halves.
  TriangleMesh torus = MakeTorus(3, 1, 80, 20);
  for (Point3& p : torus.Points)
  {
    p[0] *= 10;
  }
  const std::vector<int> order = DissectionOrder(torus);
  const int last = static_cast<int>(order.size()) - 20;
  for (std::size_t v = 0; v < order.size(); ++v)
  {
    if (order[v] >= last)
    {
      EXPECT_LT(std::abs(torus.Points[v][0]), 8);
    }
  }
}
