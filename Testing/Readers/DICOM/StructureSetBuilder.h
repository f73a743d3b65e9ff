// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StructureSetBuilder.h
 * @brief Small RT structure sets for the tests, of every kind that the shared data lacks.
 */
#ifndef StructureSetBuilder_h
#define StructureSetBuilder_h

// DCMTK's own order: its configuration comes first.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcdeftag.h>
#include <dcmtk/dcmdata/dcfilefo.h>
#include <dcmtk/dcmdata/dcsequen.h>
#include <dcmtk/dcmdata/dcuid.h>

#include <stdexcept>
#include <string>

namespace readertesting
{
class StructureSetBuilder
{
public:
  StructureSetBuilder()
  {
    this->Put(this->Data(), DCM_SOPClassUID, UID_RTStructureSetStorage);
    this->Put(this->Data(), DCM_SOPInstanceUID, "1.2.3.4.5");
    this->Put(this->Data(), DCM_Modality, "RTSTRUCT");
  }

  DcmItem& Data() { return *this->File.getDataset(); }

  static void Put(DcmItem& item, const DcmTagKey& tag, const std::string& value)
  {
    Check(item.putAndInsertString(tag, value.c_str()));
  }

  /// A listed ROI, with its type; contours come by AddContour.
  void AddROI(int number, const std::string& name, const std::string& type = "ORGAN")
  {
    DcmItem& roi = this->Append(this->Data(), DCM_StructureSetROISequence);
    Put(roi, DCM_ROINumber, std::to_string(number));
    Put(roi, DCM_ROIName, name);
    DcmItem& contours = this->Append(this->Data(), DCM_ROIContourSequence);
    Put(contours, DCM_ReferencedROINumber, std::to_string(number));
    Put(contours, DCM_ROIDisplayColor, "255\\128\\0");
    DcmItem& observation = this->Append(this->Data(), DCM_RTROIObservationsSequence);
    Put(observation, DCM_ReferencedROINumber, std::to_string(number));
    Put(observation, DCM_RTROIInterpretedType, type);
    this->LastROI = &contours;
  }

  /// A contour of the ROI added last. data as in the file: numbers between backslashes.
  DcmItem& AddContour(const std::string& type, const std::string& data, int announced)
  {
    DcmItem& contour = this->Append(*this->LastROI, DCM_ContourSequence);
    Put(contour, DCM_ContourGeometricType, type);
    Put(contour, DCM_NumberOfContourPoints, std::to_string(announced));
    Put(contour, DCM_ContourData, data);
    return contour;
  }

  void Save(const std::string& fileName, E_TransferSyntax syntax = EXS_LittleEndianExplicit,
    bool preamble = true, E_EncodingType encoding = EET_ExplicitLength)
  {
    const E_FileWriteMode mode = preamble ? EWM_fileformat : EWM_dataset;
    Check(this->File.saveFile(
      fileName.c_str(), syntax, encoding, EGL_recalcGL, EPD_noChange, 0, 0, mode));
  }

private:
  static void Check(const OFCondition& condition)
  {
    if (condition.bad())
    {
      throw std::runtime_error(condition.text());
    }
  }
  static DcmItem& Append(DcmItem& parent, const DcmTagKey& tag)
  {
    DcmItem* item = nullptr;
    Check(parent.findOrCreateSequenceItem(tag, item, -2)); // -2: append
    return *item;
  }

  DcmFileFormat File;
  DcmItem* LastROI = nullptr;
};
}

#endif
