// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/StructureSetFile.h"

#include "DICOM/DICOMItem.h"

#include <dcmtk/dcmdata/dcspchrs.h>
#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string_view>

namespace recon
{
namespace
{
enum class Shape
{
  Points,
  Open,
  Closed
};

Shape ShapeOf(const std::string& geometricType)
{
  if (geometricType == "POINT")
  {
    return Shape::Points;
  }
  const bool isOpen = geometricType == "OPEN_PLANAR" || geometricType == "OPEN_NONPLANAR";
  return isOpen ? Shape::Open : Shape::Closed;
}

bool IsKnown(const std::string& geometricType)
{
  return ShapeOf(geometricType) != Shape::Closed || geometricType == "CLOSED_PLANAR" ||
    geometricType == "CLOSEDPLANAR_XOR";
}
}

class StructureSetFile::Internals
{
public:
  explicit Internals(const std::string& fileName) : FileName(fileName) {}

  void Open()
  {
    const QuietDCMTK quiet;
    LoadDICOM(this->FileName, this->File);
    this->CheckClass();
    this->SelectCharacterSet();
    this->ReadROIs();
    this->ReadContourItems();
    this->ReadTypes();
    this->MakeNamesUnique();
  }

  StructureSetContours ReadContours(int index, Monitor& monitor);

  std::vector<StructureSetROI> ROIs;
  std::vector<std::string> Report;

private:
  [[noreturn]] void Fail(const std::string& sentence) const
  {
    throw Error("Cannot read " + this->FileName + ": " + sentence);
  }

  void CheckClass();
  void SelectCharacterSet();
  void ReadROIs();
  void ReadContourItems();
  void ReadTypes();
  void MakeNamesUnique();

  std::string ToUTF8(const std::string& text, int number);
  int IndexOf(int number, const char* sequence);
  std::string NameOf(int index) const { return "ROI \"" + this->ROIs[index].Name + "\""; }
  /// The sequence, or nullptr where the item has none; other things under its tag are an error.
  DcmSequenceOfItems* FindSequence(DcmItem& item, const DcmTagKey& key) const;

  std::string FileName;
  DcmFileFormat File;
  DcmSpecificCharacterSet CharacterSet;
  bool CanConvert = false;
  std::map<int, int> IndexOfNumber;
  std::vector<std::vector<DcmItem*>> ContourItems; ///< for each of ROIs
};

void StructureSetFile::Internals::CheckClass()
{
  const std::string uid = GetText(*this->File.getDataset(), DCM_SOPClassUID);
  if (uid == UID_RTStructureSetStorage)
  {
    return;
  }
  if (uid.empty())
  {
    this->Fail("it is no DICOM file or is damaged: " + TagName(DCM_SOPClassUID) + " is missing.");
  }
  this->Fail("it is a DICOM object of class " + ClassName(uid) +
    ", expected an RT structure set (RTStructureSetStorage).");
}

void StructureSetFile::Internals::SelectCharacterSet()
{
  this->CanConvert = DcmSpecificCharacterSet::isConversionAvailable() &&
    this->CharacterSet.selectCharacterSet(*this->File.getDataset()).good();
}

std::string StructureSetFile::Internals::ToUTF8(const std::string& text, int number)
{
  const auto isPlain = [](char c) { return static_cast<unsigned char>(c) < 0x80; };
  if (std::all_of(text.begin(), text.end(), isPlain))
  {
    return text;
  }
  OFString converted;
  if (this->CanConvert &&
    this->CharacterSet.convertString(OFString(text.c_str(), text.size()), converted).good())
  {
    return std::string(converted.c_str(), converted.size());
  }
  std::string plain = text;
  std::replace_if(
    plain.begin(), plain.end(), [&](char c) { return !isPlain(c); }, '?');
  this->Report.push_back("ROI number " + std::to_string(number) +
    ": its name has letters that the file's character set does not explain; they show as '?'.");
  return plain;
}

DcmSequenceOfItems* StructureSetFile::Internals::FindSequence(
  DcmItem& item, const DcmTagKey& key) const
{
  DcmElement* element = nullptr;
  if (item.findAndGetElement(key, element).bad() || !element)
  {
    return nullptr;
  }
  auto* sequence = dynamic_cast<DcmSequenceOfItems*>(element);
  if (!sequence)
  {
    this->Fail("expected a sequence under tag " + TagName(key) + ", found VR " +
      DcmVR(element->ident()).getVRName() + ".");
  }
  return sequence;
}

void StructureSetFile::Internals::ReadROIs()
{
  DcmSequenceOfItems* sequence =
    this->FindSequence(*this->File.getDataset(), DCM_StructureSetROISequence);
  if (!sequence || sequence->card() == 0)
  {
    this->Fail("it has no ROIs: " + TagName(DCM_StructureSetROISequence) +
      " is missing or empty (is the file truncated?).");
  }
  for (DcmItem* item : ItemsOf(*sequence))
  {
    StructureSetROI roi;
    if (!GetNumber(*item, DCM_ROINumber, roi.Number))
    {
      this->Fail("item " + std::to_string(this->ROIs.size() + 1) + " of " +
        TagName(DCM_StructureSetROISequence) + " has no " + TagName(DCM_ROINumber) + ".");
    }
    roi.Name = this->ToUTF8(GetText(*item, DCM_ROIName), roi.Number);
    if (roi.Name.empty())
    {
      roi.Name = "ROI " + std::to_string(roi.Number);
    }
    if (!this->IndexOfNumber.emplace(roi.Number, static_cast<int>(this->ROIs.size())).second)
    {
      this->Fail("two ROIs have the number " + std::to_string(roi.Number) +
        ", so that it is open which contours are whose.");
    }
    this->ROIs.push_back(std::move(roi));
  }
  this->ContourItems.resize(this->ROIs.size());
}

int StructureSetFile::Internals::IndexOf(int number, const char* sequence)
{
  const auto found = this->IndexOfNumber.find(number);
  if (found != this->IndexOfNumber.end())
  {
    return found->second;
  }
  this->Report.push_back(std::string(sequence) + " refers to ROI number " + std::to_string(number) +
    ", which the file does not list; left out.");
  return -1;
}

void StructureSetFile::Internals::ReadContourItems()
{
  DcmSequenceOfItems* sequence =
    this->FindSequence(*this->File.getDataset(), DCM_ROIContourSequence);
  if (!sequence || sequence->card() == 0)
  {
    this->Fail("it has no contours: " + TagName(DCM_ROIContourSequence) +
      " is missing or empty (is the file truncated?).");
  }
  for (DcmItem* item : ItemsOf(*sequence))
  {
    int number = 0;
    if (!GetNumber(*item, DCM_ReferencedROINumber, number))
    {
      this->Fail("an item of " + TagName(DCM_ROIContourSequence) + " has no " +
        TagName(DCM_ReferencedROINumber) + ", so that it is open whose contours these are.");
    }
    const int index = this->IndexOf(number, "The contour sequence");
    if (index < 0)
    {
      continue;
    }
    StructureSetROI& roi = this->ROIs[index];
    std::vector<int> color;
    ForEachValue(GetText(*item, DCM_ROIDisplayColor),
      [&color](std::string_view value)
      {
        int component = 0;
        if (ParseInteger(value, component) && component >= 0 && component <= 255)
        {
          color.push_back(component);
        }
      });
    if (color.size() == 3)
    {
      roi.HasColor = true;
      roi.Color = { color[0], color[1], color[2] };
    }
    if (DcmSequenceOfItems* contours = this->FindSequence(*item, DCM_ContourSequence))
    {
      const std::vector<DcmItem*> items = ItemsOf(*contours);
      std::vector<DcmItem*>& all = this->ContourItems[index];
      all.insert(all.end(), items.begin(), items.end());
      roi.NumberOfContours = static_cast<int>(all.size());
    }
  }
}

void StructureSetFile::Internals::ReadTypes()
{
  DcmSequenceOfItems* sequence =
    this->FindSequence(*this->File.getDataset(), DCM_RTROIObservationsSequence);
  if (!sequence)
  {
    this->Report.push_back(
      TagName(DCM_RTROIObservationsSequence) + " is missing: the types of the ROIs are unknown.");
    return;
  }
  for (DcmItem* item : ItemsOf(*sequence))
  {
    int number = 0;
    if (!GetNumber(*item, DCM_ReferencedROINumber, number))
    {
      continue;
    }
    const int index = this->IndexOf(number, "The observations sequence");
    if (index >= 0)
    {
      this->ROIs[index].Type = GetText(*item, DCM_RTROIInterpretedType);
    }
  }
}

void StructureSetFile::Internals::MakeNamesUnique()
{
  std::map<std::string, int> uses;
  for (const StructureSetROI& roi : this->ROIs)
  {
    ++uses[roi.Name];
  }
  std::set<std::string> taken;
  for (StructureSetROI& roi : this->ROIs)
  {
    if (uses[roi.Name] > 1)
    {
      this->Report.push_back("Several ROIs have the name \"" + roi.Name + "\"; that with number " +
        std::to_string(roi.Number) + " is shown with its number.");
      roi.Name += " (" + std::to_string(roi.Number) + ")";
    }
    while (!taken.insert(roi.Name).second)
    {
      roi.Name += "'";
    }
  }
}

StructureSetContours StructureSetFile::Internals::ReadContours(int index, Monitor& monitor)
{
  const QuietDCMTK quiet;
  StructureSetContours result;
  LoopSoup& soup = result.File.Soup;
  const std::vector<DcmItem*>& items = this->ContourItems[index];
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    monitor.Update(static_cast<double>(i) / static_cast<double>(items.size()), "reading contours");
    const std::string where = this->NameOf(index) + ", contour " + std::to_string(i + 1);
    const std::vector<Point3> points =
      GetContourPoints(*items[i], "Cannot read " + this->FileName + ": " + where);
    if (points.empty())
    {
      result.File.Report.push_back(where + ": left out, it has no contour data.");
      continue;
    }
    int announced = 0;
    if (GetNumber(*items[i], DCM_NumberOfContourPoints, announced) &&
      announced != static_cast<int>(points.size()))
    {
      result.File.Report.push_back(where + ": announces " + std::to_string(announced) +
        " points and has " + std::to_string(points.size()) + "; all of these were read.");
    }
    const std::string type = GetText(*items[i], DCM_ContourGeometricType);
    if (!IsKnown(type))
    {
      result.File.Report.push_back(where + ": its geometric type '" + type +
        "' is none that DICOM knows; it was taken for a closed contour.");
    }
    const int first = static_cast<int>(soup.Points.size());
    soup.Points.insert(soup.Points.end(), points.begin(), points.end());
    const Shape shape = ShapeOf(type);
    LoopSoup::Chain chain;
    chain.Closed = shape == Shape::Closed;
    chain.Source = static_cast<int>(i);
    for (int p = first; p < static_cast<int>(soup.Points.size()); ++p)
    {
      chain.Points.push_back(p);
      if (shape == Shape::Points)
      {
        soup.Chains.push_back(chain);
        result.GeometricTypes.push_back(type);
        chain.Points.clear();
      }
    }
    if (!chain.Points.empty())
    {
      soup.Chains.push_back(std::move(chain));
      result.GeometricTypes.push_back(type);
    }
  }
  if (items.empty())
  {
    result.File.Report.push_back(this->NameOf(index) + ": it has no contours.");
  }
  return result;
}

bool StructureSetFile::IsStructureSet(const std::string& fileName)
{
  std::error_code status;
  if (!std::filesystem::is_regular_file(fileName, status))
  {
    return false;
  }
  const QuietDCMTK quiet;
  DcmFileFormat file;
  const OFCondition condition = file.loadFileUntilTag(
    fileName.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect, DCM_StudyDate);
  return condition.good() &&
    GetText(*file.getDataset(), DCM_SOPClassUID) == UID_RTStructureSetStorage;
}

StructureSetFile::StructureSetFile(const std::string& fileName)
  : Implementation(std::make_unique<Internals>(fileName))
{
  this->Implementation->Open();
}

StructureSetFile::~StructureSetFile() = default;

const std::vector<StructureSetROI>& StructureSetFile::GetROIs() const
{
  return this->Implementation->ROIs;
}

const std::vector<std::string>& StructureSetFile::GetReport() const
{
  return this->Implementation->Report;
}

StructureSetContours StructureSetFile::ReadContours(int index, Monitor& monitor)
{
  return this->Implementation->ReadContours(index, monitor);
}
}
