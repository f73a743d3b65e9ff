// SPDX-License-Identifier: GPL-3.0-or-later
// Other people's structure sets that once came out wrong: the rows of the shared data's list of
// faults that are the parser's.
#include "Readers/ReaderTesting.h"

#include "DICOM/StructureSetFile.h"

using namespace readertesting;

namespace
{
/// "Name: contours", an ROI each, and the lines of the report below.
std::vector<std::string> ContentsOf(const std::string& fileName, std::vector<std::string>& report)
{
  recon::Monitor monitor;
  recon::StructureSetFile file(fileName);
  report = file.GetReport();
  std::vector<std::string> contents;
  for (std::size_t i = 0; i < file.GetROIs().size(); ++i)
  {
    const recon::StructureSetContours contours = file.ReadContours(static_cast<int>(i), monitor);
    contents.push_back(
      file.GetROIs()[i].Name + ": " + std::to_string(contours.File.Soup.Chains.size()));
    report.insert(report.end(), contours.File.Report.begin(), contours.File.Report.end());
  }
  return contents;
}

using Lines = std::vector<std::string>;
}

TEST(StructureSetFaults, MalformedNumber)
{
  const std::string fileName = Shared("faults/rt/malformed_nan.dcm");
  CONTOUR_SKIP_UNLESS(fileName);
  Lines report;
  EXPECT_EQ(ContentsOf(fileName, report), (Lines{ "Good: 11", "Bad: 10", "Other: 11" }));
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0].rfind("ROI \"Bad\", contour 6: left out, expected a number", 0), 0u)
    << report[0];
}

TEST(StructureSetFaults, LastBackslash)
{
  const std::string fileName = Shared("faults/rt/malformed_trail.dcm");
  CONTOUR_SKIP_UNLESS(fileName);
  Lines report;
  EXPECT_EQ(ContentsOf(fileName, report), (Lines{ "Good: 11", "Bad: 11", "Other: 11" }));
  EXPECT_TRUE(report.empty());
}

TEST(StructureSetFaults, NumberUsedTwice)
{
  const std::string fileName = Shared("faults/rt/dupnum.dcm");
  CONTOUR_SKIP_UNLESS(fileName);
  Lines report;
  EXPECT_EQ(ContentsOf(fileName, report), (Lines{ "Heart: 11", "Lung: 0", "New1: 11", "New2: 0" }));
  ASSERT_EQ(report.size(), 3u);
  EXPECT_EQ(report[0].rfind("The ROIs \"Lung\", \"New2\" have one number, 19", 0), 0u) << report[0];
}

TEST(StructureSetFaults, TruncatedFile)
{
  const std::string fileName = Shared("faults/rt/truncated.dcm");
  CONTOUR_SKIP_UNLESS(fileName);
  ExpectSentence(
    SentenceOf([&] { recon::StructureSetFile file(fileName); }), fileName, "truncated");
}

TEST(StructureSetFaults, OpenContoursAndPoints)
{
  const std::string fileName = Shared("faults/rt/open/set.dcm");
  CONTOUR_SKIP_UNLESS(fileName);
  Lines report;
  EXPECT_EQ(
    ContentsOf(fileName, report), (Lines{ "HR-CTV: 11", "tandem: 1", "Points: 2", "wire: 1" }));
  EXPECT_TRUE(report.empty());
}

TEST(StructureSetFaults, JapaneseNames)
{
  const std::string fileName = Shared("faults/rt/names_jis.dcm");
  CONTOUR_SKIP_UNLESS(fileName);
  Lines report;
  EXPECT_EQ(ContentsOf(fileName, report), (Lines{ "左肺: 11", "心臓: 11" }));
  EXPECT_TRUE(report.empty());
}

TEST(StructureSetFaults, NoExtension)
{
  const std::string fileName = Shared("faults/rt/no_extension/RS.1.2.3");
  CONTOUR_SKIP_UNLESS(fileName);
  EXPECT_TRUE(recon::StructureSetFile::IsStructureSet(fileName));
  Lines report;
  EXPECT_EQ(ContentsOf(fileName, report), (Lines{ "Heart: 11" }));
}

TEST(StructureSetFaults, FramesOfReference)
{
  const std::string fileName = Shared("faults/rt/frames/set.dcm");
  CONTOUR_SKIP_UNLESS(fileName);
  const recon::StructureSetFile file(fileName);
  const std::string first = "1.2.826.0.1.3680043.8.498.1";
  const std::string second = "1.2.826.0.1.3680043.8.498.77";
  const std::vector<std::string> expected{ first, second, second, first };
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_EQ(file.GetROIs()[i].FrameOfReferenceUID, expected[i]) << file.GetROIs()[i].Name;
  }
}
