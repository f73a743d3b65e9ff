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
  std::vector<int> order = DissectMesh(torus).Rank;
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
  const std::vector<int> order = DissectMesh(torus).Rank;
  const int last = static_cast<int>(order.size()) - 20;
  for (std::size_t v = 0; v < order.size(); ++v)
  {
    if (order[v] >= last)
    {
      EXPECT_LT(std::abs(torus.Points[v][0]), 8);
    }
  }
}

TEST(DissectionOrder, NoPointReachesAcrossWhatPartsIt)
{
  // Two edges far, by whatever point lies between, which may be of an earlier part.
  const TriangleMesh torus = MakeTorus(3, 1, 60, 24);
  const DissectionOrder order = DissectMesh(torus);
  std::vector<std::vector<int>> beside(torus.Points.size());
  for (const auto& t : torus.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      beside[order.Rank[t[k]]].push_back(order.Rank[t[(k + 1) % 3]]);
      beside[order.Rank[t[(k + 1) % 3]]].push_back(order.Rank[t[k]]);
    }
  }
  std::vector<int> nodeOf(torus.Points.size());
  for (std::size_t node = 0; node < order.Nodes.size(); ++node)
  {
    for (int place = order.Nodes[node].From; place < order.Nodes[node].To; ++place)
    {
      nodeOf[place] = static_cast<int>(node);
    }
  }
  const auto isAbove = [&](int node, int other)
  {
    while (node >= 0 && node != other)
    {
      node = order.Nodes[node].Parent;
    }
    return node == other;
  };
  for (std::size_t p = 0; p < beside.size(); ++p)
  {
    for (const int middle : beside[p])
    {
      for (const int q : beside[middle])
      {
        EXPECT_TRUE(isAbove(nodeOf[p], nodeOf[q]) || isAbove(nodeOf[q], nodeOf[p]));
      }
    }
  }
}
