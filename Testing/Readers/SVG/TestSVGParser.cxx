// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings: shapes, paths and transforms against what they draw; slices by file and by layer.
#include "Readers/ReaderTesting.h"

#include "SVG/SVGParser.h"
#include "SVG/SVGPath.h"

#include <algorithm>
#include <cmath>

using namespace readertesting;

namespace
{
std::string Drawing(const std::string& content, const std::string& attributes = "")
{
  return "<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
         "xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" " +
    attributes + ">\n" + content + "\n</svg>\n";
}

std::vector<recon::SVGLine> Path(const std::string& data, bool whole = true)
{
  bool isWhole = false;
  auto lines = recon::ParsePath(data, isWhole);
  EXPECT_EQ(isWhole, whole) << data;
  return lines;
}

class SVGParser : public Folder
{
protected:
  recon::TracedFile Read(const std::string& text)
  {
    this->FileName = this->Write("drawing.svg", text);
    return recon::ReadSVG({ this->FileName }, { 3, 1 }, this->Monitor);
  }
  void Fails(const std::string& text, const std::string& part)
  {
    ExpectSentence(SentenceOf([&] { this->Read(text); }), this->FileName, part);
  }
  recon::Monitor Monitor;
  std::string FileName;
};
}

TEST(SVGPath, EndsAtNumbersThatNoLetterTakes)
{
  for (const char* data : { "M0 0L1 0 1 1z 2 3", "M0 0L1 0 1 1Z-1", "M0 0L1 0 1 1z.5z" })
  {
    EXPECT_EQ(Path(data, false).size(), 1u) << data;
  }
  EXPECT_TRUE(Path("1 2 3 4", false).empty());
}

TEST(SVGPath, ReadsLinesOfEveryKind)
{
  const std::vector<recon::Point2> square{ { 1, 1 }, { 4, 1 }, { 4, 5 }, { 1, 5 } };
  for (const char* data : { "M1 1H4V5H1Z", "m1,1 3,0 0,4 -3,0z", "M 1 1 L 4 1 4 5 1 5 z",
         "M1 1 h3v4-0h-3 Z", "M1,1l3,0l0,4l-3-0z" })
  {
    auto lines = Path(data);
    ASSERT_EQ(lines.size(), 1u) << data;
    EXPECT_TRUE(lines[0].Closed);
    auto& points = lines[0].Points;
    points.erase(std::unique(points.begin(), points.end()), points.end());
    EXPECT_EQ(points, square) << data;
  }
  const auto two = Path("M0 0L1 0 1 1ZM.5.5-1-1");
  ASSERT_EQ(two.size(), 2u);
  EXPECT_FALSE(two[1].Closed);
  EXPECT_EQ(two[1].Points, (std::vector<recon::Point2>{ { .5, .5 }, { -1, -1 } }));
}

TEST(SVGPath, FlattensCurves)
{
  // A quarter of a circle as everybody draws it, and an arc of it, and its two halves as a smooth pair.
  const double k = 0.5522847498;
  const std::string cubic = "M1 0C1 " + std::to_string(k) + " " + std::to_string(k) + " 1 0 1";
  for (const std::string& data :
    { cubic, std::string("M1 0A1 1 0 0 1 0 1"), std::string("M1 0a1 1 90 01-1 1") })
  {
    const auto lines = Path(data);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_GT(lines[0].Points.size(), 8u) << data;
    for (std::size_t i = 0; i + 1 < lines[0].Points.size(); ++i)
    {
      const recon::Point2 a = lines[0].Points[i];
      const recon::Point2 b = lines[0].Points[i + 1];
      EXPECT_NEAR(std::hypot(a[0], a[1]), 1, 1e-3) << data;
      EXPECT_NEAR(std::hypot(a[0] + b[0], a[1] + b[1]) / 2, 1, 2e-3) << data;
    }
    EXPECT_EQ(lines[0].Points.back(), (recon::Point2{ 0, 1 }));
  }
  const auto smooth = Path("M0 0Q1 1 2 0T4 0").at(0).Points;
  const auto lowest = std::min_element(
    smooth.begin(), smooth.end(), [](const auto& a, const auto& b) { return a[1] < b[1]; });
  EXPECT_NEAR((*lowest)[1], -0.5, 0.02); // the mirrored half bends the other way
}

TEST(SVGPath, EndsWhereDataDo)
{
  EXPECT_EQ(Path("M0 0L1 0L1 1L", false).at(0).Points.size(), 3u);
  EXPECT_EQ(Path("M0 0L1 0 X9 9", false).at(0).Points.size(), 2u);
  EXPECT_TRUE(Path("L1 1", false).empty());
  EXPECT_TRUE(Path("").empty());
}

TEST(SVGPath, KnowsTransforms)
{
  recon::SVGMatrix matrix{};
  ASSERT_TRUE(recon::ParseTransform("translate(10) rotate(90) scale(2,3)", matrix));
  const recon::Point2 p = recon::Apply(matrix, { 1, 1 });
  EXPECT_NEAR(p[0], 7, 1e-12);
  EXPECT_NEAR(p[1], 2, 1e-12);
  ASSERT_TRUE(recon::ParseTransform("rotate(180, 1, 2)", matrix));
  EXPECT_NEAR(recon::Apply(matrix, { 0, 0 })[1], 4, 1e-12);
  EXPECT_FALSE(recon::ParseTransform("turn(9)", matrix));
  EXPECT_FALSE(recon::ParseTransform("matrix(1 2 3)", matrix));
}

TEST_F(SVGParser, ReadsShapesInMillimetres)
{
  const recon::TracedFile file = this->Read(Drawing(
    "<g transform=\"translate(10,0)\"><rect x=\"1\" y=\"2\" width=\"3\" height=\"4\"/>"
    "<circle cx=\"5\" cy=\"5\" r=\"2\" inkscape:label=\"vessel\"/></g>"
    "<defs><rect width=\"9\" height=\"9\"/></defs><path d=\"M0 0L1 1\" style=\"display: none\"/>"
    "<text>no outline</text>",
    "width=\"20cm\" viewBox=\"0 0 100 100\""));
  ASSERT_EQ(file.Objects.size(), 2u);
  EXPECT_EQ(file.LengthUnit, "mm");
  EXPECT_EQ(file.Objects[0].Name, "drawing");
  EXPECT_EQ(file.Objects[0].Soup.Points[2], (recon::Point3{ 28, 12, 0 }));
  EXPECT_EQ(file.Objects[1].Name, "vessel");
  ASSERT_EQ(file.Report.size(), 2u);
  EXPECT_EQ(file.Report[0], "drawing.svg: 1 text, image or copy left out, which are no outlines.");
}

TEST_F(SVGParser, TakesLayersOrFilesAsSlices)
{
  const std::string square = "<rect width=\"1\" height=\"1\"/>";
  const std::string layer =
    "<g inkscape:groupmode=\"layer\" inkscape:label=\"slice\">" + square + "</g>";
  const recon::TracedFile layers = this->Read(Drawing(layer + layer + layer));
  ASSERT_EQ(layers.Objects.size(), 1u); // a layer's label is none of an object
  EXPECT_EQ(layers.Objects[0].Slices, (std::vector<int>{ 0, 1, 2 }));
  EXPECT_EQ(layers.Objects[0].Soup.Points[8][2], 6);
  const std::vector<std::string> names{ this->Write("1.svg", Drawing(square)),
    this->Write("2.svg", Drawing(layer + layer)) };
  const recon::TracedFile files = recon::ReadSVG(names, { -1, 2 }, this->Monitor);
  EXPECT_EQ(files.Objects[0].Slices, (std::vector<int>{ 0, 1, 1 }));
  EXPECT_EQ(files.Objects[0].Soup.Points[6], (recon::Point3{ 2, 2, -1 }));
  EXPECT_TRUE(recon::IsSVG(names[0]));
}

TEST_F(SVGParser, SaysWhatIsWrong)
{
  this->Fails("<html/>", "line 1: it is no drawing: its first element is 'html'");
  this->Fails(Drawing("<g>"), "it is no well-formed XML");
  this->Fails(Drawing("<g transform=\"turn(1)\"/>"), "transform 'turn(1)' is none that SVG knows");
  this->Fails(Drawing("<text>a</text>"), "it holds no contours");
  std::string deep;
  for (int i = 0; i < 1200; ++i)
  {
    deep += "<g>";
  }
  this->Fails(Drawing(deep), "nested more than 1000 deep");
}
