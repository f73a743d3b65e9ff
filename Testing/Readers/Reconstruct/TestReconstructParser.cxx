// SPDX-License-Identifier: GPL-3.0-or-later
// Series of Reconstruct and PyReconstruct: places, sections that are damaged, every layout of the JSON file.
#include "Readers/ReaderTesting.h"
#include "Readers/TraceBuilder.h"

#include "Reconstruct/ReconstructParser.h"

using namespace readertesting;
using namespace tracebuilder;

namespace
{
class ReconstructParser : public Folder
{
protected:
  recon::TracedFile Read(const std::string& name, const std::string& text)
  {
    this->FileName = this->Write(name, text);
    return recon::ReadReconstruct(this->FileName, this->Monitor);
  }
  void Fails(const std::string& name, const std::string& text, const std::string& part)
  {
    ExpectSentence(SentenceOf([&] { this->Read(name, text); }), this->FileName, part);
  }
  recon::Monitor Monitor;
  std::string FileName;
};
}

TEST_F(ReconstructParser, PlacesSections)
{
  this->Write("cell.1", SectionFile(1, NoTransform, "0 0, 1 0, 1 1,"));
  // x = 1 + 2 X, so that X = (x - 1) / 2; y = Y + 3.
  this->Write("cell.3",
    SectionFile(3, "dim=\"3\" xcoef=\"1 2 0 0 0 0\" ycoef=\"3 0 1 0 0 0\"", "1 3, 3 3, 3 4,",
      "<Contour name=\"open\" closed=\"false\" points=\"1 3, 3 3,\"/>\n"));
  this->Write("cell.txt", "no section");
  const recon::TracedFile file = this->Read("cell.ser", SeriesFile);
  ASSERT_EQ(file.Objects.size(), 2u);
  EXPECT_EQ(file.LengthUnit, "um");
  const recon::TracedObject& star = file.Objects[0];
  EXPECT_EQ(star.Name, "star"); // the image's own border is none
  EXPECT_EQ(star.Color, (std::array<unsigned char, 3>{ 255, 128, 0 }));
  EXPECT_EQ(star.Slices, (std::vector<int>{ 1, 3 }));
  ASSERT_EQ(star.Soup.Points.size(), 6u);
  EXPECT_NEAR(star.Soup.Points[0][2], 0.05, 1e-12);
  EXPECT_NEAR(star.Soup.Points[3][2], 0.15, 1e-12);
  EXPECT_NEAR(star.Soup.Points[4][0], 1, 1e-12);
  EXPECT_NEAR(star.Soup.Points[5][1], 1, 1e-12);
  EXPECT_FALSE(file.Objects[1].Soup.Chains[0].Closed);
  EXPECT_EQ(file.Report,
    (std::vector<std::string>{
      "1 trace of the series left out: they run across sections, and are no contours." }));
}

TEST_F(ReconstructParser, SolvesPolynomials)
{
  // A place (2, 3) has the coordinates that the polynomials give there.
  const double x = 0.1 + 1.02 * 2 + 0.01 * 3 + 0.002 * 6 + 0.003 * 4 + 0.001 * 9;
  const double y = -0.2 + 0.02 * 2 + 0.98 * 3 - 0.001 * 6 + 0.002 * 4 - 0.003 * 9;
  this->Write("p.0",
    SectionFile(0,
      "dim=\"6\" xcoef=\"0.1 1.02 0.01 0.002 0.003 0.001\" ycoef=\"-0.2 0.02 0.98 -0.001 0.002 "
      "-0.003\"",
      std::to_string(x) + " " + std::to_string(y)));
  const recon::TracedFile file = this->Read("p.ser", SeriesFile);
  EXPECT_NEAR(file.Objects[0].Soup.Points[0][0], 2, 2e-6);
  EXPECT_NEAR(file.Objects[0].Soup.Points[0][1], 3, 2e-6);
}

TEST_F(ReconstructParser, LosesOnlyWhatIsDamaged)
{
  this->Write("s.1", SectionFile(1, NoTransform, "0 0, 1 0, 1 1,"));
  this->Write("s.2", "<Section index=\"2\" thickness=\"0.05\">");
  this->Write("s.3", SectionFile(3, NoTransform, "0 0, 1 zero,"));
  this->Write(
    "s.4", SectionFile(4, "dim=\"3\" xcoef=\"0 0 0 0 0 0\" ycoef=\"0 0 1 0 0 0\"", "0 0, 1 1,"));
  this->Write("s.5", SectionFile(1, NoTransform, "0 0, 1 0, 1 1,"));
  const recon::TracedFile file = this->Read("s.ser", SeriesFile);
  EXPECT_EQ(file.Objects[0].Slices, (std::vector<int>{ 1 }));
  ASSERT_EQ(file.Report.size(), 5u);
  EXPECT_NE(file.Report[0].find("s.2, line 1: it is no well-formed XML"), std::string::npos);
  EXPECT_NE(
    file.Report[1].find("points of trace 'star' are no pairs of numbers"), std::string::npos);
  EXPECT_NE(file.Report[2].find("index 1 is that of another file as well"), std::string::npos);
  EXPECT_NE(file.Report[4].find("1 trace left out: the transform"), std::string::npos);
}

TEST_F(ReconstructParser, ReadsEveryLayoutOfJSON)
{
  const recon::TracedFile newest = this->Read("a.jser", JSONSeries);
  ASSERT_EQ(newest.Objects.size(), 2u);
  EXPECT_EQ(newest.Objects[0].Soup.Points[1], (recon::Point3{ 3, -1, 0.1 }));
  EXPECT_EQ(newest.Objects[0].Color, (std::array<unsigned char, 3>{ 255, 128, 0 }));
  EXPECT_FALSE(newest.Objects[1].Soup.Chains[0].Closed);
  const std::string section =
    "{\"tforms\": {\"default\": [1, 0, 0, 0, 1, 0], \"other\": [1, 0, 5, 0, 1, 0]}, \"thickness\": "
    "1, "
    "\"contours\": {\"n\\u00e9\": [{\"x\": [0, 1, 1], \"y\": [0, 0, 1], \"closed\": true}]}}";
  const recon::TracedFile list = this->Read(
    "b.jser", "{\"sections\": [null, " + section + "], \"series\": {\"alignment\": \"other\"}}");
  EXPECT_EQ(list.Objects[0].Name, "n\xc3\xa9");
  EXPECT_EQ(list.Objects[0].Soup.Points[0], (recon::Point3{ 5, 0, 1 }));
  const recon::TracedFile oldest =
    this->Read("c.jser", "{\"c.2\": " + section + ", \"c.ser\": {\"alignment\": \"default\"}}");
  EXPECT_EQ(oldest.Objects[0].Soup.Points[2], (recon::Point3{ 1, 1, 2 }));
  EXPECT_TRUE(recon::IsReconstruct(this->FileName));
}

TEST_F(ReconstructParser, SaysWhatIsWrong)
{
  this->Fails("a.ser", SeriesFile, "no section files beside it (a.1 and so on)");
  this->Fails("a.ser", "S 2\nv 3 z 0", "it is no series file");
  this->Fails("a.jser", "{\"sections\": {}}", "it holds no contours");
  this->Fails("a.jser", "{\"sections\": [", "found the end of the file");
  this->Fails("a.jser", std::string(200, '[').insert(0, "{\"a\": "), "nested more than 64 deep");
  this->Fails("a.jser", "{\"sections\": [1 2]}", "expected ',' or ']', found '2'");
  const recon::TracedFile file = this->Read("b.jser",
    std::string(JSONSeries).replace(std::string(JSONSeries).find("[0, 1, 1]"), 9, "[0, 1]"));
  EXPECT_EQ(file.Report,
    (std::vector<std::string>{ "1 trace left out: not as many x as y, or no numbers." }));
}
