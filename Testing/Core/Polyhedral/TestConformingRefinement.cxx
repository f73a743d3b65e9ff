// SPDX-License-Identifier: GPL-3.0-or-later
// Points on contour edges, where contours are as thin as rounding and thinner.
#include "Base/Parallel.h"
#include "LevelInvariants.h"
#include "Polyhedral/ConformingRefinement.h"
#include "PolyhedralShapes.h"

#include <gtest/gtest.h>

#include <ctime>
#include <vector>

using namespace recon;
using namespace recon::testing;

namespace
{
/// The triangulation of rings with their edges as constraints.
delaunay::Triangulation Constrained(const std::vector<Ring>& rings)
{
  delaunay::Triangulation triangulation;
  for (const Ring& ring : rings)
  {
    std::vector<delaunay::VertexHandle> vertices;
    for (const Point2& p : ring)
    {
      vertices.push_back(triangulation.insert({ p[0], p[1] }));
    }
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      triangulation.insert_constraint(vertices[i], vertices[(i + 1) % vertices.size()]);
    }
  }
  return triangulation;
}

/// Two rectangles that face each other from x = 0.37 to 1, `width` apart.
std::vector<Ring> Neighbours(double width)
{
  return { Rectangle(0, 0, 1, 1), Rectangle(0.37, -1, 1.9, -width) };
}

/// Asks to stop after a tenth of a second. Seconds are the processor's, as other tests run beside this.
class StopAfterAWhile : public Monitor
{
public:
  bool AbortRequested() override
  {
    const bool asks = std::clock() - this->Start > CLOCKS_PER_SEC / 10;
    this->Asked = asks && this->Asked == 0 ? std::clock() : this->Asked;
    return asks;
  }

  double SecondsSinceAsked() const
  {
    return static_cast<double>(std::clock() - this->Asked) / CLOCKS_PER_SEC;
  }

private:
  std::clock_t Start = std::clock();
  std::clock_t Asked = 0;
};

int EdgesThatAreNotDelaunay(const delaunay::Triangulation& triangulation)
{
  int wrong = 0;
  for (const auto& edge : triangulation.finite_edges())
  {
    const auto far = triangulation.tds().mirror_vertex(edge.first, edge.second);
    if (!triangulation.is_infinite(edge.first) && !triangulation.is_infinite(far))
    {
      wrong +=
        triangulation.side_of_oriented_circle(edge.first, far->point()) == CGAL::ON_POSITIVE_SIDE;
    }
  }
  return wrong;
}
}

TEST(ConformingRefinement, EdgesOfARegularShapeBecomeGabriel)
{
  auto triangulation = Constrained(Neighbours(0.05));
  const RefinementOutcome outcome = RefineToGabriel(triangulation, 10000);
  EXPECT_EQ(outcome.Problem, RefinementOutcome::None);
  EXPECT_TRUE(triangulation.is_valid());
  EXPECT_GT(triangulation.number_of_vertices(), 8u);
  EXPECT_EQ(EdgesThatAreNotDelaunay(triangulation), 0);
}

TEST(ConformingRefinement, StopsAtTheBoundWithASoundTriangulation)
{
  auto triangulation = Constrained(Neighbours(1e-9));
  const RefinementOutcome outcome = RefineToGabriel(triangulation, 500);
  EXPECT_EQ(outcome.Problem, RefinementOutcome::TooManyPoints);
  EXPECT_NEAR(outcome.Place[1], 0, 1e-8) << "the gap lies there";
  EXPECT_LE(triangulation.number_of_vertices(), 500u);
  EXPECT_TRUE(triangulation.is_valid());
}

TEST(ConformingRefinement, AnEdgeWhoseMiddleIsAnotherVertexHasNoPlace)
{
  // The rounded middle of the first edge is the third corner.
  auto triangulation = Constrained(
    { Ring{ { 0.1, 0.5 }, { 0.30000000000000004, 0.30000000000000004 }, { 0.2, 0.4 } } });
  const RefinementOutcome outcome = RefineToGabriel(triangulation, 10000);
  EXPECT_EQ(outcome.Problem, RefinementOutcome::NoPlace);
  EXPECT_TRUE(triangulation.is_valid());
}

TEST(ConformingRefinement, ThinShapesBecomeDelaunayWithFewPoints)
{
  for (double width : { 1e-3, 1e-6, 1e-9, 1e-12 })
  {
    SCOPED_TRACE(width);
    auto triangulation = Constrained({ Ring{ { 0, 0 }, { 1, 0 }, { 0.5, width } } });
    EXPECT_EQ(RefineToDelaunay(triangulation, 1000).Problem, RefinementOutcome::None);
    EXPECT_TRUE(triangulation.is_valid());
    EXPECT_EQ(EdgesThatAreNotDelaunay(triangulation), 0);
  }
}

TEST(ConformingRefinement, StopsWithinHalfASecond)
{
  // Some ten million points would be put into the gap.
  auto triangulation = Constrained(Neighbours(1e-7));
  StopAfterAWhile monitor;
  bool finished = false;
  EXPECT_THROW(ParallelFor(1, 1,
                 [&](int)
                 {
                   RefineToGabriel(triangulation, 100000000);
                   finished = true;
                 },
                 monitor, { 0, 1, "triangulating" }),
    Aborted);
  EXPECT_FALSE(finished);
  EXPECT_LT(monitor.SecondsSinceAsked(), 0.5);
}

TEST(ConformingRefinement, AThinLevelIsTriangulatedInASecond)
{
  // Condition 2 would take some hundred thousand points.
  SoupMaker maker;
  for (const Ring& ring : Neighbours(1e-5))
  {
    maker.Loop(ring, 0).Loop(ring, 1);
  }
  const ContourSet contours = maker.Build();
  LevelTriangulator triangulator(contours, 0);
  const LevelTriangulation level = triangulator.Finish();
  EXPECT_LT(level.Points.size(), 10000u);
  for (std::size_t t = 0; t < level.Triangles.size(); ++t)
  {
    const auto& c = level.Triangles[t];
    EXPECT_EQ(
      CGAL::orientation(delaunay::Kernel::Point_2(level.Points[c[0]][0], level.Points[c[0]][1]),
        delaunay::Kernel::Point_2(level.Points[c[1]][0], level.Points[c[1]][1]),
        delaunay::Kernel::Point_2(level.Points[c[2]][0], level.Points[c[2]][1])),
      CGAL::LEFT_TURN);
  }
}
