// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/ReferenceBuilder.h"
#include "Readers/ReaderTesting.h"

#include "DICOM/DrawnSlices.h"

using namespace readertesting;

TEST(DrawnSlices, LargestContourTellsThePlane)
{
  StructureSetBuilder builder;
  FillReference(builder, { 0, 1 }, 2);
  // A small one, tilted by rounding, of another ROI on image 1.
  builder.AddROI(2, "Small");
  DcmItem& contour =
    builder.AddContour("CLOSED_PLANAR", "0\\0\\3\\1\\0\\3.1\\1\\1\\3.2\\0\\1\\3.1", 4);
  DcmItem* image = nullptr;
  contour.findOrCreateSequenceItem(DCM_ContourImageSequence, image, -2);
  StructureSetBuilder::Put(*image, DCM_ReferencedSOPInstanceUID, ImageUID(1));
  builder.AddContour("CLOSED_PLANAR", "1\\2\\nan", 1); // refers to no image
  recon::Monitor monitor;
  recon::DrawnSlices drawn = recon::ReadDrawnSlices(builder.Data(), "1.2.3.9", monitor);
  EXPECT_EQ(drawn.Malformed, 0);
  ASSERT_EQ(drawn.SlicesOfFrame.size(), 1u);
  const std::vector<recon::ReferenceSlice>& slices = drawn.SlicesOfFrame["1.2.3.9"];
  ASSERT_EQ(slices.size(), 2u);
  EXPECT_EQ(slices[1].Normal, (recon::Vector3{ 0, 0, 1 }));
  EXPECT_DOUBLE_EQ(slices[1].Offset, 3);
  EXPECT_EQ(recon::ListedImages(builder.Data(), "1.2.3.9").size(), 2u);
  EXPECT_TRUE(recon::ListedImages(builder.Data(), "1.2").empty());
}

TEST(DrawnSlices, ContoursOnSeveralImagesTellNone)
{
  StructureSetBuilder builder;
  FillReference(builder, { 0 }, 3);
  DcmItem& contour = builder.AddContour("CLOSED_PLANAR", SquareAt(1.5), 4);
  for (const int slice : { 1, 2 })
  {
    DcmItem* image = nullptr;
    contour.findOrCreateSequenceItem(DCM_ContourImageSequence, image, -2);
    StructureSetBuilder::Put(*image, DCM_ReferencedSOPInstanceUID, ImageUID(slice));
  }
  recon::Monitor monitor;
  recon::DrawnSlices drawn = recon::ReadDrawnSlices(builder.Data(), "1.2.3.9", monitor);
  EXPECT_EQ(drawn.SlicesOfFrame["1.2.3.9"].size(), 1u);
}
