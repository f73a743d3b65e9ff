// SPDX-License-Identifier: GPL-3.0-or-later
// Passes that make a mesh even: it stays what it was, on the surface, and becomes better.
#include "Core/Mesh/MeshInvariants.h"
#include "EditedMeshes.h"

using namespace recon;
using namespace recon::testing;

namespace
{
/// A remesher and what it works on.
struct Case
{
  explicit Case(edited::Shape shape, double edgeLength)
    : Shape(std::move(shape)),
      Thin(this->Shape.Mesh.Points.size(), 0),
      Work(this->Shape.Mesh, this->Shape.Normals, edgeLength, this->Thin)
  {
  }

  double LeastAngle() const
  {
    double least = 10;
    for (std::size_t t = 0; t < this->Work.Edited.T.size(); ++t)
    {
      least = this->Work.Edited.IsAlive(static_cast<int>(t))
        ? std::min(least, this->Work.Edited.AngleOf(this->Work.Edited.T[t]))
        : least;
    }
    return least;
  }

  edited::Shape Shape;
  std::vector<char> Thin;
  Remesher Work;
};
}

TEST(Remeshing, CollapsesOnlyShortEdgesAndKeepsTheTopology)
{
  Case ball(edited::Ball(30, 60, 0.2), 0.25);
  ball.Work.CollapseShortEdges();
  EXPECT_TRUE(ball.Work.Edited.EdgesShorterThan(0.4 * 0.25).empty());
  ball.Work.Edited.Compact();
  EXPECT_LT(ball.Shape.Mesh.Points.size(), 900u);
  ExpectSoundSurface(ball.Shape.Mesh);
  EXPECT_EQ(CheckTopology(ball.Shape.Mesh).Total.Euler, 2);
}

TEST(Remeshing, FlipsToLargerAngles)
{
  // The long diagonal of a rhombus.
  edited::Shape rhombus;
  for (const Point3& p :
    { Point3{ -2, 0, 0 }, Point3{ 0, -1, 0 }, Point3{ 2, 0, 0 }, Point3{ 0, 1, 0 },
      Point3{ -3, -3, 0 }, Point3{ 3, -3, 0 }, Point3{ 3, 3, 0 }, Point3{ -3, 3, 0 } })
  {
    rhombus.Add(p, { 0, 0, 1 });
  }
  rhombus.Mesh.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 4, 1, 0 }, { 4, 5, 1 }, { 5, 2, 1 },
    { 5, 6, 2 }, { 6, 3, 2 }, { 6, 7, 3 }, { 7, 0, 3 }, { 7, 4, 0 } };
  Case flat(rhombus, 4);
  EXPECT_TRUE(flat.Work.Flip(0, 2, Usual));
  EXPECT_FALSE(flat.Work.Flip(1, 3, Usual)) << "and not back";
  EXPECT_EQ(flat.Work.Edited.TrianglesAt(1, 3).size(), 2u);
}

TEST(Remeshing, RefusesWhatTurnsAgainstTheSurface)
{
  Case sheet(edited::Sheet(4), 1);
  // The middle point's normals say that the surface faces the other way.
  for (Vector3& n : sheet.Shape.Normals)
  {
    n = { 0, 0, -1 };
  }
  EXPECT_FALSE(sheet.Work.Collapse(12, 13, Usual));
  EXPECT_FALSE(sheet.Work.Flip(6, 12, Usual));
  EXPECT_LT(sheet.Work.QualityAround(12, Usual), 0);
  EXPECT_GT(sheet.Work.QualityAround(12, WithItself), 0);
}

TEST(Remeshing, SpreadsAlongTheSurface)
{
  Case ball(edited::Ball(12, 24, 0.3), 0.3);
  const double before = ball.LeastAngle();
  ball.Work.FlipEdges();
  for (int pass = 0; pass < 3; ++pass)
  {
    ball.Work.Spread(edited::OntoBall);
    ball.Work.FlipEdges();
  }
  EXPECT_GT(ball.LeastAngle(), before);
  for (const Point3& p : ball.Shape.Mesh.Points)
  {
    EXPECT_NEAR(Norm(p), 1, 1e-12);
  }
  ExpectSoundSurface(ball.Shape.Mesh);
}

TEST(Remeshing, AnchorsTheNearestVertexAndPinsIt)
{
  Case sheet(edited::Sheet(4), 1);
  const Point3 anchor{ 2.1, 2.15, 0 };
  EXPECT_EQ(sheet.Work.Anchor({ anchor, { 2.2, 2.2, 0 }, { 40, 40, 0 } }), 1u);
  EXPECT_EQ(sheet.Shape.Mesh.Points[12], anchor);
  EXPECT_TRUE(sheet.Work.Edited.Pinned[12]);
  sheet.Work.Spread(
    [](std::vector<Point3>& points, std::vector<Vector3>& normals, std::vector<char>& done)
    {
      normals.assign(points.size(), { 0, 0, 1 });
      done.assign(points.size(), 1);
    });
  EXPECT_EQ(sheet.Shape.Mesh.Points[12], anchor);
}

TEST(Remeshing, MovesNothingThroughAnotherSheet)
{
  Case plate(edited::Both(edited::Sheet(3, 0.5, true), edited::Sheet(3, 0, false)), 1);
  EXPECT_FALSE(plate.Work.Move(5, { 1.2, 1.3, -0.4 }, { 0, 0, 1 }, true));
  EXPECT_EQ(plate.Shape.Mesh.Points[5], (Point3{ 1, 1, 0.5 }));
  EXPECT_TRUE(plate.Work.Move(5, { 1.2, 1.3, 0.4 }, { 0, 0, 1 }, true));
  std::fill(plate.Thin.begin(), plate.Thin.end(), 1);
  EXPECT_FALSE(plate.Work.Move(5, { 1.2, 1.3, -0.4 }, { 0, 0, 1 })) << "thin places are looked at";
}
