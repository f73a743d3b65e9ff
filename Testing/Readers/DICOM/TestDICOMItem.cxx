// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/StructureSetBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/DICOMItem.h"
#include "DICOM/LoadDICOM.h"

#include <set>

using namespace readertesting;

TEST(DICOMItem, TextsAndNumbersAreTrimmed)
{
  DcmItem item;
  recon::Put(item, DCM_ROIName, " Lung ");
  recon::Put(item, DCM_ROINumber, " 7 ");
  recon::Put(item, DCM_ImagePositionPatient, "1.5\\-2 \\ +3e1");
  EXPECT_EQ(recon::GetText(item, DCM_ROIName), "Lung");
  EXPECT_EQ(recon::GetText(item, DCM_PatientName), "");
  int number = 0;
  EXPECT_TRUE(recon::GetNumber(item, DCM_ROINumber, number));
  EXPECT_EQ(number, 7);
  EXPECT_FALSE(recon::GetNumber(item, DCM_ReferencedROINumber, number));
  double value = 0;
  EXPECT_TRUE(recon::GetNumber(item, DCM_ImagePositionPatient, 2, value));
  EXPECT_EQ(value, 30);
  EXPECT_FALSE(recon::GetNumber(item, DCM_ImagePositionPatient, 3, value));
  EXPECT_EQ(recon::TagName(DCM_ContourData), "ContourData (3006,0050)");
  EXPECT_EQ(recon::ClassName(UID_RTStructureSetStorage), "RTStructureSetStorage");
  EXPECT_EQ(recon::ClassName("1.2.3"), "1.2.3");
}

TEST(DICOMItem, ItemsAreAppended)
{
  DcmItem item;
  EXPECT_TRUE(recon::ItemsOf(item, DCM_ContourSequence).empty());
  recon::Put(recon::AppendItem(item, DCM_ContourSequence), DCM_ContourNumber, "1");
  recon::Put(recon::AppendItem(item, DCM_ContourSequence), DCM_ContourNumber, "2");
  const std::vector<DcmItem*> items = recon::ItemsOf(item, DCM_ContourSequence);
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(recon::GetText(*items[1], DCM_ContourNumber), "2");
  DcmItem other;
  recon::CopyElement(item, DCM_ContourSequence, other);
  recon::CopyElement(item, DCM_PatientName, other); // which is not there
  EXPECT_EQ(recon::ItemsOf(other, DCM_ContourSequence).size(), 2u);
  EXPECT_EQ(other.card(), 1u);
}

TEST(DICOMItem, ContourPoints)
{
  const auto points = [](const char* data)
  {
    DcmItem item;
    recon::Put(item, DCM_ContourData, data);
    return recon::GetContourPoints(item);
  };
  EXPECT_EQ(
    points("1\\2\\3\\ 4\\5 \\6").Points, (std::vector<recon::Point3>{ { 1, 2, 3 }, { 4, 5, 6 } }));
  EXPECT_EQ(points("1\\2\\3\\").Points.size(), 1u);
  for (const char* nothing : { "", " ", "\\" })
  {
    EXPECT_TRUE(points(nothing).Points.empty());
    EXPECT_TRUE(points(nothing).Fault.empty()) << nothing;
  }
  EXPECT_EQ(points("1\\2").Fault,
    "expected three coordinates a point in ContourData (3006,0050), found 2 numbers");
  EXPECT_EQ(points("1\\x\\3\\y\\5\\6").Fault,
    "expected a number as value 2 of ContourData (3006,0050), found 'x'");
  EXPECT_TRUE(points("1\\x\\3\\4\\5\\6").Points.empty());
  DcmItem none;
  EXPECT_TRUE(recon::GetContourPoints(none).Points.empty());
}

TEST(DICOMItem, IdentifiersCanBeShown)
{
  DcmItem item;
  const auto uid = [&item](const std::string& bytes)
  {
    item.putAndInsertString(DCM_SOPClassUID, bytes.c_str(), static_cast<Uint32>(bytes.size()));
    return recon::GetUID(item, DCM_SOPClassUID);
  };
  EXPECT_EQ(uid(std::string("1.2.30\0", 7)), "1.2.30");
  EXPECT_EQ(uid(std::string("1.2\0003\xff.4", 8)), "1.2?3?.4");
  EXPECT_EQ(uid(std::string(100, '1')), std::string(64, '1'));
  EXPECT_EQ(recon::GetUID(item, DCM_StudyInstanceUID), "");
}

using DICOMItemFolder = Folder;

TEST_F(DICOMItemFolder, FilesAreToldByTheirBeginning)
{
  StructureSetBuilder builder;
  builder.AddROI(1, "A");
  for (const bool preamble : { true, false })
  {
    for (const E_TransferSyntax syntax :
      { EXS_LittleEndianImplicit, EXS_LittleEndianExplicit, EXS_BigEndianExplicit })
    {
      builder.Save(this->Name("a"), syntax, preamble);
      EXPECT_TRUE(recon::BeginsAsDICOM(this->Name("a")));
      const recon::QuietDCMTK quiet;
      DcmFileFormat file;
      recon::LoadDICOM(this->Name("a"), file);
      EXPECT_EQ(recon::GetText(*file.getDataset(), DCM_Modality), "RTSTRUCT");
    }
  }
  for (const std::string& bytes : { std::string(), std::string("S 1\nv 3 z 0"),
         std::string(200, 'x'), std::string("\x08"), std::string(128, '\0') })
  {
    EXPECT_FALSE(recon::BeginsAsDICOM(this->Write("b", bytes)));
  }
  EXPECT_FALSE(recon::BeginsAsDICOM(this->Name("absent")));
}

TEST(DICOMItem, NewUIDsAreNew)
{
  std::set<std::string> uids;
  for (int i = 0; i < 100; ++i)
  {
    const std::string uid = recon::NewUID();
    EXPECT_LE(uid.size(), 64u);
    EXPECT_EQ(uid.find_first_not_of("0123456789."), std::string::npos);
    EXPECT_TRUE(uids.insert(uid).second);
  }
}
