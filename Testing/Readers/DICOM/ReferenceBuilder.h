// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ReferenceBuilder.h
 * @brief A made-up patient: images on slices 3 mm apart, and a structure set drawn on them.
 */
#ifndef ReferenceBuilder_h
#define ReferenceBuilder_h

#include "StructureSetBuilder.h"

#include <string>
#include <vector>

namespace readertesting
{
constexpr double SliceSpacing = 3;

inline std::string ImageUID(int slice)
{
  return "1.2.3.100." + std::to_string(slice);
}

/// A square contour at z, 40 mm wide.
inline std::string SquareAt(double z)
{
  const std::string end = "\\" + std::to_string(z);
  return "-20\\-20" + end + "\\20\\-20" + end + "\\20\\20" + end + "\\-20\\20" + end;
}

inline void PutPatient(DcmItem& data)
{
  StructureSetBuilder::Put(data, DCM_SpecificCharacterSet, "ISO_IR 100");
  StructureSetBuilder::Put(data, DCM_PatientName, "M\xfcller^Eva"); // Latin-1
  StructureSetBuilder::Put(data, DCM_PatientID, "4711");
  StructureSetBuilder::Put(data, DCM_StudyInstanceUID, "1.2.3.4");
  StructureSetBuilder::Put(data, DCM_StudyDate, "20260102");
  StructureSetBuilder::Put(data, DCM_ApprovalStatus, "APPROVED");
}

/// @param slices numbers of the images that ROI "Body" is drawn on; listed are `listed` images
inline void FillReference(StructureSetBuilder& builder, const std::vector<int>& slices, int listed)
{
  const auto append = [](DcmItem& parent, const DcmTagKey& tag) -> DcmItem&
  {
    DcmItem* item = nullptr;
    if (parent.findOrCreateSequenceItem(tag, item, -2).bad())
    {
      throw std::runtime_error("no item");
    }
    return *item;
  };
  const auto refer = [&](DcmItem& parent, int slice)
  {
    DcmItem& image = append(parent, DCM_ContourImageSequence);
    StructureSetBuilder::Put(image, DCM_ReferencedSOPClassUID, UID_CTImageStorage);
    StructureSetBuilder::Put(image, DCM_ReferencedSOPInstanceUID, ImageUID(slice));
  };
  PutPatient(builder.Data());
  DcmItem& frame = append(builder.Data(), DCM_ReferencedFrameOfReferenceSequence);
  StructureSetBuilder::Put(frame, DCM_FrameOfReferenceUID, "1.2.3.9");
  DcmItem& study = append(frame, DCM_RTReferencedStudySequence);
  StructureSetBuilder::Put(
    study, DCM_ReferencedSOPClassUID, UID_RETIRED_DetachedStudyManagementSOPClass);
  StructureSetBuilder::Put(study, DCM_ReferencedSOPInstanceUID, "1.2.3.4");
  DcmItem& series = append(study, DCM_RTReferencedSeriesSequence);
  StructureSetBuilder::Put(series, DCM_SeriesInstanceUID, "1.2.3.8");
  for (int i = 0; i < listed; ++i)
  {
    refer(series, i);
  }
  builder.AddROI(1, "Body", "EXTERNAL");
  for (const int slice : slices)
  {
    refer(builder.AddContour("CLOSED_PLANAR", SquareAt(SliceSpacing * slice), 4), slice);
  }
}

/// What an image says besides its number.
struct ImageKind
{
  std::string Series = "1.2.3.8";
  std::string Frame = "1.2.3.9";
  std::string Orientation = "1\\0\\0\\0\\1\\0"; ///< empty for none
  std::string Type = "ORIGINAL\\PRIMARY\\AXIAL";
  bool Preamble = true;
};

/// A CT image of 4 rows (2 mm) and 6 columns (0.5 mm), without its pixels.
inline void SaveImage(const std::string& fileName, int slice, const ImageKind& kind)
{
  DcmFileFormat file;
  DcmItem& data = *file.getDataset();
  PutPatient(data);
  StructureSetBuilder::Put(data, DCM_SOPClassUID, UID_CTImageStorage);
  StructureSetBuilder::Put(data, DCM_SOPInstanceUID, ImageUID(slice));
  StructureSetBuilder::Put(data, DCM_ImageType, kind.Type);
  StructureSetBuilder::Put(data, DCM_Modality, "CT");
  StructureSetBuilder::Put(data, DCM_SeriesInstanceUID, kind.Series);
  StructureSetBuilder::Put(data, DCM_FrameOfReferenceUID, kind.Frame);
  if (!kind.Orientation.empty())
  {
    StructureSetBuilder::Put(data, DCM_ImageOrientationPatient, kind.Orientation);
    StructureSetBuilder::Put(
      data, DCM_ImagePositionPatient, "-100\\-100\\" + std::to_string(SliceSpacing * slice));
  }
  StructureSetBuilder::Put(data, DCM_PixelSpacing, "2\\0.5");
  data.putAndInsertUint16(DCM_Rows, 4);
  data.putAndInsertUint16(DCM_Columns, 6);
  const E_FileWriteMode mode = kind.Preamble ? EWM_fileformat : EWM_dataset;
  if (file
        .saveFile(fileName.c_str(), EXS_LittleEndianExplicit, EET_ExplicitLength, EGL_recalcGL,
          EPD_noChange, 0, 0, mode)
        .bad())
  {
    throw std::runtime_error("no image");
  }
}

inline void SaveImage(const std::string& fileName, int slice, const std::string& series = "1.2.3.8")
{
  ImageKind kind;
  kind.Series = series;
  SaveImage(fileName, slice, kind);
}
}

#endif
