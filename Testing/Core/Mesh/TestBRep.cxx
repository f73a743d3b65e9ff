// SPDX-License-Identifier: GPL-3.0-or-later
// Half-edges, shells and contours of surfaces whose topology is known.
#include "MeshShapes.h"

#include "Mesh/BRep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace recon;
using namespace recon::testing;

namespace
{
BRep Make(const TriangleMesh& mesh, const std::vector<SpaceLoop>& contours = {},
  const std::vector<int>& sets = {})
{
  Monitor monitor;
  std::vector<int> missing;
  const BRep brep = MakeBRep(mesh, sets, contours, missing, monitor);
  EXPECT_TRUE(missing.empty());
  return brep;
}

std::vector<int> Missing(const TriangleMesh& mesh, const std::vector<SpaceLoop>& contours)
{
  Monitor monitor;
  std::vector<int> missing;
  MakeBRep(mesh, {}, contours, missing, monitor);
  return missing;
}

std::string FailureOf(const TriangleMesh& mesh, const std::vector<int>& sets = {})
{
  try
  {
    Make(mesh, {}, sets);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

const BRepShell& OnlyShell(const BRep& brep)
{
  EXPECT_EQ(brep.ShellSets.size(), 1u);
  EXPECT_EQ(brep.ShellSets.front().Shells.size(), 1u);
  return brep.ShellSets.front().Shells.front();
}

SpaceLoop PointsOf(const BRepShell& shell, const std::vector<int>& contour)
{
  SpaceLoop loop;
  for (const int h : contour)
  {
    loop.push_back(shell.Vertices[shell.Edges[h][0]]);
  }
  return loop;
}

/// A unit square prism of height 2 with a ring of vertices half-way up, one edge of it split.
TriangleMesh MakeBelt()
{
  TriangleMesh mesh;
  for (const double z : { 0.0, 1.0, 2.0 })
  {
    mesh.Points.push_back({ 0, 0, z });
    mesh.Points.push_back({ 1, 0, z });
    mesh.Points.push_back({ 1, 1, z });
    mesh.Points.push_back({ 0, 1, z });
  }
  const int middle = 12;
  mesh.Points.push_back({ 0.25, 0, 1 });
  mesh.Triangles = { { 0, 2, 1 }, { 0, 3, 2 }, { 8, 9, 10 }, { 8, 10, 11 } };
  for (const int low : { 0, 4 })
  {
    for (int i = 0; i < 4; ++i)
    {
      const int a = low + i;
      const int b = low + (i + 1) % 4;
      if (i == 0)
      {
        continue;
      }
      mesh.Triangles.push_back({ a, b, b + 4 });
      mesh.Triangles.push_back({ a, b + 4, a + 4 });
    }
  }
  for (const std::array<int, 3>& t : std::vector<std::array<int, 3>>{ { 0, 1, middle },
         { 0, middle, 4 }, { 1, 5, middle }, { 4, middle, 8 }, { middle, 5, 9 }, { middle, 9, 8 } })
  {
    mesh.Triangles.push_back(t);
  }
  return mesh;
}

/// The belt's middle ring, without the vertex that splits its first edge.
SpaceLoop MiddleOfBelt()
{
  return { { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
}
}

TEST(BRep, ACubeIsOneShellOfThirtySixPartneredHalfEdges)
{
  const BRep brep = Make(MakeCube());
  const BRepShell& shell = OnlyShell(brep);
  EXPECT_EQ(shell.Vertices.size(), 8u);
  EXPECT_EQ(shell.Faces.size(), 12u);
  ASSERT_EQ(shell.Edges.size(), 36u);
  for (int h = 0; h < 36; ++h)
  {
    const int g = shell.Partners[h];
    EXPECT_EQ(shell.Partners[g], h);
    EXPECT_EQ(shell.Edges[g][0], shell.Edges[h][1]);
    EXPECT_EQ(shell.Edges[g][1], shell.Edges[h][0]);
  }
  EXPECT_TRUE(shell.Contours.empty());
  EXPECT_EQ(FindShellDefect(shell), "");
}

TEST(BRep, MeshAndBackIsTheSameMesh)
{
  TriangleMesh mesh = MakeSponge(1);
  Append(mesh, MakeTorus(2.7, 0.3));
  const ShelledMesh again = MakeMesh(Make(mesh));
  EXPECT_EQ(again.Mesh.Points, mesh.Points);
  EXPECT_EQ(again.Mesh.Triangles, mesh.Triangles);
  EXPECT_EQ(again.ShellOfTriangle.front(), 0);
  EXPECT_EQ(again.ShellOfTriangle.back(), 1);
}

TEST(BRep, EachComponentIsAShell)
{
  TriangleMesh mesh = MakeCube();
  TriangleMesh second = MakeBox({ 3, 0, 0 }, { 4, 1, 1 });
  Append(mesh, second);
  const BRep brep = Make(mesh);
  ASSERT_EQ(brep.ShellSets.size(), 1u);
  ASSERT_EQ(brep.ShellSets[0].Shells.size(), 2u);
  EXPECT_EQ(brep.ShellSets[0].Shells[1].Vertices, second.Points);
}

TEST(BRep, ComponentsThatShareAPointGetAVertexEach)
{
  TriangleMesh mesh = MakeCube();
  TriangleMesh second = MakeBox({ 1, 1, 1 }, { 2, 2, 2 });
  Append(mesh, second);
  // Corner (1, 1, 1) of both: point 7 of the first, 0 of the second.
  for (auto& t : mesh.Triangles)
  {
    std::replace(t.begin(), t.end(), 8, 7);
  }
  const BRep brep = Make(mesh);
  ASSERT_EQ(brep.ShellSets[0].Shells.size(), 2u);
  EXPECT_EQ(brep.ShellSets[0].Shells[0].Vertices.size(), 8u);
  EXPECT_EQ(brep.ShellSets[0].Shells[1].Vertices.size(), 8u);
}

TEST(BRep, ShellSetsComeByFirstTriangle)
{
  TriangleMesh mesh = MakeCube();
  Append(mesh, MakeBox({ 3, 0, 0 }, { 4, 1, 1 }));
  std::vector<int> sets(24, 7);
  std::fill(sets.begin() + 12, sets.end(), 2);
  const BRep brep = Make(mesh, {}, sets);
  ASSERT_EQ(brep.ShellSets.size(), 2u);
  EXPECT_EQ(brep.ShellSets[0].Shells.front().Vertices.front(), (Point3{ 0, 0, 0 }));
  EXPECT_EQ(brep.ShellSets[1].Shells.front().Vertices.front(), (Point3{ 3, 0, 0 }));
}

TEST(BRep, AContourTakesItsHalfEdgesAlsoThroughAddedPoints)
{
  const BRep brep = Make(MakeBelt(), { MiddleOfBelt() });
  const BRepShell& shell = OnlyShell(brep);
  EXPECT_EQ(FindShellDefect(shell), "");
  ASSERT_EQ(shell.Contours.size(), 1u);
  const SpaceLoop expected{ { 0, 0, 1 }, { 0.25, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  EXPECT_EQ(PointsOf(shell, shell.Contours[0]), expected);
}

TEST(BRep, AContourKeepsItsDirection)
{
  SpaceLoop loop = MiddleOfBelt();
  std::reverse(loop.begin(), loop.end());
  const BRep brep = Make(MakeBelt(), { loop });
  const BRepShell& shell = OnlyShell(brep);
  ASSERT_EQ(shell.Contours.size(), 1u);
  const SpaceLoop expected{ { 0, 1, 1 }, { 1, 1, 1 }, { 1, 0, 1 }, { 0.25, 0, 1 }, { 0, 0, 1 } };
  EXPECT_EQ(PointsOf(shell, shell.Contours[0]), expected);
}

TEST(BRep, AContourIsFoundWhereItsPointsAreDoubled)
{
  // Each point of the belt twice by position; only the second one of each pair is in use.
  TriangleMesh mesh = MakeBelt();
  const int points = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), mesh.Points.begin(), mesh.Points.end());
  for (auto& t : mesh.Triangles)
  {
    for (int& p : t)
    {
      p += points;
    }
  }
  const BRep brep = Make(mesh, { MiddleOfBelt() });
  EXPECT_EQ(OnlyShell(brep).Vertices.size(), static_cast<std::size_t>(points));
  EXPECT_EQ(OnlyShell(brep).Contours.size(), 1u);
}

TEST(BRep, AContourHopsWhereAPinchWasCutOpen)
{
  // Corner (1, 0, 1) of the belt has a second point of its position, which the upper triangles on
  // one side use: a slit along an edge down to it, as a cut through a pinch leaves.
  TriangleMesh mesh = MakeBelt();
  const int copy = static_cast<int>(mesh.Points.size());
  mesh.Points.push_back(mesh.Points[5]);
  for (auto& t : mesh.Triangles)
  {
    Point3 middle = mesh.Points[t[0]] + (mesh.Points[t[1]] + mesh.Points[t[2]]);
    if (middle[0] > 2.9) // the side x = 1
    {
      std::replace(t.begin(), t.end(), 5, copy);
    }
  }
  const BRep brep = Make(mesh, { MiddleOfBelt() });
  const BRepShell& shell = OnlyShell(brep);
  EXPECT_EQ(FindShellDefect(shell), "");
  const SpaceLoop expected{ { 0, 0, 1 }, { 0.25, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  ASSERT_EQ(shell.Contours.size(), 2u) << "the contour, and the slit's border";
  EXPECT_EQ(PointsOf(shell, shell.Contours[0]), expected);
}

TEST(BRep, ContoursThatAreNotOnTheSurfaceAreNamed)
{
  SpaceLoop diagonal = { { 0, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  SpaceLoop near = MiddleOfBelt();
  near[2][0] += 1e-12; // not to the last bit
  SpaceLoop pair = { { 0, 0, 1 }, { 1, 0, 1 } };
  EXPECT_EQ(Missing(MakeBelt(), { diagonal, MiddleOfBelt(), near, pair, {} }),
    (std::vector<int>{ 0, 2, 3, 4 }));
}

TEST(BRep, ABorderBecomesAContourAndItsOwnPartner)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles.erase(mesh.Triangles.begin(), mesh.Triangles.begin() + 2); // no bottom
  const BRep brep = Make(mesh);
  const BRepShell& shell = OnlyShell(brep);
  EXPECT_EQ(FindShellDefect(shell), "");
  ASSERT_EQ(shell.Contours.size(), 1u);
  const std::vector<int>& border = shell.Contours[0];
  ASSERT_EQ(border.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(shell.Partners[border[i]], border[(i + 1) % 4]);
  }
}

TEST(BRep, ABorderThatIsAContourIsWrittenOnce)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles.erase(mesh.Triangles.begin(), mesh.Triangles.begin() + 2);
  const SpaceLoop bottom{ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
  for (const bool turned : { false, true })
  {
    const BRep brep = Make(mesh, { turned ? SpaceLoop(bottom.rbegin(), bottom.rend()) : bottom });
    EXPECT_EQ(OnlyShell(brep).Contours.size(), 1u);
  }
}

TEST(BRep, TwoBordersThatShareAPointStayApart)
{
  // Two triangles that meet in point 0, joined by nothing else: a border each.
  TriangleMesh mesh;
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, -1, 0 } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 3, 4 } };
  const BRep brep = Make(mesh);
  ASSERT_EQ(brep.ShellSets[0].Shells.size(), 2u);
  for (const BRepShell& shell : brep.ShellSets[0].Shells)
  {
    EXPECT_EQ(FindShellDefect(shell), "");
    ASSERT_EQ(shell.Contours.size(), 1u);
    EXPECT_EQ(shell.Contours[0], (std::vector<int>{ 0, 1, 2 }));
  }
}

TEST(BRepInvalid, SurfacesWithoutPartnersAreRefused)
{
  TriangleMesh fan;
  fan.Points = { { 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 }, { -1, -1, 0 } };
  fan.Triangles = { { 0, 1, 2 }, { 1, 0, 3 }, { 0, 1, 4 } };
  EXPECT_NE(FailureOf(fan).find("in the same direction"), std::string::npos);

  TriangleMesh turned = MakeCube();
  std::swap(turned.Triangles[5][1], turned.Triangles[5][2]);
  EXPECT_NE(FailureOf(turned).find("Triangles"), std::string::npos);

  TriangleMesh flat = MakeCube();
  flat.Triangles.push_back({ 3, 3, 4 });
  EXPECT_NE(FailureOf(flat).find("Triangle 12"), std::string::npos);

  EXPECT_NE(FailureOf(TriangleMesh()).find("no triangles"), std::string::npos);

  std::vector<int> sets(12, 0);
  sets[6] = 1;
  EXPECT_NE(FailureOf(MakeCube(), sets).find("another shell set"), std::string::npos);
}

TEST(BRepInvalid, EveryWrongNumberIsFound)
{
  // One number at a time, by one: whatever it is, the topology does not hold together any more.
  const BRep brep = Make(MakeBelt(), { MiddleOfBelt() });
  const BRepShell sound = OnlyShell(brep);
  ASSERT_EQ(FindShellDefect(sound), "");
  const int halfEdges = static_cast<int>(sound.Edges.size());
  std::set<std::string> sentences;
  for (const int by : { -1, 1, 1000, -1000 })
  {
    for (int h = 0; h < halfEdges; ++h)
    {
      BRepShell shell = sound;
      shell.Partners[h] += by;
      EXPECT_NE(FindShellDefect(shell), "") << "partner of " << h;
      shell = sound;
      shell.Edges[h][h % 2] += by;
      EXPECT_NE(FindShellDefect(shell), "") << "end of " << h;
      shell = sound;
      shell.Faces[h / 3][h % 3] += by;
      sentences.insert(FindShellDefect(shell));
    }
    for (std::size_t i = 0; i < sound.Contours[0].size(); ++i)
    {
      BRepShell shell = sound;
      shell.Contours[0][i] += by;
      EXPECT_NE(FindShellDefect(shell), "") << "contour's half-edge " << i;
    }
  }
  EXPECT_EQ(sentences.count(""), 0u);
  EXPECT_GT(sentences.size(), 20u) << "the sentences say where";
}
