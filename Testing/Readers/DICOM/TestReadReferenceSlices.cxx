// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/ReferenceBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/ReadReferenceSlices.h"

using namespace readertesting;

namespace
{
class ReadReferenceSlices : public Folder
{
protected:
  recon::SlicesOfReference Read(const std::string& path, const std::string& frame = "")
  {
    return recon::ReadReferenceSlices(path, frame, this->Monitor);
  }
  /// A structure set with ROI 1 drawn on slices 0 to 4 of the frame 1.2.3.9, and ROI 2 on those from
  /// 100 on, at the same heights and 1 mm higher, of the frame 1.2.3.10.
  std::string TwoFrames(bool named)
  {
    StructureSetBuilder builder;
    FillReference(builder, { 0, 1, 2, 3, 4 }, 5);
    DcmItem* roi = nullptr;
    builder.Data().findAndGetSequenceItem(DCM_StructureSetROISequence, roi, 0);
    StructureSetBuilder::Put(*roi, DCM_ReferencedFrameOfReferenceUID, "1.2.3.9");
    builder.AddROI(2, "MR");
    builder.Data().findAndGetSequenceItem(DCM_StructureSetROISequence, roi, 1);
    if (named)
    {
      StructureSetBuilder::Put(*roi, DCM_ReferencedFrameOfReferenceUID, "1.2.3.10");
    }
    DcmItem* frame = nullptr;
    builder.Data().findOrCreateSequenceItem(DCM_ReferencedFrameOfReferenceSequence, frame, -2);
    StructureSetBuilder::Put(*frame, DCM_FrameOfReferenceUID, "1.2.3.10");
    DcmItem* study = nullptr;
    frame->findOrCreateSequenceItem(DCM_RTReferencedStudySequence, study, -2);
    DcmItem* series = nullptr;
    study->findOrCreateSequenceItem(DCM_RTReferencedSeriesSequence, series, -2);
    for (int i = 0; i < 3; ++i)
    {
      DcmItem& contour = builder.AddContour("CLOSED_PLANAR", SquareAt(1 + 5 * i), 4);
      for (DcmItem* parent : { &contour, series })
      {
        DcmItem* image = nullptr;
        parent->findOrCreateSequenceItem(DCM_ContourImageSequence, image, -2);
        StructureSetBuilder::Put(*image, DCM_ReferencedSOPClassUID, UID_MRImageStorage);
        StructureSetBuilder::Put(*image, DCM_ReferencedSOPInstanceUID, ImageUID(100 + i));
      }
    }
    builder.Save(this->Name("two.dcm"));
    return this->Name("two.dcm");
  }
  recon::Monitor Monitor;
};
}

TEST_F(ReadReferenceSlices, TellHowNearAContourBelongsToThem)
{
  std::filesystem::create_directory(this->Name("images"));
  for (int slice = 0; slice < 4; ++slice)
  {
    SaveImage(this->Name("images/" + std::to_string(slice)), slice);
  }
  const recon::SlicesOfReference images = this->Read(this->Name("images/2"));
  EXPECT_EQ(images.Slices.size(), 4u);
  EXPECT_DOUBLE_EQ(images.Tolerance, SliceSpacing / 2);
  EXPECT_EQ(images.FrameOfReferenceUID, "1.2.3.9");
  EXPECT_TRUE(images.Report.empty());
  // Ten images listed and four drawn on: there may be others between them.
  StructureSetBuilder builder;
  FillReference(builder, { 0, 3, 6, 9 }, 10);
  builder.Save(this->Name("set.dcm"));
  EXPECT_DOUBLE_EQ(this->Read(this->Name("set.dcm")).Tolerance, 0.1);
}

TEST_F(ReadReferenceSlices, OnePlaneOneSlice)
{
  std::filesystem::create_directory(this->Name("images"));
  for (int slice = 0; slice < 4; ++slice)
  {
    SaveImage(this->Name("images/" + std::to_string(slice)), slice);
    SaveImage(this->Name("images/again " + std::to_string(slice)), slice);
  }
  const recon::SlicesOfReference slices = this->Read(this->Name("images/2"));
  EXPECT_EQ(slices.Slices.size(), 4u);
  ASSERT_EQ(slices.Report.size(), 1u);
  EXPECT_EQ(slices.Report[0].rfind("4 images in the plane of another one", 0), 0u);
}

TEST_F(ReadReferenceSlices, AreThoseOfOneFrame)
{
  for (const bool named : { true, false })
  {
    const std::string path = this->TwoFrames(named);
    const recon::SlicesOfReference first = this->Read(path);
    ASSERT_EQ(first.Slices.size(), 5u);
    EXPECT_EQ(first.Slices[1].InstanceUID, ImageUID(1));
    EXPECT_EQ(first.FrameOfReferenceUID, "1.2.3.9");
    ASSERT_EQ(first.Report.size(), 1u);
    EXPECT_NE(first.Report[0].find("(1.2.3.9 and 1.2.3.10)"), std::string::npos);
    const recon::SlicesOfReference second = this->Read(path, "1.2.3.10");
    ASSERT_EQ(second.Slices.size(), 3u);
    EXPECT_EQ(second.Slices[1].InstanceUID, ImageUID(101));
    EXPECT_NEAR(second.Slices[1].Offset, 6, 1e-9);
    EXPECT_EQ(second.FrameOfReferenceUID, "1.2.3.10");
    EXPECT_TRUE(second.Report.empty());
  }
}

TEST_F(ReadReferenceSlices, OfAnotherFrameAreRefused)
{
  const std::string path = this->TwoFrames(true);
  ExpectSentence(SentenceOf([&] { this->Read(path, "1.2.3.11"); }), path,
    "in the frame of reference 1.2.3.9 and 1.2.3.10, and the contours were drawn in 1.2.3.11");
}

TEST_F(ReadReferenceSlices, AreTheImagesByHeight)
{
  std::filesystem::create_directory(this->Name("images"));
  for (const int slice : { 2, 0, 1 })
  {
    SaveImage(this->Name("images/" + std::to_string(9 - slice)), slice);
  }
  const std::vector<recon::ReferenceSlice> slices =
    recon::ReadReferenceSlices(this->Name("images"), "", this->Monitor).Slices;
  ASSERT_EQ(slices.size(), 3u);
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_EQ(slices[i].InstanceUID, ImageUID(i));
    EXPECT_EQ(slices[i].Normal, (recon::Vector3{ 0, 0, 1 }));
    EXPECT_DOUBLE_EQ(slices[i].PixelArea, 1);
    const double z = SliceSpacing * i;
    // 4 rows of 2 mm, 6 columns of 0.5 mm; the first pixel's centre is at -100, -100.
    EXPECT_EQ(slices[i].Outline,
      (std::array<recon::Point3, 4>{
        { { -100.25, -101, z }, { -97.25, -101, z }, { -97.25, -93, z }, { -100.25, -93, z } } }));
  }
}
