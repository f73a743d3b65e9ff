// SPDX-License-Identifier: GPL-3.0-or-later
// ROIs of every type, alone and in archives, and what is damaged.
#include "Readers/ReaderTesting.h"
#include "Readers/TraceBuilder.h"

#include "ImageJ/ImageJOutline.h"
#include "ImageJ/ImageJParser.h"

#include <cmath>

using namespace readertesting;
using namespace tracebuilder;

namespace
{
const std::vector<std::pair<int, int>> Square{ { 10, 20 }, { 14, 20 }, { 14, 28 }, { 10, 28 } };

class ImageJParser : public Folder
{
protected:
  recon::TracedFile Read(const std::string& name, const std::string& bytes)
  {
    this->FileName = this->Write(name, bytes);
    return recon::ReadImageJ(this->FileName, { 2, 0.5 }, this->Monitor);
  }
  void Fails(const std::string& bytes, const std::string& part)
  {
    ExpectSentence(SentenceOf([&] { this->Read("a.zip", bytes); }), this->FileName, part);
  }
  recon::Monitor Monitor;
  std::string FileName;
};
}

TEST_F(ImageJParser, ReadsASet)
{
  const recon::TracedFile file = this->Read("nuclei.zip",
    ZIP({ { "a.roi", ROI(Square, 3, "first") }, { "0007-0012-0030.roi", ROI(Square, 0, "") },
      { "b.roi", ROI(Square, 0, "second", 7) }, { "read.me", "no ROI" } }));
  ASSERT_EQ(file.Objects.size(), 1u);
  const recon::TracedObject& object = file.Objects[0];
  EXPECT_EQ(object.Name, "nuclei");
  EXPECT_EQ(object.Slices, (std::vector<int>{ 3, 7, 1 }));
  EXPECT_EQ(object.Names, (std::vector<std::string>{ "first", "0007-0012-0030", "second" }));
  EXPECT_EQ(object.Soup.Points[2], (recon::Point3{ 7, 14, 4 })); // half a unit a pixel, third slice
  EXPECT_EQ(object.Color, (std::array<unsigned char, 3>{ 0, 0x80, 0xff }));
  EXPECT_TRUE(object.Soup.Chains[0].Closed);
  EXPECT_EQ(file.Report,
    (std::vector<std::string>{ "1 file of the archive left out, which are no ROIs.",
      "1 ROI on no slice in particular: taken as on the first." }));
  EXPECT_TRUE(recon::IsImageJ(this->FileName));
}

TEST_F(ImageJParser, MakesObjectsOfGroups)
{
  const recon::TracedFile file = this->Read("a.zip",
    ZIP({ { "a.roi", ROI(Square, 1, "a", 0, 2) }, { "b.roi", ROI(Square, 2, "b", 0, 2) },
      { "c.roi", ROI(Square, 2, "c") } }));
  ASSERT_EQ(file.Objects.size(), 2u);
  EXPECT_EQ(file.Objects[0].Name, "group 2");
  EXPECT_EQ(file.Objects[0].Soup.Chains.size(), 2u);
  EXPECT_EQ(file.Objects[1].Name, "a");
}

TEST_F(ImageJParser, KnowsEveryType)
{
  const auto lines = [](const std::string& bytes)
  { return recon::ReadOutline("a.roi", bytes).Lines; };
  EXPECT_EQ(lines(ROI({}, 1, "box", 1)).at(0).Points,
    (std::vector<recon::Point2>{ { 10, 20 }, { 14, 20 }, { 14, 28 }, { 10, 28 } }));
  const auto oval = lines(ROI({}, 1, "oval", 2)).at(0);
  EXPECT_TRUE(oval.Closed);
  for (const recon::Point2& p : oval.Points)
  {
    EXPECT_NEAR(std::pow((p[0] - 12) / 2, 2) + std::pow((p[1] - 24) / 4, 2), 1, 1e-12);
  }
  EXPECT_FALSE(lines(ROI(Square, 1, "polyline", 5)).at(0).Closed);
  EXPECT_EQ(lines(ROI(Square, 1, "points", 10)).size(), 4u);
  // In single precision, all x and then all y stand behind the whole ones.
  BigEndian fine;
  fine.Content = ROI({ { 10, 20 }, { 11, 20 }, { 11, 21 } }, 1, "");
  fine.Content.resize(64 + 12);
  for (const float x : { 10.25f, 11.5f, 11.5f, 20.125f, 20.f, 21.f })
  {
    fine.Float(x);
  }
  fine.Put(50, BigEndian().Int(128, 2).Content);
  fine.Put(60, BigEndian().Int(0).Content);
  EXPECT_EQ(lines(fine.Content).at(0).Points[0], (recon::Point2{ 10.25, 20.125 }));
}

TEST_F(ImageJParser, ReadsCompositeOutlines)
{
  BigEndian shape;
  shape.Content = ROI({}, 1, "", 1);
  shape.Content.resize(64);
  std::vector<float> numbers{ 0, 0, 0, 1, 4, 0, 1, 4, 4, 4, 0, 1, 1, 2, 2, 2, 3, 1, 4 };
  shape.Put(36, BigEndian().Int(static_cast<std::int64_t>(numbers.size())).Content);
  shape.Put(60, BigEndian().Int(0).Content);
  for (const float number : numbers)
  {
    shape.Float(number);
  }
  const auto lines = recon::ReadOutline("a.roi", shape.Content).Lines;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].Points.size(), 3u);
  EXPECT_EQ(lines[1].Points.size(), 9u);
  EXPECT_EQ(lines[1].Points[4], (recon::Point2{ 2, 1.5 })); // the middle of the curve
}

TEST_F(ImageJParser, LosesOnlyWhatIsDamaged)
{
  const std::string whole = ROI(Square, 1, "a");
  const recon::TracedFile file = this->Read("a.zip",
    ZIP({ { "good.roi", whole }, { "short.roi", whole.substr(0, 70) }, { "none.roi", "Iouch" } }));
  EXPECT_EQ(file.Objects[0].Soup.Chains.size(), 1u);
  ASSERT_EQ(file.Report.size(), 2u);
  EXPECT_NE(
    file.Report[0].find("short.roi, byte 64: the ROI announces 4 points"), std::string::npos);
  EXPECT_NE(file.Report[1].find("none.roi, byte 0: expected an ROI"), std::string::npos);
}

TEST_F(ImageJParser, SaysWhatIsWrong)
{
  const std::string archive = ZIP({ { "good.roi", ROI(Square, 1, "a") } });
  this->Fails(archive.substr(0, 60), "no directory at its end; it is truncated");
  this->Fails("no ROI at all", "expected an ROI of ImageJ");
  this->Fails(ZIP({ { "a.txt", "text" } }), "it holds no contours");
  std::string damaged = archive;
  damaged.replace(damaged.find("PK\x01\x02"), 4, "PKxx");
  this->Fails(damaged, "entry 1 of 1 of the archive's directory is damaged");
}

TEST_F(ImageJParser, ArchivesUnpackWithinABound)
{
  const std::string archive = ZIP({ { "good.roi", ROI(Square, 1, "a") } });
  const std::size_t directory = archive.find("PK\x01\x02");
  const std::size_t end = archive.find("PK\x05\x06");
  // The same bytes a thousand times, under a thousand entries.
  std::string shared = archive.substr(0, end);
  for (int i = 1; i < 1000; ++i)
  {
    shared += archive.substr(directory, end - directory);
  }
  std::string tail = archive.substr(end);
  tail.replace(10, 2, "\xe8\x03"); // 1000 entries
  this->Fails(shared + tail, "tells of more bytes than there are; it is damaged");
  std::string bomb = archive;
  bomb.replace(directory + 10, 1, "\x08");             // deflated
  bomb.replace(directory + 24, 4, "\x01\x01\x01\x0f"); // 250 MB
  this->Fails(bomb, "unpacks to more than 64 times its size");
}
