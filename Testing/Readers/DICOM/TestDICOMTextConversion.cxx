// SPDX-License-Identifier: GPL-3.0-or-later
#include "Readers/DICOM/StructureSetBuilder.h"

#include "DICOM/DICOMTextConversion.h"

#include <gtest/gtest.h>

TEST(DICOMTextConversion, EveryTextBelowTheItem)
{
  DcmItem data;
  recon::Put(data, DCM_SpecificCharacterSet, "ISO_IR 100");
  recon::Put(data, DCM_PatientName, "M\xfcller^Eva");
  recon::Put(data, DCM_PatientID, "4711");
  recon::Put(data, DCM_Modality, "RTSTRUCT");
  recon::Put(recon::AppendItem(data, DCM_StructureSetROISequence), DCM_ROIName, "Gro\xdfhirn");
  // An item may have a character set of its own.
  DcmItem& greek = recon::AppendItem(data, DCM_StructureSetROISequence);
  recon::Put(greek, DCM_SpecificCharacterSet, "ISO_IR 126");
  recon::Put(greek, DCM_ROIName, "\xea\xe1\xf1\xe4\xe9\xdc");
  EXPECT_TRUE(recon::ConvertToUTF8(data).empty());
  EXPECT_EQ(recon::GetText(data, DCM_SpecificCharacterSet), "ISO_IR 192");
  EXPECT_EQ(recon::GetText(data, DCM_PatientName), "Müller^Eva");
  EXPECT_EQ(recon::GetText(data, DCM_PatientID), "4711");
  EXPECT_EQ(recon::GetText(data, DCM_Modality), "RTSTRUCT");
  const std::vector<DcmItem*> rois = recon::ItemsOf(data, DCM_StructureSetROISequence);
  EXPECT_EQ(recon::GetText(*rois[0], DCM_ROIName), "Großhirn");
  EXPECT_EQ(recon::GetText(*rois[1], DCM_ROIName), "καρδιά");
  EXPECT_FALSE(rois[1]->tagExists(DCM_SpecificCharacterSet));
}

TEST(DICOMTextConversion, ElementsWithUnexplainedBytesAreNamedOnce)
{
  DcmItem data;
  recon::Put(data, DCM_PatientName, "M\xfcller");
  for (int i = 0; i < 2; ++i)
  {
    recon::Put(recon::AppendItem(data, DCM_StructureSetROISequence), DCM_ROIName, "\xff");
  }
  EXPECT_EQ(recon::ConvertToUTF8(data),
    (std::vector<std::string>{ "PatientName (0010,0010)", "ROIName (3006,0026)" }));
  EXPECT_EQ(recon::GetText(data, DCM_PatientName), "M?ller");
}
