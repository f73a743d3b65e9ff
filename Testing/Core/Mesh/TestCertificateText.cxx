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

namespace
{
std::map<std::string, std::string> LinesByName(const std::vector<CertificateLine>& lines)
{
  std::map<std::string, std::string> map;
  for (const auto& line : lines)
  {
    EXPECT_TRUE(map.emplace(line.Figure, line.Value).second) << line.Figure << " twice";
  }
  return map;
}
}

TEST(CertificateText, LinesBeginWithTheVerdictAndTheVolume)
{
  const ContourSet contours = MakeSquareLevel(0.5, 0.25);
  const SurfaceCertificate certificate = CertifyMesh(MakeCube(), &contours);
  const auto lines = ListLines(certificate, true, true);
  EXPECT_EQ(lines[0].Figure, "Verdict");
  EXPECT_EQ(lines[0].Value, "sound");
  EXPECT_EQ(lines[2].Figure, "Volume, cm3");
  EXPECT_EQ(lines[2].Value, "0.001");
  auto map = LinesByName(lines);
  EXPECT_EQ(map["Area, cm2"], "0.06");
  EXPECT_EQ(map["Farthest contour point, mm"], "0.25");
  EXPECT_EQ(map["Worst section, %"], "50");
  EXPECT_EQ(map["Tunnels"], "0");
  EXPECT_EQ(ToVerdict(certificate, true), "sound, 0.001 cm3");
  EXPECT_EQ(ToVerdict(certificate, false), "sound, volume 1");
  EXPECT_EQ(ListLines(certificate, false, false)[2].Value, "1");
}

TEST(CertificateText, LinesOfWhatHasNoVolume)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  mesh.Triangles.pop_back();
  const SurfaceCertificate certificate = CertifyMesh(mesh);
  auto map = LinesByName(ListLines(certificate, true, true));
  EXPECT_EQ(map["Verdict"], "NOT sound");
  EXPECT_EQ(map["Found"], "3 open edges");
  EXPECT_EQ(map["Volume, cm3"], "-");
  EXPECT_EQ(map["Tunnels"], "-");
  EXPECT_EQ(map["Farthest contour point, mm"], "-");
  EXPECT_EQ(ToVerdict(certificate, true), "NOT sound (3 open edges), no volume");
  // The same figures in the same order, whatever the surface is worth.
  const auto none = ListLines(CertifyMesh(TriangleMesh()), true, true);
  const auto some = ListLines(certificate, true, true);
  ASSERT_EQ(none.size(), some.size());
  for (std::size_t i = 0; i < none.size(); ++i)
  {
    EXPECT_EQ(none[i].Figure, some[i].Figure);
  }
  EXPECT_EQ(none[0].Value, "no surface");
  EXPECT_EQ(ToVerdict(CertifyMesh(TriangleMesh()), true), "no surface");
}
