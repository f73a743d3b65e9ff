// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/StructureSetBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/StructureSetFile.h"

#include <map>
#include <ostream>

using namespace readertesting;

namespace
{
const char* const Triangle = "0\\0\\1\\ 4\\0\\1 \\4\\+3.5\\1e0";

class StructureSet : public Folder
{
protected:
  recon::StructureSetContours Contours(recon::StructureSetFile& file, int roi = 0)
  {
    return file.ReadContours(roi, this->Monitor);
  }
  recon::Monitor Monitor;
};

struct Expected
{
  const char* Name;
  std::size_t ROIs;
  std::size_t Contours;
  std::size_t Points;
};

/// The name of the test is that of the file.
void PrintTo(const Expected& expected, std::ostream* os)
{
  *os << expected.Name;
}

class RealStructureSet : public testing::TestWithParam<Expected>
{
};
}

TEST_F(StructureSet, HasNumberNameColourAndType)
{
  StructureSetBuilder builder;
  builder.AddROI(7, "Lung");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.AddROI(3, "PTV 60", "PTV");
  builder.Save(this->Name("a set.dcm"));
  recon::StructureSetFile file(this->Name("a set.dcm"));
  ASSERT_EQ(file.GetROIs().size(), 2u);
  const recon::StructureSetROI& lung = file.GetROIs()[0];
  EXPECT_EQ(lung.Number, 7);
  EXPECT_EQ(lung.Name, "Lung");
  EXPECT_EQ(lung.Type, "ORGAN");
  EXPECT_TRUE(lung.HasColor);
  EXPECT_EQ(lung.Color, (std::array<int, 3>{ 255, 128, 0 }));
  EXPECT_EQ(lung.NumberOfContours, 1);
  EXPECT_EQ(file.GetROIs()[1].Type, "PTV");
  EXPECT_EQ(file.GetROIs()[1].NumberOfContours, 0);
  EXPECT_TRUE(file.GetReport().empty());

  const recon::StructureSetContours contours = this->Contours(file);
  ASSERT_EQ(contours.File.Soup.Chains.size(), 1u);
  EXPECT_TRUE(contours.File.Soup.Chains[0].Closed);
  EXPECT_EQ(contours.File.Soup.Points,
    (std::vector<recon::Point3>{ { 0, 0, 1 }, { 4, 0, 1 }, { 4, 3.5, 1 } }));
  EXPECT_TRUE(contours.File.Report.empty());
  const recon::StructureSetContours none = this->Contours(file, 1);
  EXPECT_TRUE(none.File.Soup.Points.empty());
  ASSERT_EQ(none.File.Report.size(), 1u);
  EXPECT_EQ(none.File.Report[0], "ROI \"PTV 60\": it has no contours.");
}

TEST_F(StructureSet, KeepsEveryGeometricType)
{
  StructureSetBuilder builder;
  builder.AddROI(1, "All");
  builder.AddContour("POINT", "1\\2\\3", 1);
  builder.AddContour("POINT", "1\\2\\3\\4\\5\\6", 2);
  builder.AddContour("OPEN_PLANAR", Triangle, 3);
  builder.AddContour("OPEN_NONPLANAR", Triangle, 3);
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.AddContour("CLOSEDPLANAR_XOR", Triangle, 3);
  builder.AddContour("CLOSED_STRANGE", Triangle, 3);
  // A plane across the axes: coordinates must pass as they are.
  builder.AddContour("CLOSED_PLANAR", "0\\0\\0\\1\\0\\1\\1\\1\\2\\0\\1\\1", 4);
  builder.Save(this->Name("a.dcm"));
  recon::StructureSetFile file(this->Name("a.dcm"));
  const recon::StructureSetContours contours = this->Contours(file);
  EXPECT_EQ(contours.GeometricTypes,
    (std::vector<std::string>{ "POINT", "POINT", "POINT", "OPEN_PLANAR", "OPEN_NONPLANAR",
      "CLOSED_PLANAR", "CLOSEDPLANAR_XOR", "CLOSED_STRANGE", "CLOSED_PLANAR" }));
  const std::vector<recon::LoopSoup::Chain>& chains = contours.File.Soup.Chains;
  ASSERT_EQ(chains.size(), 9u);
  const std::vector<std::size_t> points{ 1, 1, 1, 3, 3, 3, 3, 3, 4 };
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    EXPECT_EQ(chains[i].Points.size(), points[i]) << i;
    EXPECT_EQ(chains[i].Closed, i >= 5) << i;
  }
  EXPECT_EQ(chains[1].Source, 1);
  EXPECT_EQ(chains[2].Source, 1);
  EXPECT_EQ(contours.File.Soup.Points.back(), (recon::Point3{ 0, 1, 1 }));
  ASSERT_EQ(contours.File.Report.size(), 1u);
  EXPECT_NE(contours.File.Report[0].find("'CLOSED_STRANGE'"), std::string::npos);
}

TEST_F(StructureSet, ReadsEveryEncoding)
{
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  for (const E_TransferSyntax syntax : { EXS_LittleEndianImplicit, EXS_LittleEndianExplicit,
         EXS_BigEndianExplicit, EXS_DeflatedLittleEndianExplicit })
  {
    for (const bool preamble : { true, false })
    {
      if (!preamble && syntax == EXS_DeflatedLittleEndianExplicit)
      {
        continue; // nothing in such a file says that it is deflated
      }
      for (const E_EncodingType encoding : { EET_ExplicitLength, EET_UndefinedLength })
      {
        builder.Save(this->Name("a.dcm"), syntax, preamble, encoding);
        EXPECT_TRUE(recon::StructureSetFile::IsStructureSet(this->Name("a.dcm")));
        recon::StructureSetFile file(this->Name("a.dcm"));
        EXPECT_EQ(this->Contours(file).File.Soup.Points.size(), 3u)
          << "syntax " << syntax << ", preamble " << preamble << ", encoding " << encoding;
      }
    }
  }
}

TEST_F(StructureSet, ReadsWhatIsMarkedAsCompressed)
{
  // Only pixels are ever compressed, and a structure set has none: all else is explicit little endian.
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.Save(this->Name("a.dcm"));
  std::string bytes = Bytes(this->Name("a.dcm"));
  const std::string plain = UID_LittleEndianExplicitTransferSyntax;
  const std::string compressed = UID_RLELosslessTransferSyntax;
  ASSERT_EQ(plain.size(), compressed.size());
  ASSERT_NE(bytes.find(plain + '\0'), std::string::npos);
  bytes.replace(bytes.find(plain + '\0'), plain.size(), compressed);
  recon::StructureSetFile file(this->Write("b.dcm", bytes));
  EXPECT_EQ(this->Contours(file).File.Soup.Points.size(), 3u);
}

TEST_F(StructureSet, ReadsContourDataThatIsTooLongForExplicitVR)
{
  // 16 bits hold the length of a DS: DCMTK writes more than 65 534 bytes as UN, as others do.
  std::string data;
  for (int i = 0; i < 9000; ++i)
  {
    data += (i ? "\\" : "") + std::to_string(i) + ".25\\1\\2";
  }
  StructureSetBuilder builder;
  builder.AddROI(1, "Long");
  builder.AddContour("CLOSED_PLANAR", data, 9000);
  for (const E_TransferSyntax syntax : { EXS_LittleEndianImplicit, EXS_LittleEndianExplicit })
  {
    builder.Save(this->Name("a.dcm"), syntax);
    recon::StructureSetFile file(this->Name("a.dcm"));
    const recon::StructureSetContours contours = this->Contours(file);
    ASSERT_EQ(contours.File.Soup.Points.size(), 9000u);
    EXPECT_EQ(contours.File.Soup.Points.back()[0], 8999.25);
  }
}

TEST_F(StructureSet, NamesAreUTF8AndUnique)
{
  StructureSetBuilder builder;
  StructureSetBuilder::Put(builder.Data(), DCM_SpecificCharacterSet, "ISO_IR 100");
  builder.AddROI(1, "Herz \xFC");
  builder.AddROI(2, "PTV");
  builder.AddROI(4, "PTV");
  builder.AddROI(5, "");
  builder.AddContour("POINT", "1\\2\\3", 1);
  builder.Save(this->Name("a.dcm"));
  recon::StructureSetFile file(this->Name("a.dcm"));
  EXPECT_EQ(file.GetROIs()[0].Name, "Herz \xC3\xBC");
  EXPECT_EQ(file.GetROIs()[1].Name, "PTV (2)");
  EXPECT_EQ(file.GetROIs()[2].Name, "PTV (4)");
  EXPECT_EQ(file.GetROIs()[3].Name, "ROI 5");
  EXPECT_EQ(file.GetReport().size(), 2u);
}

TEST_F(StructureSet, NamesOfEveryAlphabet)
{
  StructureSetBuilder builder;
  StructureSetBuilder::Put(builder.Data(), DCM_SpecificCharacterSet, "\\ISO 2022 IR 87");
  builder.AddROI(1, "\x1b$B:8GY\x1b(B 1");
  builder.AddROI(2, "\xff");
  builder.AddContour("POINT", "1\\2\\3", 1);
  builder.Save(this->Name("a.dcm"));
  recon::StructureSetFile file(this->Name("a.dcm"));
  EXPECT_EQ(file.GetROIs()[0].Name, "左肺 1");
  EXPECT_EQ(file.GetROIs()[1].Name, "?");
  ASSERT_EQ(file.GetReport().size(), 1u);
  EXPECT_EQ(file.GetReport()[0].rfind("ROI number 2: its name has letters", 0), 0u);
}

TEST_F(StructureSet, FrameOfReferenceIsThatOfTheROI)
{
  const auto append = [](DcmItem& parent, const DcmTagKey& tag) -> DcmItem&
  {
    DcmItem* item = nullptr;
    EXPECT_TRUE(parent.findOrCreateSequenceItem(tag, item, -2).good());
    return *item;
  };
  StructureSetBuilder builder;
  builder.AddROI(1, "Named");
  builder.AddROI(2, "Not named");
  DcmItem* named = nullptr;
  ASSERT_TRUE(builder.Data().findAndGetSequenceItem(DCM_StructureSetROISequence, named, 0).good());
  StructureSetBuilder::Put(*named, DCM_ReferencedFrameOfReferenceUID, "1.2.77");
  const auto frames = [&]
  {
    builder.Save(this->Name("a.dcm"));
    const recon::StructureSetFile file(this->Name("a.dcm"));
    return file.GetROIs()[0].FrameOfReferenceUID + " " + file.GetROIs()[1].FrameOfReferenceUID;
  };
  EXPECT_EQ(frames(), "1.2.77 ");
  StructureSetBuilder::Put(builder.Data(), DCM_FrameOfReferenceUID, "1.2.1");
  EXPECT_EQ(frames(), "1.2.77 1.2.1");
  StructureSetBuilder::Put(append(builder.Data(), DCM_ReferencedFrameOfReferenceSequence),
    DCM_FrameOfReferenceUID, "1.2.2");
  EXPECT_EQ(frames(), "1.2.77 1.2.2");
  // Of two frames it is open which is meant.
  StructureSetBuilder::Put(append(builder.Data(), DCM_ReferencedFrameOfReferenceSequence),
    DCM_FrameOfReferenceUID, "1.2.3");
  EXPECT_EQ(frames(), "1.2.77 ");
}

TEST_F(StructureSet, MalformedContourCostsThatContour)
{
  for (const char* number : { "nan", "inf", "1e999", "1,5", "abc", "", "1\n2" })
  {
    StructureSetBuilder builder;
    builder.AddROI(1, "A");
    builder.AddContour("CLOSED_PLANAR", Triangle, 3);
    builder.AddContour("CLOSED_PLANAR", std::string("0\\0\\1\\4\\") + number + "\\1\\4\\3\\1", 3);
    builder.AddContour("CLOSED_PLANAR", "0\\0\\1\\4\\5", 2);
    builder.AddContour("CLOSED_PLANAR", Triangle, 3);
    builder.Save(this->Name("a.dcm"));
    recon::StructureSetFile file(this->Name("a.dcm"));
    EXPECT_TRUE(file.GetReport().empty());
    const recon::StructureSetContours contours = this->Contours(file);
    ASSERT_EQ(contours.File.Soup.Chains.size(), 2u);
    EXPECT_EQ(contours.File.Soup.Chains[1].Source, 3);
    ASSERT_EQ(contours.File.Report.size(), 2u);
    EXPECT_EQ(contours.File.Report[0].rfind("ROI \"A\", contour 2: left out, expected a number as "
                                            "value 5 of ContourData (3006,0050), found '",
                0),
      0u)
      << contours.File.Report[0];
    EXPECT_EQ(contours.File.Report[0].find('\n'), std::string::npos);
    EXPECT_EQ(contours.File.Report[1],
      "ROI \"A\", contour 3: left out, expected three coordinates a point in ContourData "
      "(3006,0050), found 5 numbers.");
  }
}

TEST_F(StructureSet, OneLineAKindHoweverManyContours)
{
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  for (int i = 0; i < 10; ++i)
  {
    builder.AddContour("CLOSED_PLANAR", Triangle, 4);
    builder.AddContour("CLOSED_PLANAR", "0\\0\\x" + std::to_string(i), 1);
  }
  builder.Save(this->Name("a.dcm"));
  recon::StructureSetFile file(this->Name("a.dcm"));
  const std::vector<std::string> report = this->Contours(file).File.Report;
  ASSERT_EQ(report.size(), 2u);
  EXPECT_EQ(report[0],
    "ROI \"A\", contours 2, 4, 6 and 7 more: left out, expected a number as value 3 of ContourData "
    "(3006,0050), found 'x0' (the first).");
  EXPECT_EQ(report[1],
    "ROI \"A\", contours 1, 3, 5 and 7 more: announces 4 points and has 3; all of these were read "
    "(the first).");
}

TEST_F(StructureSet, LastBackslashIsReadAsMeant)
{
  for (const char* end : { "\\", "\\ ", " \\\\" })
  {
    StructureSetBuilder builder;
    builder.AddROI(1, "A");
    builder.AddContour("CLOSED_PLANAR", std::string(Triangle) + end, 3);
    builder.AddContour("CLOSED_PLANAR", std::string("1\\2") + end, 1);
    builder.Save(this->Name("a.dcm"));
    recon::StructureSetFile file(this->Name("a.dcm"));
    const recon::StructureSetContours contours = this->Contours(file);
    ASSERT_EQ(contours.File.Soup.Chains.size(), 1u) << "'" << end << "'";
    EXPECT_EQ(contours.File.Soup.Points.size(), 3u);
    EXPECT_EQ(contours.File.Report.size(), 1u);
  }
}

TEST_F(StructureSet, NumberUsedTwiceCostsThoseROIs)
{
  StructureSetBuilder builder;
  builder.AddROI(19, "Lung");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.AddROI(17, "Heart");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.AddROI(19, "New");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.Save(this->Name("a.dcm"));
  recon::StructureSetFile file(this->Name("a.dcm"));
  ASSERT_EQ(file.GetROIs().size(), 3u);
  ASSERT_EQ(file.GetReport().size(), 1u);
  EXPECT_EQ(file.GetReport()[0],
    "The ROIs \"Lung\", \"New\" have one number, 19, so that it is open which contours are whose; "
    "their contours are left out.");
  EXPECT_EQ(this->Contours(file, 1).File.Soup.Chains.size(), 1u);
  EXPECT_TRUE(this->Contours(file, 1).File.Report.empty());
  for (const int i : { 0, 2 })
  {
    const recon::StructureSetContours none = this->Contours(file, i);
    EXPECT_TRUE(none.File.Soup.Chains.empty());
    ASSERT_EQ(none.File.Report.size(), 1u);
    EXPECT_EQ(none.File.Report[0].rfind("ROI \"" + file.GetROIs()[i].Name + "\": ", 0), 0u);
  }
}

TEST_F(StructureSet, MissingNumbersCostWhatLacksThem)
{
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.AddROI(2, "B");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  builder.AddROI(3, "C");
  builder.AddContour("CLOSED_PLANAR", Triangle, 3);
  const auto remove = [&builder](const DcmTagKey& sequence, int item, const DcmTagKey& number)
  {
    DcmItem* found = nullptr;
    ASSERT_TRUE(builder.Data().findAndGetSequenceItem(sequence, found, item).good());
    ASSERT_TRUE(found->findAndDeleteElement(number).good());
  };
  remove(DCM_StructureSetROISequence, 0, DCM_ROINumber);
  remove(DCM_ROIContourSequence, 2, DCM_ReferencedROINumber);
  builder.Save(this->Name("a.dcm"));
  recon::StructureSetFile file(this->Name("a.dcm"));
  ASSERT_EQ(file.GetROIs().size(), 2u);
  EXPECT_EQ(file.GetROIs()[0].Name, "B");
  EXPECT_EQ(file.GetROIs()[0].NumberOfContours, 1);
  EXPECT_EQ(file.GetROIs()[1].NumberOfContours, 0);
  const std::vector<std::string>& report = file.GetReport();
  ASSERT_EQ(report.size(), 4u);
  EXPECT_EQ(report[0].rfind("Item 1 of StructureSetROISequence (3006,0020) (\"A\") has no", 0), 0u);
  EXPECT_NE(report[1].find("ROI number 1, which the file does not list"), std::string::npos);
  EXPECT_EQ(report[2].rfind("An item of ROIContourSequence (3006,0039) has no", 0), 0u);
}

TEST_F(StructureSet, ReportsWhatItReadAround)
{
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  builder.AddContour("CLOSED_PLANAR", Triangle, 5);
  builder.AddContour("CLOSED_PLANAR", "", 0);
  DcmItem* stray = nullptr;
  ASSERT_TRUE(builder.Data().findOrCreateSequenceItem(DCM_ROIContourSequence, stray, -2).good());
  StructureSetBuilder::Put(*stray, DCM_ReferencedROINumber, "99");
  ASSERT_TRUE(builder.Data().findAndDeleteElement(DCM_RTROIObservationsSequence).good());
  builder.Save(this->Name("a.dcm"));
  recon::StructureSetFile file(this->Name("a.dcm"));
  ASSERT_EQ(file.GetReport().size(), 2u);
  EXPECT_NE(file.GetReport()[0].find("ROI number 99"), std::string::npos);
  EXPECT_NE(file.GetReport()[1].find("(3006,0080) is missing"), std::string::npos);
  const recon::StructureSetContours contours = this->Contours(file);
  ASSERT_EQ(contours.File.Report.size(), 2u);
  EXPECT_EQ(contours.File.Report[0], "ROI \"A\", contour 2: left out, it has no contour data.");
  EXPECT_EQ(contours.File.Report[1],
    "ROI \"A\", contour 1: announces 5 points and has 3; all of these were read.");
}

TEST_P(RealStructureSet, HasTheCountsOfItsTable)
{
  const std::string fileName = Shared(std::string("rtstruct/") + GetParam().Name);
  CONTOUR_SKIP_UNLESS(fileName);
  EXPECT_TRUE(recon::StructureSetFile::IsStructureSet(fileName));
  recon::Monitor monitor;
  recon::StructureSetFile file(fileName);
  std::size_t contours = 0;
  std::size_t points = 0;
  for (std::size_t i = 0; i < file.GetROIs().size(); ++i)
  {
    contours += static_cast<std::size_t>(file.GetROIs()[i].NumberOfContours);
    points += file.ReadContours(static_cast<int>(i), monitor).File.Soup.Points.size();
  }
  EXPECT_EQ(file.GetROIs().size(), GetParam().ROIs);
  EXPECT_EQ(contours, GetParam().Contours);
  EXPECT_EQ(points, GetParam().Points);
}

INSTANTIATE_TEST_SUITE_P(Shared, RealStructureSet,
  testing::Values(Expected{ "dicompyler_rtss.dcm", 10, 441, 88158 },
    Expected{ "dicomexport_rs.dcm", 11, 281, 140724 }, Expected{ "cerr_ibsi.dcm", 1, 26, 9661 },
    Expected{ "rtutils_keyholes.dcm", 4, 12, 2104 },
    Expected{ "rtutils_single_slice_hole.dcm", 1, 2, 12 },
    Expected{ "pydicom_no_preamble_points.dcm", 3, 5, 19 },
    Expected{ "pyorthanc_cone_02mm.dcm", 2, 121, 22694 },
    Expected{ "template_no_contour_data.dcm", 1, 1, 0 }));
