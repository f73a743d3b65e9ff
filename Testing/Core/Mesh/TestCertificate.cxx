// SPDX-License-Identifier: GPL-3.0-or-later
#include "Mesh/Certificate.h"
#include "Mesh/MeshDefects.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <map>

using namespace recon;
using namespace recon::testing;

namespace
{
SurfaceCertificate CertifyMesh(const TriangleMesh& mesh, const ContourSet* contours = nullptr,
  CertificateOptions options = CertificateOptions())
{
  Monitor monitor;
  return Certify(mesh, contours, options, monitor);
}

std::map<std::string, std::optional<double>> ByName(const std::vector<CertificateFigure>& figures)
{
  std::map<std::string, std::optional<double>> map;
  for (const auto& figure : figures)
  {
    EXPECT_TRUE(map.emplace(figure.Name, figure.Value).second) << figure.Name << " twice";
  }
  return map;
}

ContourSet MakeSquareLevel(double offset, double x)
{
  ContourSet set;
  set.Levels.emplace_back();
  set.Levels.back().Offset = offset;
  set.Levels.back().Contours = { 0 };
  Contour contour;
  contour.Level = 0;
  for (const auto& p : { Point2{ 0, 0 }, Point2{ 1, 0 }, Point2{ 1, 1 }, Point2{ 0, 1 } })
  {
    contour.Points.push_back(static_cast<int>(set.Points.size()));
    set.Points.push_back({ p[0] + x, p[1], offset });
    set.Planar.push_back({ p[0] + x, p[1] });
  }
  set.Contours.push_back(contour);
  return set;
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

TEST(Certificate, SoundCube)
{
  const ContourSet contours = MakeSquareLevel(0.5, 0);
  const SurfaceCertificate certificate = CertifyMesh(MakeCube(), &contours);
  EXPECT_TRUE(certificate.Total.IsSound());
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

TEST(Certificate, ComponentsAreJudgedApart)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 2, 2, 2 });
  Append(mesh, MakeBox({ 1, 0.5, 0.25 }, { 3, 1.5, 1.125 })); // crosses the first
  Append(mesh, MakeBox({ 5, 5, 5 }, { 6, 6, 6 }));
  TriangleMesh open = MakeBox({ 8, 8, 8 }, { 9, 9, 9 });
  open.Triangles.pop_back();
  Append(mesh, open);
  const SurfaceCertificate certificate = CertifyMesh(mesh);
  ASSERT_EQ(certificate.Components.size(), 4u);
  const auto& parts = certificate.Components;
  EXPECT_GT(certificate.Total.Pairs.Crossing, 0);
  EXPECT_EQ(parts[0].Pairs.Crossing, certificate.Total.Pairs.Crossing);
  EXPECT_EQ(parts[1].Pairs.Crossing, certificate.Total.Pairs.Crossing);
  EXPECT_EQ(parts[2].Pairs.Crossing, 0);
  EXPECT_TRUE(parts[2].IsSound());
  EXPECT_FALSE(parts[0].IsSound());
  EXPECT_FALSE(parts[3].IsSound());
  EXPECT_FALSE(parts[3].Mass.Volume.has_value());
  EXPECT_FALSE(certificate.Total.Mass.Volume.has_value());
  EXPECT_EQ(parts[2].Mass.Volume.value(), 1);
  EXPECT_EQ(certificate.ComponentOfTriangle.back(), 3);
  EXPECT_NE(certificate.DefectOfTriangle.front() | certificate.DefectOfTriangle[11], 0);
  EXPECT_EQ(certificate.DefectOfTriangle[25], 0);
  const auto text = ToShortText(certificate);
  EXPECT_TRUE(Contains(text, "Not sound: not closed, manifold, oriented."));
  EXPECT_TRUE(Contains(text, "3 open edges"));
  EXPECT_TRUE(Contains(text, "no volume"));
}

TEST(Certificate, WeldedTopologyIsToldApart)
{
  TriangleMesh mesh = MakeBox({ 0, 0, 0 }, { 1, 1, 1 });
  Append(mesh, MakeBox({ 1, 1, 0 }, { 2, 2, 1 }));
  const SurfaceCertificate asIs = CertifyMesh(mesh);
  EXPECT_TRUE(asIs.Total.IsSound());
  EXPECT_GT(asIs.Total.Pairs.Touching, 0);
  EXPECT_EQ(asIs.Welded.OverusedEdges, 1);
  CertificateOptions options;
  options.Weld = true;
  const SurfaceCertificate welded = CertifyMesh(mesh, nullptr, options);
  EXPECT_EQ(welded.Total.Topology.OverusedEdges, 1);
  EXPECT_EQ(welded.Components.size(), 1u);
}

TEST(Certificate, ContoursThatMissAreMeasured)
{
  const ContourSet contours = MakeSquareLevel(0.5, 0.25);
  const SurfaceCertificate certificate = CertifyMesh(MakeCube(), &contours);
  EXPECT_DOUBLE_EQ(certificate.WorstSectionPercent().value(), 50);
  EXPECT_DOUBLE_EQ(certificate.Distance->FarthestVertex, 0.25);
  EXPECT_TRUE(Contains(ToShortText(certificate), "50 %"));
}

TEST(Certificate, JsonSaysNullWhereThereIsNothingToSay)
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

TEST(Certificate, OfNothing)
{
  const SurfaceCertificate certificate = CertifyMesh(TriangleMesh());
  EXPECT_FALSE(certificate.Total.IsSound());
  EXPECT_TRUE(certificate.Components.empty());
  EXPECT_EQ(ToShortText(certificate), std::vector<std::string>{ "There is no surface." });
}

TEST(Certificate, ProgressRisesAndAbortIsHeard)
{
  struct : Monitor
  {
    void OnProgress(double fraction, const char*) override
    {
      EXPECT_GE(fraction, this->Last);
      EXPECT_LE(fraction, 1);
      this->Last = fraction;
    }
    bool AbortRequested() override { return this->Last >= this->StopAt; }
    double Last = 0;
    double StopAt = 2;
  } monitor;
  const ContourSet contours = MakeSquareLevel(0.5, 0);
  Certify(MakeSphere(40, 20), &contours, CertificateOptions(), monitor);
  EXPECT_EQ(monitor.Last, 1);
  for (const double stopAt : { 0.0, 0.5, 0.9 })
  {
    monitor.Last = 0;
    monitor.StopAt = stopAt;
    EXPECT_THROW(Certify(MakeSphere(40, 20), &contours, CertificateOptions(), monitor), Aborted);
  }
}
