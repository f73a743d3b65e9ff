// SPDX-License-Identifier: GPL-3.0-or-later
// Models made by the layout of IMOD's documentation: every kind of object, and what is damaged.
#include "Readers/ReaderTesting.h"
#include "Readers/TraceBuilder.h"

#include "IMOD/IMODParser.h"

using namespace readertesting;
using namespace tracebuilder;

namespace
{
const std::vector<recon::Point3> Square{ { 0, 0, 4 }, { 8, 0, 4 }, { 8, 8, 4 }, { 0, 8, 4 } };
constexpr std::uint32_t Open = 1u << 3;
constexpr std::uint32_t Scattered = 1u << 9;

class IMODParser : public Folder
{
protected:
  recon::TracedFile Read(const std::string& bytes)
  {
    this->FileName = this->Write("model.mod", bytes);
    return recon::ReadIMOD(this->FileName, this->Monitor);
  }
  void Fails(const std::string& bytes, const std::string& part)
  {
    ExpectSentence(SentenceOf([&] { this->Read(bytes); }), this->FileName, part);
  }
  recon::Monitor Monitor;
  std::string FileName;
};
}

TEST_F(IMODParser, ReadsObjectsInTheirUnit)
{
  const recon::TracedFile file =
    this->Read(IMODHeader(3) + IMODObject("axon", 2) + IMODContour(Square) + "LABL" +
      std::string("\0\0\0\2ab", 6) + IMODContour(Square, Open) + IMODObject("spots", 1, Scattered) +
      IMODContour(Square) + IMODObject("axon", 1, Open) + IMODContour(Square) + "MESH" +
      BigEndian().Int(1).Int(2).Ints(0, 2).Ints(0, 5).Content + "IEOF");
  ASSERT_EQ(file.Objects.size(), 3u);
  EXPECT_EQ(file.LengthUnit, "nm");
  EXPECT_TRUE(file.Report.empty());
  const recon::TracedObject& axon = file.Objects[0];
  EXPECT_EQ(axon.Name, "axon");
  EXPECT_EQ(axon.Color, (std::array<unsigned char, 3>{ 255, 128, 0 }));
  ASSERT_EQ(axon.Soup.Chains.size(), 2u);
  EXPECT_TRUE(axon.Soup.Chains[0].Closed);
  EXPECT_FALSE(axon.Soup.Chains[1].Closed);
  EXPECT_EQ(axon.Soup.Points[2], (recon::Point3{ 20, 20, 30 })); // 2.5 nm, z three times as high
  EXPECT_EQ(axon.Slices[0], 4);
  EXPECT_EQ(file.Objects[1].Soup.Chains.size(), 4u); // points
  EXPECT_EQ(file.Objects[2].Name, "axon (object 3)");
  EXPECT_FALSE(file.Objects[2].Soup.Chains[0].Closed);
  EXPECT_TRUE(recon::IsIMOD(this->FileName));
}

TEST_F(IMODParser, KnowsUnits)
{
  const std::string rest = IMODObject("a", 1) + IMODContour(Square) + "IEOF";
  const recon::TracedFile angstrom = this->Read(IMODHeader(1, -10) + rest);
  EXPECT_EQ(angstrom.LengthUnit, "nm");
  EXPECT_NEAR(angstrom.Objects[0].Soup.Points[1][0], 2, 1e-12);
  const recon::TracedFile pixels = this->Read(IMODHeader(1, 0) + rest);
  EXPECT_EQ(pixels.LengthUnit, "");
  EXPECT_EQ(pixels.Objects[0].Soup.Points[1][0], 8);
  EXPECT_NE(pixels.Report.at(0).find("no pixel size"), std::string::npos);
}

TEST_F(IMODParser, SaysWhatCountsDisagree)
{
  const recon::TracedFile file =
    this->Read(IMODHeader(2) + IMODObject("a", 7) + IMODContour(Square) + "IEOF");
  ASSERT_EQ(file.Report.size(), 2u);
  EXPECT_EQ(file.Report[0], "\"a\" announces 7 contours, and has 1.");
  EXPECT_EQ(file.Report[1], "The model announces 2 objects, and has 1.");
}

TEST_F(IMODParser, SaysWhatIsDamaged)
{
  const std::string whole = IMODHeader(1) + IMODObject("a", 1) + IMODContour(Square) + "IEOF";
  this->Fails("imod 1\nobject 0 1 0\n", "does not begin with IMODV1.2");
  this->Fails(whole.substr(0, 100), "the file ends within the header");
  this->Fails(whole.substr(0, whole.size() - 30), "more than the rest of the file can hold");
  this->Fails(whole.substr(0, whole.size() - 4), "without its end mark");
  this->Fails(IMODHeader(1) + IMODContour(Square) + "IEOF", "before any object");
  this->Fails(IMODHeader(1) + "\1\2\3\4....", "expected the name of a chunk");
  this->Fails(IMODHeader(0) + "IEOF", "it holds no contours");
  this->Fails("", "does not begin");
}
