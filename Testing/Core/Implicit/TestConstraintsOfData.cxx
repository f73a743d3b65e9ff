// SPDX-License-Identifier: GPL-3.0-or-later
// Algorithm 13 on every set of the shared data and of Data/: exactly 3n constraints but for those
// that are said to be left out, none too near another for a fit, each inner one inside and each
// outer one outside, both of the level and of its own contour. Prints a line a set.
//
// Sides are decided by winding numbers with CGAL's exact orientation and by CGAL's own polygon
// test, where the code under test counts crossings of a ray.
#include "Contours/ContourSetBuilder.h"
#include "Core/SetsOfData.h"
#include "Implicit/Constraints/NearConstraints.h"
#include "TestPaths.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <cstdio>

using namespace recon;
using namespace recon::testing;

namespace
{
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polygon = std::vector<Exact::Point_2>;

Polygon PolygonOf(const ContourSet& set, const Contour& contour)
{
  Polygon polygon;
  for (const int p : contour.Points)
  {
    const Point2& at = set.Planar[static_cast<std::size_t>(p)];
    polygon.emplace_back(at[0], at[1]);
  }
  return polygon;
}

/// How often a closed polygon turns about p; no meaning on its border.
int WindingNumber(const Polygon& polygon, const Exact::Point_2& p)
{
  int turns = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Exact::Point_2& a = polygon[i];
    const Exact::Point_2& b = polygon[(i + 1) % polygon.size()];
    // Upward edges left of which p lies, less downward edges right of which it lies.
    if (a.y() <= p.y() && b.y() > p.y())
    {
      turns += CGAL::orientation(a, b, p) == CGAL::LEFT_TURN ? 1 : 0;
    }
    else if (a.y() > p.y() && b.y() <= p.y())
    {
      turns -= CGAL::orientation(a, b, p) == CGAL::RIGHT_TURN ? 1 : 0;
    }
  }
  return turns;
}

/// Faults of one set, counted, as a set has a hundred thousand constraints.
struct Faults
{
  std::size_t OffContour = 0; ///< boundary constraints farther than a near point's from the vertex
  std::size_t Moved = 0;      ///< boundary constraints elsewhere than their vertex
  std::size_t WrongSide = 0;  ///< of the solid of the level
  std::size_t WrongOfOwn = 0; ///< of the contour that the margin belongs to
  std::size_t WrongValue = 0; ///< sign
  std::size_t FarMargins = 0; ///< further from the vertex than MarginDistance
};

class Checker
{
public:
  explicit Checker(const ContourSet& contours) : Contours(contours)
  {
    for (const Contour& contour : contours.Contours)
    {
      this->Walls.push_back(PolygonOf(contours, contour));
    }
  }

  Faults Check(const ConstraintSet& constraints) const
  {
    Faults faults;
    const double apart = LeastDistanceApart(constraints);
    Point3 vertex{};
    std::size_t contour = 0;
    std::size_t position = 0;
    for (std::size_t i = 0; i < constraints.Points.size(); ++i)
    {
      const double value = constraints.Values[i];
      const int kind = constraints.Kind[i];
      faults.WrongValue += (kind > 0) == (value > 0) && (kind < 0) == (value < 0) ? 0 : 1;
      if (kind == ConstraintSet::Boundary)
      {
        this->Advance(contour, position);
        const int expected = this->Contours.Contours[contour].Points[position++];
        vertex = this->Contours.Points[static_cast<std::size_t>(expected)];
        faults.Moved += constraints.Points[i] == vertex ? 0 : 1;
        faults.OffContour += Norm(constraints.Points[i] - vertex) <= apart &&
            constraints.Contour[i] == static_cast<int>(contour)
          ? 0
          : 1;
        continue;
      }
      const bool far =
        Norm(constraints.Points[i] - vertex) > constraints.MarginDistance * (1 + 1e-9);
      faults.FarMargins += far ? 1 : 0;
      this->CheckSides(constraints.Points[i], contour, kind, faults);
    }
    return faults;
  }

private:
  void Advance(std::size_t& contour, std::size_t& position) const
  {
    if (position == this->Contours.Contours[contour].Points.size())
    {
      ++contour;
      position = 0;
    }
  }

  void CheckSides(const Point3& place, std::size_t contour, int kind, Faults& faults) const
  {
    const Contour& own = this->Contours.Contours[contour];
    const Level& level = this->Contours.Levels[static_cast<std::size_t>(own.Level)];
    const Point2 planar = level.Frame.ToPlane(place);
    const Exact::Point_2 p(planar[0], planar[1]);
    int turns = 0;
    bool onBorder = false;
    for (const int c : level.Contours)
    {
      const Polygon& wall = this->Walls[static_cast<std::size_t>(c)];
      onBorder = onBorder ||
        (static_cast<std::size_t>(c) == contour &&
          CGAL::bounded_side_2(wall.begin(), wall.end(), p, Exact()) == CGAL::ON_BOUNDARY);
      turns += WindingNumber(wall, p);
    }
    // Outer walls turn left and holes right, so that a point turns once in the solid, else never.
    faults.WrongSide += !onBorder && turns == (kind > 0 ? 1 : 0) ? 0 : 1;
    const Polygon& wall = this->Walls[contour];
    const bool within = (kind > 0) == (own.Depth % 2 == 0);
    faults.WrongOfOwn += CGAL::bounded_side_2(wall.begin(), wall.end(), p, Exact()) ==
        (within ? CGAL::ON_BOUNDED_SIDE : CGAL::ON_UNBOUNDED_SIDE)
      ? 0
      : 1;
  }

  const ContourSet& Contours;
  std::vector<Polygon> Walls;
};

/// Constraints that have another one nearer than a fit can tell apart, but not in the same place.
std::size_t NearOnes(const ConstraintSet& constraints)
{
  const double apart = LeastDistanceApart(constraints);
  std::vector<Point3> sorted = constraints.Points;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::size_t near = 0;
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j][0] - sorted[i][0] < apart; ++j)
    {
      // How rounding decides a tie does not matter here.
      near += Norm(sorted[j] - sorted[i]) < (1 - 1e-9) * apart ? 1 : 0;
    }
  }
  return near;
}

void CheckSet(const std::string& name, const ContourSet& contours, bool reachAcrossSteps)
{
  Monitor monitor;
  ConstraintOptions options;
  options.ReachAcrossSteps = reachAcrossSteps;
  const ConstraintSet constraints = BuildInPlaneConstraints(contours, options, monitor);
  std::size_t vertices = 0;
  for (const Contour& contour : contours.Contours)
  {
    vertices += contour.Points.size();
  }
  const Faults faults = Checker(contours).Check(constraints);
  std::printf("%-58s %7zu vertices %7zu constraints%s, %zu reach across steps\n", name.c_str(),
    vertices, constraints.Points.size(), constraints.Report.empty() ? "" : " *", faults.FarMargins);
  for (const std::string& line : constraints.Report)
  {
    std::printf("    * %s\n", line.c_str());
  }
  EXPECT_EQ(constraints.Points.size() + constraints.LeftOut, 3 * vertices);
  EXPECT_EQ(constraints.LeftOut == 0 && faults.Moved == 0, constraints.Report.empty());
  EXPECT_EQ(NearOnes(constraints), 0u);
  EXPECT_EQ(faults.OffContour, 0u);
  EXPECT_EQ(faults.WrongSide, 0u);
  EXPECT_EQ(faults.WrongOfOwn, 0u);
  EXPECT_EQ(faults.WrongValue, 0u);
  EXPECT_TRUE(reachAcrossSteps || faults.FarMargins == 0);
}

/// Sets that cannot have constraints say why: no area, or one plane only.
void Check(const std::string& name, const LoopSoup& soup)
{
  SCOPED_TRACE(name);
  ContourSetOptions options;
  options.Parallel = false;
  Monitor monitor;
  ContourSet contours;
  try
  {
    contours = BuildContourSet(soup, options, monitor);
  }
  catch (const Error& error)
  {
    std::printf("%-58s no contours: %s\n", name.c_str(), error.what());
    return;
  }
  if (contours.Levels.size() < 2)
  {
    EXPECT_THROW(BuildInPlaneConstraints(contours, {}, monitor), Error);
    std::printf("%-58s one plane, refused\n", name.c_str());
    return;
  }
  CheckSet(name, contours, false);
  CheckSet(name, contours, true);
}

ContourSet ReadPipe()
{
  ContourSetOptions options;
  options.Parallel = false;
  Monitor monitor;
  const LoopSoup soup = ReadSoups(OwnPath("Data/branching_pipe.cnt")).at(0).second;
  return BuildContourSet(soup, options, monitor);
}

TEST(ConstraintsOfData, CheckerFindsMarginsThatChangedPlaces)
{
  const ContourSet contours = ReadPipe();
  Monitor monitor;
  ConstraintSet constraints = BuildInPlaneConstraints(contours, {}, monitor);
  const std::size_t vertices = constraints.Points.size() / 3;
  for (std::size_t v = 0; v < vertices; ++v)
  {
    std::swap(constraints.Points[3 * v + 1], constraints.Points[3 * v + 2]);
  }
  const Faults faults = Checker(contours).Check(constraints);
  EXPECT_EQ(faults.WrongSide, 2 * vertices);
  EXPECT_EQ(faults.WrongOfOwn, 2 * vertices);
  EXPECT_EQ(faults.OffContour, 0u);
}

TEST(ConstraintsOfData, OwnData)
{
  ForSoups(OwnPath("Data"), ".cnt", Check);
  ForSoups(OwnPath("Data"), ".csl", Check);
}

TEST_F(SharedData, NUAGES)
{
  ForSoups(SharedPath("cnt"), ".cnt", Check);
}

TEST_F(SharedData, CrossSections)
{
  ForSoups(SharedPath("csl"), ".csl", Check);
}

TEST_F(SharedData, CurveNetworks)
{
  ForSoups(SharedPath("contour"), ".contour", Check);
}

TEST_F(SharedData, StructureSets)
{
  ForSoups(SharedPath("rtstruct"), ".dcm", Check);
}

TEST_F(SharedData, Phantoms)
{
  ForSoups(SharedPath("rtstruct/phantoms"), ".dcm", Check);
}
}
