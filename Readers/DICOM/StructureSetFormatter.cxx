// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/StructureSetFormatter.h"

#include "Base/SubMonitor.h"
#include "Base/Text.h"
#include "Common/ReplacedFile.h"
#include "DICOM/DecimalString.h"
#include "DICOM/DICOMItem.h"
#include "DICOM/DICOMText.h"
#include "DICOM/DICOMTextConversion.h"
#include "DICOM/ROIRegister.h"
#include "DICOM/StructureSetCheck.h"
#include "DICOM/StructureSetReference.h"

#include <dcmtk/dcmdata/dcmetinf.h>
#include <dcmtk/dcmdata/dcuid.h>
#include <dcmtk/dcmdata/dcvrda.h>
#include <dcmtk/dcmdata/dcvrtm.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

namespace recon
{
namespace
{
/// By number, as DCMTK's name of it has changed.
const DcmTagKey EthnicGroup(0x0010, 0x2160);

constexpr std::size_t LongestLabel = 16;

std::array<int, 3> ColorOf(const StructureSetROI& roi)
{
  static constexpr std::array<std::array<int, 3>, 8> palette{ { { 230, 60, 50 }, { 60, 180, 75 },
    { 70, 110, 230 }, { 245, 190, 40 }, { 170, 70, 200 }, { 60, 200, 220 }, { 240, 130, 50 },
    { 240, 110, 190 } } };
  return roi.HasColor ? roi.Color : palette[static_cast<std::size_t>(roi.Number) % palette.size()];
}

class Formatter
{
public:
  Formatter(const StructureSetOptions& options, StructureSetReference& reference,
    std::vector<std::string>& report)
    : Options(options),
      Reference(reference),
      Report(report)
  {
  }

  void Format(std::vector<WrittenROI>& rois, Monitor& monitor);
  void Save(const std::string& fileName);

private:
  DcmItem& Data() { return *this->File.getDataset(); }
  void NameROIs(std::vector<WrittenROI>& rois);
  void SelectCharacterSet(const std::vector<WrittenROI>& rois);
  void AddPatientAndStudy();
  void AddSeries();
  void CopyROIs();
  void AddROI(const WrittenROI& roi);
  void AddContour(
    const WrittenContour& contour, const ReferenceSlices& slices, int number, DcmItem& item);
  void TakeFrames(const std::vector<WrittenROI>& rois);
  void ReportContoursOnNoSlice(std::size_t contours);

  const StructureSetOptions& Options;
  StructureSetReference& Reference;
  std::vector<std::string>& Report;
  DcmFileFormat File;
  ROIRegister Register;
  int LastObservation = 0;
  std::size_t ContoursOnNoSlice = 0;
  std::vector<std::string> Frames; ///< of the new ROIs
};

void Formatter::NameROIs(std::vector<WrittenROI>& rois)
{
  std::string renamed;
  for (WrittenROI& roi : rois)
  {
    StructureSetROI& description = roi.Description;
    const std::string given = description.Name;
    description.Number = this->Register.NewNumber(description.Number);
    const std::string allowed = DICOMText(given, LongestROIName);
    description.Name = this->Register.NewName(
      allowed.empty() ? "ROI " + std::to_string(description.Number) : allowed);
    if (description.Name != given)
    {
      renamed += (renamed.empty() ? "\"" : ", \"") + given + "\" is written as \"" +
        description.Name + "\" (number " + std::to_string(description.Number) + ")";
    }
  }
  if (!renamed.empty())
  {
    this->Report.push_back("Names of ROIs that are taken already, or that DICOM does not allow (64 "
                           "characters, no backslash): " +
      renamed + ".");
  }
}

void Formatter::SelectCharacterSet(const std::vector<WrittenROI>& rois)
{
  DcmItem& reference = this->Reference.Data();
  const bool isPlain = IsASCII(this->Options.Label) &&
    std::all_of(rois.begin(), rois.end(),
      [](const WrittenROI& roi) { return IsASCII(roi.Description.Name); });
  if (isPlain)
  {
    // Every character set has these letters, so that of the reference stays.
    CopyElement(reference, DCM_SpecificCharacterSet, this->Data());
    return;
  }
  const std::vector<std::string> unexplained = ConvertToUTF8(reference);
  if (!unexplained.empty())
  {
    this->Report.push_back("The reference has letters that its character set does not explain; "
                           "they are written as '?': " +
      unexplained.front() +
      (unexplained.size() > 1 ? " and " + std::to_string(unexplained.size() - 1) + " other elements"
                              : std::string()) +
      ".");
  }
  Put(this->Data(), DCM_SpecificCharacterSet, "ISO_IR 192");
}

void Formatter::AddPatientAndStudy()
{
  // Type 2: there, if only empty.
  for (const DcmTagKey& key : { DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate,
         DCM_PatientSex, DCM_StudyDate, DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID,
         DCM_AccessionNumber, DCM_PositionReferenceIndicator, DCM_OperatorsName })
  {
    Put(this->Data(), key, "");
  }
  for (const DcmTagKey& key : { DCM_PatientName, DCM_PatientID, DCM_IssuerOfPatientID,
         DCM_IssuerOfPatientIDQualifiersSequence, DCM_PatientBirthDate, DCM_PatientBirthTime,
         DCM_PatientSex, DCM_OtherPatientIDsSequence, EthnicGroup, DCM_PatientComments,
         DCM_PatientSpeciesDescription, DCM_PatientSpeciesCodeSequence, DCM_PatientSexNeutered,
         DCM_PatientBreedDescription, DCM_PatientBreedCodeSequence, DCM_BreedRegistrationSequence,
         DCM_ResponsiblePerson, DCM_ResponsiblePersonRole, DCM_ResponsibleOrganization,
         DCM_PatientIdentityRemoved, DCM_DeidentificationMethod,
         DCM_DeidentificationMethodCodeSequence, DCM_StudyInstanceUID, DCM_StudyDate, DCM_StudyTime,
         DCM_StudyID, DCM_StudyDescription, DCM_ReferringPhysicianName, DCM_AccessionNumber,
         DCM_PatientAge, DCM_PatientSize, DCM_PatientWeight, DCM_PositionReferenceIndicator })
  {
    CopyElement(this->Reference.Data(), key, this->Data());
  }
  if (GetUID(this->Data(), DCM_StudyInstanceUID).empty())
  {
    Put(this->Data(), DCM_StudyInstanceUID, NewUID());
  }
}

void Formatter::AddSeries()
{
  OFString date;
  OFString time;
  DcmDate::getCurrentDate(date);
  DcmTime::getCurrentTime(time);
  for (const DcmTagKey& key : { DCM_InstanceCreationDate, DCM_SeriesDate, DCM_StructureSetDate })
  {
    Put(this->Data(), key, date.c_str());
  }
  for (const DcmTagKey& key : { DCM_InstanceCreationTime, DCM_SeriesTime, DCM_StructureSetTime })
  {
    Put(this->Data(), key, time.c_str());
  }
  Put(this->Data(), DCM_SOPClassUID, UID_RTStructureSetStorage);
  Put(this->Data(), DCM_SOPInstanceUID, NewUID());
  Put(this->Data(), DCM_SeriesInstanceUID, NewUID());
  Put(this->Data(), DCM_Modality, "RTSTRUCT");
  Put(this->Data(), DCM_SeriesNumber, "1");
  Put(this->Data(), DCM_InstanceNumber, "1");
  Put(this->Data(), DCM_Manufacturer, "Contour Reconstruction for ParaView");
  Put(this->Data(), DCM_ManufacturerModelName, "RT Structure Set Writer");
  Put(this->Data(), DCM_SoftwareVersions, CONTOUR_VERSION);
  Put(this->Data(), DCM_FrameOfReferenceUID, this->Frames.front());
  const std::string label = DICOMText(this->Options.Label, LongestLabel);
  Put(this->Data(), DCM_StructureSetLabel, label.empty() ? "Reconstruction" : label);
  Put(this->Data(), DCM_StructureSetDescription, NoMedicalDevice);
  Put(this->Data(), DCM_ApprovalStatus, "UNAPPROVED");
  if (this->Reference.IsStructureSet())
  {
    DcmItem& before = AppendItem(this->Data(), DCM_PredecessorStructureSetSequence);
    Put(before, DCM_ReferencedSOPClassUID, UID_RTStructureSetStorage);
    Put(before, DCM_ReferencedSOPInstanceUID, GetUID(this->Reference.Data(), DCM_SOPInstanceUID));
  }
}

void Formatter::CopyROIs()
{
  DcmItem& reference = this->Reference.Data();
  // The last three say what the codes of the ROIs mean.
  for (const DcmTagKey& key : { DCM_StructureSetROISequence, DCM_ROIContourSequence,
         DCM_RTROIObservationsSequence, DCM_CodingSchemeIdentificationSequence,
         DCM_ContextGroupIdentificationSequence, DCM_MappingResourceIdentificationSequence })
  {
    CopyElement(reference, key, this->Data());
  }
  for (DcmItem* roi : ItemsOf(reference, DCM_StructureSetROISequence))
  {
    int number = 0;
    GetNumber(*roi, DCM_ROINumber, number);
    this->Register.Take(number, GetText(*roi, DCM_ROIName));
  }
  for (const DcmTagKey& key : { DCM_ROIContourSequence, DCM_RTROIObservationsSequence })
  {
    for (DcmItem* item : ItemsOf(reference, key))
    {
      int number = 0;
      GetNumber(*item, DCM_ReferencedROINumber, number);
      this->Register.TakeNumber(number);
    }
  }
  for (DcmItem* observation : ItemsOf(reference, DCM_RTROIObservationsSequence))
  {
    int number = 0;
    GetNumber(*observation, DCM_ObservationNumber, number);
    this->LastObservation = std::max(this->LastObservation, number);
  }
}

void Formatter::AddContour(
  const WrittenContour& contour, const ReferenceSlices& slices, int number, DcmItem& item)
{
  if (const ReferenceSlice* slice = slices.Find(contour.Points))
  {
    DcmItem& image = AppendItem(item, DCM_ContourImageSequence);
    Put(image, DCM_ReferencedSOPClassUID, slice->ClassUID);
    Put(image, DCM_ReferencedSOPInstanceUID, slice->InstanceUID);
  }
  else
  {
    ++this->ContoursOnNoSlice;
  }
  Put(item, DCM_ContourGeometricType, contour.GeometricType);
  Put(item, DCM_NumberOfContourPoints, std::to_string(contour.Points.size()));
  Put(item, DCM_ContourNumber, std::to_string(number));
  std::string data;
  for (const Point3& p : contour.Points)
  {
    for (const double x : p)
    {
      if (!data.empty())
      {
        data += '\\';
      }
      AppendDecimalString(data, x);
    }
  }
  Put(item, DCM_ContourData, data);
}

void Formatter::AddROI(const WrittenROI& roi)
{
  const StructureSetROI& description = roi.Description;
  const std::string number = std::to_string(description.Number);
  const std::string frame = this->Reference.FrameFor(description.FrameOfReferenceUID);
  const ReferenceSlices& slices = this->Reference.GetSlices(frame);
  DcmItem& listed = AppendItem(this->Data(), DCM_StructureSetROISequence);
  Put(listed, DCM_ROINumber, number);
  Put(listed, DCM_ReferencedFrameOfReferenceUID, frame);
  Put(listed, DCM_ROIName, description.Name);
  Put(listed, DCM_ROIGenerationAlgorithm, this->Options.GenerationAlgorithm);

  DcmItem& contours = AppendItem(this->Data(), DCM_ROIContourSequence);
  const std::array<int, 3> color = ColorOf(description);
  Put(contours, DCM_ROIDisplayColor,
    std::to_string(color[0]) + "\\" + std::to_string(color[1]) + "\\" + std::to_string(color[2]));
  for (std::size_t c = 0; c < roi.Contours.size(); ++c)
  {
    this->AddContour(
      roi.Contours[c], slices, static_cast<int>(c) + 1, AppendItem(contours, DCM_ContourSequence));
  }
  Put(contours, DCM_ReferencedROINumber, number);

  DcmItem& observation = AppendItem(this->Data(), DCM_RTROIObservationsSequence);
  Put(observation, DCM_ObservationNumber, std::to_string(++this->LastObservation));
  Put(observation, DCM_ReferencedROINumber, number);
  Put(observation, DCM_RTROIInterpretedType, CodeString(description.Type));
  Put(observation, DCM_ROIInterpreter, "");
}

void Formatter::TakeFrames(const std::vector<WrittenROI>& rois)
{
  bool areNamed = true;
  for (const WrittenROI& roi : rois)
  {
    const std::string& drawn = roi.Description.FrameOfReferenceUID;
    const std::string frame = this->Reference.FrameFor(drawn);
    areNamed = areNamed && !drawn.empty();
    if (std::find(this->Frames.begin(), this->Frames.end(), frame) == this->Frames.end())
    {
      this->Frames.push_back(frame);
    }
  }
  const std::vector<std::string>& known = this->Reference.GetFrames();
  if (!areNamed && known.size() > 1)
  {
    this->Report.push_back("The reference has " + std::to_string(known.size()) +
      " frames of reference; new ROIs that name none are written in the first, " + known.front() +
      ", and refer to its images only.");
  }
}

void Formatter::ReportContoursOnNoSlice(std::size_t contours)
{
  if (this->ContoursOnNoSlice == 0 || this->Reference.IsNone())
  {
    return;
  }
  std::size_t slices = 0;
  for (const std::string& frame : this->Frames)
  {
    slices += this->Reference.GetSlices(frame).GetSlices().size();
  }
  this->Report.push_back(std::to_string(this->ContoursOnNoSlice) + " of " +
    Counted(contours, "contour") + " lie on none of the " + Counted(slices, "image") +
    " whose planes the reference tells, and refer to none.");
}

void Formatter::Format(std::vector<WrittenROI>& rois, Monitor& monitor)
{
  // Texts are converted before any is copied.
  this->SelectCharacterSet(rois);
  this->TakeFrames(rois);
  this->AddPatientAndStudy();
  this->AddSeries();
  this->Reference.AddImagesTo(this->Data(), this->Frames);
  if (this->Reference.IsStructureSet() && this->Options.CopyReferenceROIs)
  {
    this->CopyROIs();
  }
  this->NameROIs(rois);
  std::size_t contours = 0;
  for (std::size_t r = 0; r < rois.size(); ++r)
  {
    monitor.Update(static_cast<double>(r) / static_cast<double>(rois.size()), "writing contours");
    this->AddROI(rois[r]);
    contours += rois[r].Contours.size();
  }
  this->ReportContoursOnNoSlice(contours);
}

void Formatter::Save(const std::string& fileName)
{
  const auto fail = [&fileName](const std::string& why)
  {
    throw Error("Cannot write " + fileName +
      ": its folder cannot be written to, or the disk is full" + why + ".");
  };
  ReplacedFile replaced(fileName);
  const OFCondition condition = this->File.saveFile(
    replaced.GetPart().c_str(), EXS_LittleEndianImplicit, EET_ExplicitLength, EGL_withoutGL);
  if (condition.bad())
  {
    fail(" (DCMTK says: " + std::string(condition.text()) + ")");
  }
  // DCMTK does not notice that the last of its buffers did not reach the disk.
  const Uint32 whole =
    this->File.getMetaInfo()->calcElementLength(EXS_LittleEndianExplicit, EET_ExplicitLength) +
    this->File.getDataset()->calcElementLength(EXS_LittleEndianImplicit, EET_ExplicitLength);
  std::error_code status;
  const auto written = std::filesystem::file_size(replaced.GetPart(), status);
  if (status || written != whole)
  {
    fail(" (" + std::to_string(status ? 0 : written) + " of " + std::to_string(whole) +
      " bytes were written)");
  }
  replaced.Commit();
}
}

namespace
{
/// Leaves out ROIs that were drawn in a frame of reference that the reference does not have.
/// @throws Error where that is all of them
void LeaveOutOtherFrames(std::vector<WrittenROI>& rois, const StructureSetReference& reference,
  const std::string& path, std::vector<std::string>& report)
{
  std::vector<WrittenROI> kept;
  std::string sentence;
  for (WrittenROI& roi : rois)
  {
    const std::string& drawn = roi.Description.FrameOfReferenceUID;
    if (reference.HasFrame(drawn))
    {
      kept.push_back(std::move(roi));
      continue;
    }
    sentence = "ROI \"" + roi.Description.Name + "\" cannot be written with " + path +
      " as reference: " + reference.WhyNotIn(drawn);
    report.push_back(sentence);
  }
  if (kept.empty())
  {
    throw Error(sentence);
  }
  rois = std::move(kept);
}
}

std::vector<std::string> WriteStructureSet(const std::string& fileName,
  std::vector<WrittenROI> rois, const StructureSetOptions& options, Monitor& monitor)
{
  const QuietDCMTK quiet;
  std::vector<std::string> report;
  for (WrittenROI& roi : rois)
  {
    CheckContours(roi, options.ExclusiveOr, report);
  }
  rois.erase(std::remove_if(rois.begin(), rois.end(),
               [](const WrittenROI& roi) { return roi.Contours.empty(); }),
    rois.end());
  if (rois.empty())
  {
    throw Error("There are no contours to write.");
  }
  const ReplacedFile isWritable(fileName); // said before the reference is read
  std::optional<StructureSetReference> reference;
  if (options.Reference.empty())
  {
    reference.emplace();
    report.push_back("No reference is set: the file names no patient and no images, so that "
                     "planning systems will not show it on any.");
  }
  else
  {
    SubMonitor reading(monitor, 0, 0.4);
    reference.emplace(options.Reference, reading);
  }
  if (reference->IsPartOfIt(fileName))
  {
    throw Error("Cannot write " + fileName +
      ": it is the reference itself, which is not overwritten; give another name.");
  }
  report.insert(report.end(), reference->GetReport().begin(), reference->GetReport().end());
  LeaveOutOtherFrames(rois, *reference, options.Reference, report);
  SubMonitor writing(monitor, 0.4, 0.9);
  Formatter formatter(options, *reference, report);
  formatter.Format(rois, writing);
  monitor.Update(0.9, "saving");
  formatter.Save(fileName);
  return report;
}
}
