// SPDX-License-Identifier: GPL-3.0-or-later
// Tables as people have them, and what is damaged.
#include "Readers/ReaderTesting.h"

#include "Table/ContourTableParser.h"
#include "Table/TableColumns.h"

using namespace readertesting;

namespace
{
class ContourTableParser : public Folder
{
protected:
  recon::TracedFile Read(const std::string& text)
  {
    this->FileName = this->Write("table.csv", text);
    return recon::ReadContourTable(this->FileName, { 2, 1 }, this->Monitor);
  }
  void Fails(const std::string& text, const std::string& part)
  {
    ExpectSentence(SentenceOf([&] { this->Read(text); }), this->FileName, part);
  }
  /// How many points each contour of the only object has.
  std::vector<std::size_t> Counts(const std::string& text)
  {
    const recon::TracedFile file = this->Read(text);
    EXPECT_EQ(file.Objects.size(), 1u);
    std::vector<std::size_t> counts;
    for (const auto& chain : file.Objects.at(0).Soup.Chains)
    {
      EXPECT_TRUE(chain.Closed);
      counts.push_back(chain.Points.size());
    }
    return counts;
  }
  using Sizes = std::vector<std::size_t>;
  recon::Monitor Monitor;
  std::string FileName;
};
}

TEST_F(ContourTableParser, ReadsNamedColumns)
{
  const recon::TracedFile file = this->Read(
    "\xEF\xBB\xBF# made by hand\r\nROI;Slice;Contour ID;Y (mm);X (mm)\r\n"
    "Heart;4;1;0,5;1\r\nHeart;4;1;0;2\r\nHeart;4;1;1;2\r\nLung;5;1;0;0\r\nLung;5;1;0;3\r\n");
  ASSERT_EQ(file.Objects.size(), 2u);
  EXPECT_EQ(file.LengthUnit, "mm");
  EXPECT_EQ(file.Objects[0].Name, "Heart");
  EXPECT_EQ(file.Objects[0].Soup.Points[0], (recon::Point3{ 1, 0.5, 8 })); // slice 4, 2 apart
  EXPECT_EQ(file.Objects[1].Slices, (std::vector<int>{ 5 }));
  EXPECT_TRUE(recon::IsContourTable(this->FileName));
}

TEST_F(ContourTableParser, FindsContoursWithoutNumbers)
{
  EXPECT_EQ(this->Counts("0 0 0\n1 0 0\n1 1 0\n\n4 0 0\n5 0 0\n5 1 0\n0 0 1\n1 0 1\n1 1 1\n"),
    (Sizes{ 3, 3, 3 }));
  EXPECT_EQ(this->Counts("x,y,z\n0,0,0\n1,0,0\n1,1,0\n0,0,0\n4,0,0\n5,0,0\n5,1,0\n4,0,0\n"),
    (Sizes{ 4, 4 }));
  EXPECT_EQ(
    this->Counts("0\t0\t0\t1\n1\t0\t0\t1\n1\t1\t0\t1\n4\t0\t0\t2\n5\t0\t0\t2\n5\t1\t0\t2\n"),
    (Sizes{ 3, 3 }));
}

TEST_F(ContourTableParser, SplitsNumbersThatBeginAnew)
{
  const recon::TracedFile file =
    this->Read("x,y,z,id\n0,0,0,1\n1,0,0,1\n1,1,0,1\n0,0,5,1\n1,0,5,1\n1,1,5,1\n");
  EXPECT_EQ(file.Objects[0].Soup.Chains.size(), 2u);
  EXPECT_EQ(file.Report,
    (std::vector<std::string>{
      "1 contour of one number at several z: taken as a contour at each z." }));
  // A contour of an oblique plane stays one.
  EXPECT_EQ(this->Counts("x,y,z,id\n0,0,0,1\n1,0,1,1\n1,1,1,1\n0,1,0,1\n"), (Sizes{ 4 }));
}

TEST_F(ContourTableParser, SaysWhatIsWrong)
{
  this->Fails("x,y,z\n0,0,0\n1,zero,0\n", "line 3: expected a number for y, found 'zero'");
  this->Fails("x,y,z\n0,0\n", "line 2: expected 3 columns, found 2");
  this->Fails("name,value\na,1\n", "line 1: expected names of columns, x and y among them");
  this->Fails("x,y\n0,0\n", "neither a column z nor one for the slice");
  this->Fails("", "it holds no contours");
  this->Fails("x,y,z\n", "it holds no contours");
  this->Fails(std::string("x,y,z\n0,0,\0\n", 12), "this is a binary file");
  this->Fails("x,y,z\n0,0,nan\n", "expected a number for z");
  EXPECT_FALSE(recon::IsContourTable(this->Write("points.csv", "x,y,z\n1,2,3\n")));
}

TEST(TableColumns, SplitsRows)
{
  EXPECT_EQ(
    recon::SplitRow("\"a, b\", 1 ,2\r", ','), (std::vector<std::string>{ "a, b", "1", "2" }));
  EXPECT_EQ(recon::SplitRow("  1   2 3 ", ' '), (std::vector<std::string>{ "1", "2", "3" }));
  EXPECT_EQ(recon::SeparatorOf("1,5;2"), ';');
}
