// SPDX-License-Identifier: GPL-3.0-or-later
#include "CertificateShapes.h"
#include "Mesh/CertificateText.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <map>

using namespace recon;
using namespace recon::testing;

namespace
{
std::map<std::string, std::optional<double>> ByName(const std::vector<CertificateFigure>& figures)
{
  std::map<std::string, std::optional<double>> map;
  for (const auto& figure : figures)
  {
    EXPECT_TRUE(map.emplace(figure.Name, figure.Value).second) << figure.Name << " twice";
  }
  return map;
}

bool Contains(const std::vector<std::string>& lines, const std::string& text)
{
  for (const auto& line : lines)
  {
    if (line.find(text) != std::string::npos)
    {
      return true;
    }
  }
  return false;
}
}

TEST(CertificateText, FiguresOfASoundCube)
{
  const ContourSet contours = MakeSquareLevel(0.5, 0);
  const SurfaceCertificate certificate = CertifyMesh(MakeCube(), &contours);
  auto total = ByName(ListFigures(certificate.Total));
  EXPECT_EQ(total["Sound"], 1);
  EXPECT_EQ(total["Euler"], 2);
  EXPECT_EQ(total["Genus"], 0);
  EXPECT_EQ(total["Volume"], 1);
  EXPECT_EQ(total["CentroidZ"], 0.5);
  EXPECT_EQ(total["HighX"], 1);
  EXPECT_EQ(total["CrossingPairs"], 0);
  auto withContours = ByName(ListContourFigures(certificate));
  EXPECT_EQ(withContours["WorstSectionPercent"], 0);
  EXPECT_EQ(withContours["TotalSectionPercent"], 0);
  EXPECT_EQ(withContours["FarthestContourVertex"], 0);
  EXPECT_EQ(withContours["ContourVertices"], 4);
  const auto text = ToShortText(certificate);
  EXPECT_EQ(text.size(), 3u);
  EXPECT_TRUE(Contains(text, "Sound: closed, manifold, oriented outward"));
}

TEST(CertificateText, NamesWhatIsWrong)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  mesh.Triangles.pop_back();
  const auto text = ToShortText(CertifyMesh(mesh));
  EXPECT_TRUE(Contains(text, "Not sound: not closed, manifold, oriented."));
  EXPECT_TRUE(Contains(text, "3 open edges"));
  EXPECT_TRUE(Contains(text, "no volume"));
}

TEST(CertificateText, TellsHowFarContoursAreOff)
{
  const ContourSet contours = MakeSquareLevel(0.5, 0.25);
  EXPECT_TRUE(Contains(ToShortText(CertifyMesh(MakeCube(), &contours)), "50 %"));
}

TEST(CertificateText, OfNothing)
{
  EXPECT_EQ(
    ToShortText(CertifyMesh(TriangleMesh())), std::vector<std::string>{ "There is no surface." });
}

TEST(CertificateText, NamesAreTheSameForEverySurface)
{
  const auto names = [](const TriangleMesh& mesh)
  {
    std::vector<std::string> list;
    for (const auto& figure : ListFigures(CertifyMesh(mesh).Total))
    {
      list.push_back(figure.Name);
    }
    return list;
  };
  EXPECT_EQ(names(MakeCube()), names(TriangleMesh()));
}

TEST(CertificateText, JsonSaysNullWhereThereIsNothingToSay)
{
  TriangleMesh mesh = MakeCube();
  mesh.Triangles.erase(mesh.Triangles.begin() + 4);
  const ContourSet contours = MakeSquareLevel(0.5, 0);
  const std::string json = ToJson(CertifyMesh(mesh, &contours));
  EXPECT_NE(json.find("\"Volume\": null"), std::string::npos);
  EXPECT_NE(json.find("\"Genus\": null"), std::string::npos);
  EXPECT_NE(json.find("\"Closed\": false"), std::string::npos);
  EXPECT_NE(json.find("\"OpenEdges\": 3"), std::string::npos);
  EXPECT_NE(json.find("\"WorstSectionPercent\": null"), std::string::npos);
  EXPECT_EQ(json.find("nan"), std::string::npos);
}
