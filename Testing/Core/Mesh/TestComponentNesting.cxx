// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/ComponentNesting.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

using namespace recon;
using namespace recon::testing;

namespace
{
/// Components one after the other, and the nesting of each.
class Components
{
public:
  Components& Add(const TriangleMesh& mesh, bool encloses = true)
  {
    this->ComponentOf.insert(
      this->ComponentOf.end(), mesh.Triangles.size(), static_cast<int>(this->Encloses.size()));
    Append(this->Mesh, mesh);
    this->Encloses.push_back(encloses);
    return *this;
  }
  std::vector<int> Nesting() const
  {
    return FindComponentNesting(this->Mesh, this->ComponentOf, this->Encloses);
  }

private:
  TriangleMesh Mesh;
  std::vector<int> ComponentOf;
  std::vector<bool> Encloses;
};

TriangleMesh Cube(double low, double high)
{
  return MakeBox({ low, low, low }, { high, high, high });
}
}

TEST(ComponentNesting, CountsWhatLiesAround)
{
  EXPECT_EQ(Components().Add(Cube(0, 9)).Add(Cube(1, 8)).Add(Cube(2, 7)).Nesting(),
    (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(Components().Add(Cube(3, 4)).Add(Cube(0, 9)).Nesting(), (std::vector<int>{ 1, 0 }));
}

TEST(ComponentNesting, BesideAndThroughIsNotAround)
{
  EXPECT_EQ(Components().Add(Cube(0, 1)).Add(Cube(2, 3)).Nesting(), (std::vector<int>{ 0, 0 }));
  EXPECT_EQ(Components().Add(Cube(0, 4)).Add(Cube(2, 6)).Nesting(), (std::vector<int>{ 0, 0 }));
}

TEST(ComponentNesting, TheHoleOfATorusIsOutside)
{
  EXPECT_EQ(
    Components().Add(MakeTorus(3, 1)).Add(Cube(-0.5, 0.5)).Nesting(), (std::vector<int>{ 0, 0 }));
  EXPECT_EQ(Components()
              .Add(MakeTorus(3, 1))
              .Add(MakeBox({ 2.7, -0.3, -0.3 }, { 3.3, 0.3, 0.3 }))
              .Nesting(),
    (std::vector<int>{ 0, 1 }));
}

TEST(ComponentNesting, WhatEnclosesNothingIsAroundNothing)
{
  EXPECT_EQ(
    Components().Add(Cube(0, 9), false).Add(Cube(1, 8)).Nesting(), (std::vector<int>{ 0, 0 }));
}

TEST(ComponentNesting, CavitiesThatTouchTheirSolidAreInside)
{
  // Standing on the floor, in a corner, and with all of its corners on the walls.
  EXPECT_EQ(Components().Add(Cube(0, 9)).Add(MakeBox({ 1, 1, 0 }, { 2, 2, 1 })).Nesting(),
    (std::vector<int>{ 0, 1 }));
  EXPECT_EQ(Components().Add(Cube(0, 9)).Add(Cube(0, 1)).Nesting(), (std::vector<int>{ 0, 1 }));
  TriangleMesh octahedron;
  octahedron.Points = { { 0, 4, 4 }, { 8, 4, 4 }, { 4, 0, 4 }, { 4, 8, 4 }, { 4, 4, 0 },
    { 4, 4, 8 } };
  for (const int x : { 0, 1 })
  {
    for (const int y : { 2, 3 })
    {
      for (const int z : { 4, 5 })
      {
        octahedron.Triangles.push_back({ x, y, z });
      }
    }
  }
  EXPECT_EQ(Components().Add(Cube(0, 8)).Add(octahedron).Nesting(), (std::vector<int>{ 0, 1 }));
}

TEST(ComponentNesting, OfNothing)
{
  EXPECT_TRUE(Components().Nesting().empty());
}
