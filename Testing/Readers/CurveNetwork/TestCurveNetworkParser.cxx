// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/ReaderTesting.h"

#include "CurveNetwork/CurveNetworkParser.h"

#include <algorithm>
#include <map>
#include <ostream>
#include <set>

using namespace readertesting;

namespace
{
class CurveNetworkParser : public Folder
{
protected:
  recon::CurveNetwork Read(const std::string& bytes)
  {
    const std::string fileName = this->Write("some network", bytes);
    return recon::ReadCurveNetwork(fileName, this->Monitor);
  }
  recon::Monitor Monitor;
};

/// Twice the area about z, counterclockwise positive.
double TwiceArea(const recon::LoopSoup& soup, const recon::LoopSoup::Chain& chain)
{
  double area = 0;
  for (std::size_t i = 0; i < chain.Points.size(); ++i)
  {
    const recon::Point3& a = soup.Points[static_cast<std::size_t>(chain.Points[i])];
    const recon::Point3& b =
      soup.Points[static_cast<std::size_t>(chain.Points[(i + 1) % chain.Points.size()])];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

/// Twice the areas of a material's loops, sorted.
std::vector<double> TwiceAreas(const recon::MaterialContours& material)
{
  std::vector<double> areas;
  for (const recon::LoopSoup::Chain& chain : material.Soup.Chains)
  {
    areas.push_back(TwiceArea(material.Soup, chain));
  }
  std::sort(areas.begin(), areas.end());
  return areas;
}

// A square of material 1 beside one of material 2, which meet in an edge with two vertices of
// degree three.
const char* const TwoSquares = "1\n0 0 2 6\n6 7\n"
                               "0 0 3\n1 0 3\n2 0 3\n2 1 3\n1 1 3\n0 1 3\n"
                               "0 1 1 0\n1 2 2 0\n2 3 2 0\n3 4 2 0\n4 5 1 0\n5 0 1 0\n1 4 1 2\n";

struct Expected
{
  const char* Name;
  std::size_t Planes;
  std::map<int, std::pair<std::size_t, std::size_t>> Materials; ///< label: contours, points
  std::size_t Swapped;
  std::size_t Unfit;
};

/// The name of the test is that of the file.
void PrintTo(const Expected& expected, std::ostream* os)
{
  *os << expected.Name;
}

class RealCurveNetwork : public testing::TestWithParam<Expected>
{
};
}

TEST_F(CurveNetworkParser, CSLWithHoleBeforeItsParent)
{
  const recon::CurveNetwork network =
    this->Read("CSLC\n 1 9\n\n 5 7 2 0 0 1 -2\n\n"
               "0 0 2\n4 0 2\n4 4 2\n0 4 2\n1 1 2\n1 2 2\n2 1 2\n\n"
               "3h1 8 4 5 6\n4 3 0 1 2 3\n");
  ASSERT_EQ(network.Materials.size(), 1u);
  EXPECT_EQ(network.Materials[0].Label, 3) << "a hole bounds the material that it is cut out of";
  const recon::LoopSoup& soup = network.Materials[0].Soup;
  ASSERT_EQ(soup.Chains.size(), 2u);
  EXPECT_EQ(soup.Chains[0].Points.size(), 3u);
  EXPECT_EQ(soup.Points[0], (recon::Point3{ 1, 1, 2 }));
  EXPECT_TRUE(soup.Chains[1].Closed);
  EXPECT_TRUE(network.Report.empty());
}

TEST_F(CurveNetworkParser, CSLBlockAMaterialAndWrongPlanes)
{
  const recon::CurveNetwork network =
    this->Read("CSLC\r\n3 1\r\n1 3 1 0 0 1 -1\r\n0 0 1\r\n1 0 1\r\n0 1 1\r\n3 2 0 1 2\r\n"
               "2 3 1 0 0 1 2\r\n0 0 2\r\n1 0 2\r\n0 1 2\r\n3 1 2 1 0\r\n"
               "3 4 1 0 1 0 0\r\n0 0 3\r\n1 0 3\r\n0 1 3\r\n0 2 3\r\n4 2 0 1 2 0\r\n");
  ASSERT_EQ(network.Materials.size(), 2u);
  EXPECT_EQ(network.Materials[0].Label, 1);
  EXPECT_EQ(network.Materials[0].Planes, (std::vector<int>{ 1 }));
  EXPECT_LT(TwiceAreas(network.Materials[0])[0], 0) << "the orientation of the file is kept";
  EXPECT_EQ(network.Materials[1].Planes, (std::vector<int>{ 0, 2 }));
  EXPECT_EQ(network.Materials[1].Soup.Chains[1].Points, (std::vector<int>{ 3, 4, 5, 3 }));
  ASSERT_EQ(network.Report.size(), 2u);
  EXPECT_EQ(
    network.Report[0], "Plane 2: D has the wrong sign; the vertices were taken as they are.");
  EXPECT_EQ(network.Report[1],
    "Plane 3: A, B, C, D do not fit its vertices; the vertices were taken as they are.");
}

TEST_F(CurveNetworkParser, NeighbouringMaterialsHaveTheirCommonBoundaryEach)
{
  const recon::CurveNetwork network = this->Read(TwoSquares);
  ASSERT_EQ(network.Materials.size(), 2u);
  for (const recon::MaterialContours& material : network.Materials)
  {
    ASSERT_EQ(material.Soup.Chains.size(), 1u);
    EXPECT_TRUE(material.Soup.Chains[0].Closed);
    EXPECT_EQ(TwiceAreas(material), (std::vector<double>{ 2 })) << "material to the left";
  }
  EXPECT_TRUE(network.Report.empty());
}

TEST_F(CurveNetworkParser, SwappedSidesAreSwappedBack)
{
  std::string bytes = TwoSquares;
  bytes.resize(bytes.find("0 1 1 0"));
  bytes += "0 1 0 1\n1 2 0 2\n2 3 0 2\n3 4 0 2\n4 5 0 1\n5 0 0 1\n1 4 2 1\n";
  const recon::CurveNetwork network = this->Read(bytes);
  ASSERT_EQ(network.Report.size(), 1u);
  EXPECT_NE(network.Report[0].find("Plane 1: left and right are swapped"), std::string::npos);
  for (const recon::MaterialContours& material : network.Materials)
  {
    EXPECT_EQ(TwiceAreas(material), (std::vector<double>{ 2 }));
  }
}

TEST_F(CurveNetworkParser, SidesAreThoseSeenFromTheTipOfTheNormal)
{
  // The same square with the normal downwards: left of a counterclockwise edge is outside now.
  const recon::CurveNetwork network = this->Read(
    "1\n0 0 -1 0\n4 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 1 0 1\n1 2 0 1\n2 3 0 1\n3 0 0 1\n");
  EXPECT_TRUE(network.Report.empty()) << network.Report[0];
  EXPECT_EQ(TwiceAreas(network.Materials.at(0)), (std::vector<double>{ -2 }));
}

TEST_F(CurveNetworkParser, HolesAndMaterialsInsideOneAnother)
{
  // A ring of material 1 from 0 to 4, with a square of material 2 from 1 to 2 in it.
  const recon::CurveNetwork network =
    this->Read("1\n0 0 1 0\n8 8\n0 0 0\n4 0 0\n4 4 0\n0 4 0\n1 1 0\n2 1 0\n2 2 0\n1 2 0\n"
               "0 1 1 0\n1 2 1 0\n2 3 1 0\n3 0 1 0\n4 5 2 1\n5 6 2 1\n6 7 2 1\n7 4 2 1\n");
  ASSERT_EQ(network.Materials.size(), 2u);
  EXPECT_EQ(TwiceAreas(network.Materials[0]), (std::vector<double>{ -2, 32 }));
  EXPECT_EQ(TwiceAreas(network.Materials[1]), (std::vector<double>{ 2 }));
}

TEST_F(CurveNetworkParser, WalksKeepToOneCornerWhereFourEdgesMeet)
{
  // Two squares of one material that touch in a vertex.
  const recon::CurveNetwork network =
    this->Read("1\n0 0 1 0\n7 8\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 1 0\n2 2 0\n1 2 0\n"
               "0 1 1 0\n1 2 1 0\n2 3 1 0\n3 0 1 0\n2 4 1 0\n4 5 1 0\n5 6 1 0\n6 2 1 0\n");
  ASSERT_EQ(network.Materials.size(), 1u);
  EXPECT_EQ(TwiceAreas(network.Materials[0]), (std::vector<double>{ 2, 2 }));
}

TEST_F(CurveNetworkParser, OpenBoundariesAndUselessEdgesAreReported)
{
  const recon::CurveNetwork network = this->Read("1\n0 0 1 0\n4 5\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                                 "0 1 1 0\n1 2 1 0\n2 3 1 0\n2 2 1 0\n1 3 1 1\n");
  ASSERT_EQ(network.Materials.size(), 1u);
  ASSERT_EQ(network.Materials[0].Soup.Chains.size(), 1u);
  EXPECT_FALSE(network.Materials[0].Soup.Chains[0].Closed);
  EXPECT_EQ(network.Materials[0].Soup.Chains[0].Points.size(), 4u);
  ASSERT_EQ(network.Report.size(), 3u);
  EXPECT_NE(network.Report[0].find("joins a vertex to itself"), std::string::npos);
  EXPECT_NE(network.Report[1].find("same material on both sides"), std::string::npos);
  EXPECT_NE(network.Report[2].find("is not closed, it ends at vertex 3"), std::string::npos);
}

TEST_F(CurveNetworkParser, IsToldByContent)
{
  using recon::CurveNetworkFormat;
  const auto formatOf = [this](const std::string& bytes)
  { return recon::CurveNetworkFormatOf(this->Write("x.contour", bytes)); };
  EXPECT_EQ(formatOf("CSLC\n15 2"), CurveNetworkFormat::CSL);
  EXPECT_EQ(formatOf(TwoSquares), CurveNetworkFormat::Contour);
  EXPECT_EQ(formatOf("\xEF\xBB\xBF" + std::string(TwoSquares)), CurveNetworkFormat::Contour);
  EXPECT_EQ(formatOf("5\r\n0. 0. -1. 0. \r\n270 270\r\n"), CurveNetworkFormat::Contour);
  EXPECT_EQ(formatOf("S 2\nv 3 z 0"), CurveNetworkFormat::None);
  EXPECT_EQ(formatOf("5 0 0 1 0 27.5 3"), CurveNetworkFormat::None);
  EXPECT_EQ(formatOf(""), CurveNetworkFormat::None);
  EXPECT_EQ(formatOf(RandomBytes(2000, 4)), CurveNetworkFormat::None);
  EXPECT_EQ(recon::CurveNetworkFormatOf(this->Name("absent")), CurveNetworkFormat::None);
}

TEST_P(RealCurveNetwork, HasTheCountsOfItsTable)
{
  const std::string fileName = Shared(GetParam().Name);
  CONTOUR_SKIP_UNLESS(fileName);
  recon::Monitor monitor;
  const recon::CurveNetwork network = recon::ReadCurveNetwork(fileName, monitor);
  std::map<int, std::pair<std::size_t, std::size_t>> materials;
  std::set<int> planes;
  for (const recon::MaterialContours& material : network.Materials)
  {
    materials[material.Label] = { material.Soup.Chains.size(), material.Soup.Points.size() };
    planes.insert(material.Planes.begin(), material.Planes.end());
    ASSERT_EQ(material.Planes.size(), material.Soup.Chains.size());
    for (const recon::LoopSoup::Chain& chain : material.Soup.Chains)
    {
      EXPECT_TRUE(chain.Closed);
    }
  }
  EXPECT_EQ(materials, GetParam().Materials);
  EXPECT_EQ(planes.size(), GetParam().Planes);
  const auto lines = [&network](const char* part)
  {
    return static_cast<std::size_t>(std::count_if(network.Report.begin(), network.Report.end(),
      [part](const std::string& line) { return line.find(part) != std::string::npos; }));
  };
  EXPECT_EQ(lines("left and right are swapped"), GetParam().Swapped);
  EXPECT_EQ(lines("wrong sign") + lines("do not fit"), GetParam().Unfit);
  EXPECT_EQ(network.Report.size(), GetParam().Swapped + GetParam().Unfit);
}

INSTANTIATE_TEST_SUITE_P(Shared, RealCurveNetwork,
  testing::Values(Expected{ "csl/eight_15.csl", 15, { { 1, { 21, 2028 } } }, 0, 0 },
    Expected{ "csl/hand_ok.csl", 15, { { 1, { 29, 4082 } } }, 0, 0 },
    Expected{ "csl/balloondog.csl", 15, { { 1, { 27, 4579 } } }, 0, 0 },
    Expected{ "csl/armadillo.csl", 26, { { 1, { 62, 11039 } } }, 0, 0 },
    Expected{ "csl/armadillo_simplified_from_mesh.csl", 26, { { 1, { 62, 5685 } } }, 0, 0 },
    Expected{ "csl/Vetebrae.csl", 36, { { 1, { 186, 14815 } } }, 0, 0 },
    Expected{ "csl/Skull-20.csl", 16, { { 1, { 43, 8821 } } }, 0, 0 },
    Expected{ "csl/Heart-25-even-better.csl", 25, { { 1, { 33, 4534 } } }, 0, 0 },
    Expected{ "csl/SideBishop.csl", 10, { { 1, { 22, 1376 } } }, 0, 0 },
    // The plane through the origin fits with either sign.
    Expected{ "csl/rose.csl", 15, { { 1, { 15, 9000 } } }, 0, 14 },
    Expected{ "contour/eight_15.contour", 15, { { 1, { 21, 2028 } } }, 0, 0 },
    Expected{ "contour/ctrmapping.contour", 5, { { 1, { 9, 1789 } } }, 0, 5 },
    Expected{ "contour/inconsistent_Bermano.contour", 5, { { 1, { 5, 349 } } }, 5, 0 },
    Expected{ "contour/inconsistent_ferretbrain.contour", 10, { { 1, { 10, 1346 } } }, 10, 0 },
    Expected{ "contour/inconsistent_mousebrain.contour", 6,
      { { 1, { 9, 1050 } }, { 2, { 7, 1040 } }, { 3, { 6, 555 } }, { 4, { 3, 194 } },
        { 5, { 5, 562 } }, { 6, { 2, 180 } } },
      0, 0 },
    Expected{ "contour/inconsistent_newliver.contour", 6,
      { { 1, { 2, 52 } }, { 2, { 4, 177 } }, { 3, { 7, 740 } } }, 0, 0 },
    Expected{ "contour/liver.contour", 5,
      { { 1, { 2, 102 } }, { 2, { 8, 602 } }, { 3, { 8, 660 } }, { 4, { 2, 86 } },
        { 5, { 3, 142 } } },
      0, 0 },
    Expected{ "contour/mousebrain.contour", 6,
      { { 1, { 5, 862 } }, { 2, { 5, 784 } }, { 3, { 5, 488 } }, { 4, { 4, 200 } },
        { 5, { 4, 391 } }, { 6, { 2, 162 } } },
      0, 0 },
    Expected{ "contour/mug.contour", 5, { { 1, { 9, 1083 } } }, 0, 0 },
    Expected{ "contour/ringc.contour", 4, { { 1, { 4, 122 } }, { 2, { 4, 168 } } }, 0, 0 }));
