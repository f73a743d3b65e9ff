// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/StructureSetFile.h"

#include "Base/Text.h"
#include "DICOM/DICOMCharacterSet.h"
#include "DICOM/DICOMItem.h"
#include "DICOM/LoadDICOM.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
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

namespace
{
/// What may be odd about a contour, the most important first.
enum class Oddity
{
  NoNumber,
  NoTriples,
  NoData,
  UnknownType,
  OtherCount
};

/// A line a kind, however many contours have it.
class ContourOddities
{
public:
  explicit ContourOddities(const std::string& roi) : ROI(roi) {}

  /// what completes "ROI "Lung", contour 3: "
  void Add(Oddity kind, int contour, const std::string& what)
  {
    Found& found = this->Kinds[kind];
    found.Contours.push_back(contour);
    found.What = found.Contours.size() == 1 ? what : found.What;
  }

  std::vector<std::string> Lines() const
  {
    constexpr std::size_t most = 3;
    std::vector<std::string> lines;
    for (const auto& [kind, found] : this->Kinds)
    {
      const std::size_t count = found.Contours.size();
      lines.push_back(this->ROI + ", contour" + (count > 1 ? "s " : " ") +
        Listed(found.Contours, most) + ": " + found.What + (count > 1 ? " (the first)." : "."));
    }
    return lines;
  }

private:
  struct Found
  {
    std::vector<int> Contours;
    std::string What; ///< of the first
  };
  std::string ROI;
  std::map<Oddity, Found> Kinds;
};
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
    this->CharacterSet = DICOMCharacterSet(GetText(this->Data(), DCM_SpecificCharacterSet));
    this->ReadROIs();
    this->LeaveOutNumbersUsedTwice();
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
  DcmItem& Data() { return *this->File.getDataset(); }

  void CheckClass();
  void ReadROIs();
  void LeaveOutNumbersUsedTwice();
  void ReadContourItems();
  void ReadContourItem(DcmItem& item, bool isLast);
  void ReadTypes();
  void MakeNamesUnique();

  DecodedText TextOfName(DcmItem& item) const;
  std::string NameFrom(DcmItem& item, int number);
  std::string FrameFrom(DcmItem& item);
  int IndexOf(int number, const char* sequence);
  std::string NameOf(int index) const { return "ROI \"" + this->ROIs[index].Name + "\""; }
  /// The sequence, or nullptr where there is none; other things under its tag are an error.
  DcmSequenceOfItems* FindSequence(const DcmTagKey& key);
  /// Adds an item of a contour sequence to the soup, counted from 0.
  void AddContour(
    DcmItem& item, int source, ContourOddities& oddities, StructureSetContours& contours) const;

  std::string FileName;
  DcmFileFormat File;
  DICOMCharacterSet CharacterSet{ "" };
  std::map<int, int> IndexOfNumber;                ///< -1 for numbers that several ROIs have
  std::vector<std::vector<DcmItem*>> ContourItems; ///< for each of ROIs
  std::map<int, std::string> WhyEmpty;             ///< by index, of ROIs that are left out
};

void StructureSetFile::Internals::CheckClass()
{
  const std::string uid = GetUID(this->Data(), DCM_SOPClassUID);
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

DecodedText StructureSetFile::Internals::TextOfName(DcmItem& item) const
{
  DecodedText name = this->CharacterSet.Decode(GetText(item, DCM_ROIName));
  // Control characters are no part of names, and would break the lines of a report.
  std::replace_if(
    name.Text.begin(), name.Text.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; },
    '_');
  return name;
}

std::string StructureSetFile::Internals::NameFrom(DcmItem& item, int number)
{
  const DecodedText name = this->TextOfName(item);
  if (name.Outcome != DecodedText::How::Explained)
  {
    this->Report.push_back("ROI number " + std::to_string(number) +
      ": its name has letters that the file's character set does not explain; they " +
      (name.Outcome == DecodedText::How::Guessed ? "were read as UTF-8." : "show as '?'."));
  }
  return name.Text.empty() ? "ROI " + std::to_string(number) : name.Text;
}

/// That of the ROI, or the only one of the file.
std::string StructureSetFile::Internals::FrameFrom(DcmItem& item)
{
  const std::string frame = GetUID(item, DCM_ReferencedFrameOfReferenceUID);
  if (!frame.empty())
  {
    return frame;
  }
  const std::vector<DcmItem*> frames =
    ItemsOf(this->Data(), DCM_ReferencedFrameOfReferenceSequence);
  return frames.size() == 1 ? GetUID(*frames[0], DCM_FrameOfReferenceUID)
    : frames.empty()        ? GetUID(this->Data(), DCM_FrameOfReferenceUID)
                            : std::string();
}

DcmSequenceOfItems* StructureSetFile::Internals::FindSequence(const DcmTagKey& key)
{
  DcmElement* element = nullptr;
  if (this->Data().findAndGetElement(key, element).bad() || !element)
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
  DcmSequenceOfItems* sequence = this->FindSequence(DCM_StructureSetROISequence);
  if (!sequence || sequence->card() == 0)
  {
    this->Fail("it has no ROIs: " + TagName(DCM_StructureSetROISequence) +
      " is missing or empty (is the file truncated?).");
  }
  int position = 0;
  for (DcmItem* item : ItemsOf(*sequence))
  {
    ++position;
    StructureSetROI roi;
    if (!GetNumber(*item, DCM_ROINumber, roi.Number))
    {
      this->Report.push_back("Item " + std::to_string(position) + " of " +
        TagName(DCM_StructureSetROISequence) + " (\"" + this->TextOfName(*item).Text +
        "\") has no " + TagName(DCM_ROINumber) +
        ", so that it is open which contours are its; left out.");
      continue;
    }
    roi.Name = this->NameFrom(*item, roi.Number);
    roi.FrameOfReferenceUID = this->FrameFrom(*item);
    this->ROIs.push_back(std::move(roi));
  }
  if (this->ROIs.empty())
  {
    this->Fail("none of its ROIs has a " + TagName(DCM_ROINumber) + ".");
  }
  this->ContourItems.resize(this->ROIs.size());
}

void StructureSetFile::Internals::LeaveOutNumbersUsedTwice()
{
  std::map<int, std::vector<int>> users;
  for (std::size_t i = 0; i < this->ROIs.size(); ++i)
  {
    users[this->ROIs[i].Number].push_back(static_cast<int>(i));
  }
  for (const auto& [number, indices] : users)
  {
    this->IndexOfNumber[number] = indices.size() == 1 ? indices[0] : -1;
    if (indices.size() == 1)
    {
      continue;
    }
    std::string names;
    for (const int i : indices)
    {
      names += (names.empty() ? "\"" : ", \"") + this->ROIs[i].Name + "\"";
    }
    this->Report.push_back("The ROIs " + names + " have one number, " + std::to_string(number) +
      ", so that it is open which contours are whose; their contours are left out.");
    for (const int i : indices)
    {
      this->WhyEmpty[i] = "its contours are left out, as its number " + std::to_string(number) +
        " is another ROI's as well.";
    }
  }
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
  DcmSequenceOfItems* sequence = this->FindSequence(DCM_ROIContourSequence);
  if (!sequence || sequence->card() == 0)
  {
    this->Fail("it has no contours: " + TagName(DCM_ROIContourSequence) +
      " is missing or empty (is the file truncated?).");
  }
  const std::vector<DcmItem*> items = ItemsOf(*sequence);
  for (DcmItem* item : items)
  {
    this->ReadContourItem(*item, item == items.back());
  }
}

void StructureSetFile::Internals::ReadContourItem(DcmItem& item, bool isLast)
{
  int number = 0;
  if (!GetNumber(item, DCM_ReferencedROINumber, number))
  {
    const std::string what = TagName(DCM_ROIContourSequence) + " has no " +
      TagName(DCM_ReferencedROINumber) + ", so that it is open whose contours these are";
    if (isLast && !this->Data().tagExists(DCM_RTROIObservationsSequence))
    {
      // The number follows the contours: a file that ends in them is cut off there.
      this->Fail("the last item of " + what + " (is the file truncated?).");
    }
    this->Report.push_back("An item of " + what + "; left out.");
    return;
  }
  const int index = this->IndexOf(number, "The contour sequence");
  if (index < 0)
  {
    return;
  }
  StructureSetROI& roi = this->ROIs[index];
  std::vector<int> color;
  ForEachValue(GetText(item, DCM_ROIDisplayColor),
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
  const std::vector<DcmItem*> items = ItemsOf(item, DCM_ContourSequence);
  std::vector<DcmItem*>& all = this->ContourItems[index];
  all.insert(all.end(), items.begin(), items.end());
  roi.NumberOfContours = static_cast<int>(all.size());
}

void StructureSetFile::Internals::ReadTypes()
{
  DcmSequenceOfItems* sequence = this->FindSequence(DCM_RTROIObservationsSequence);
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

void StructureSetFile::Internals::AddContour(
  DcmItem& item, int source, ContourOddities& oddities, StructureSetContours& contours) const
{
  const int number = source + 1;
  const ContourPoints points = GetContourPoints(item);
  if (!points.Fault.empty())
  {
    oddities.Add(points.HasNumbers ? Oddity::NoTriples : Oddity::NoNumber, number,
      "left out, " + points.Fault);
    return;
  }
  if (points.Points.empty())
  {
    oddities.Add(Oddity::NoData, number, "left out, it has no contour data");
    return;
  }
  int announced = 0;
  if (GetNumber(item, DCM_NumberOfContourPoints, announced) &&
    announced != static_cast<int>(points.Points.size()))
  {
    oddities.Add(Oddity::OtherCount, number,
      "announces " + std::to_string(announced) + " points and has " +
        std::to_string(points.Points.size()) + "; all of these were read");
  }
  const std::string type = GetText(item, DCM_ContourGeometricType);
  if (!IsKnown(type))
  {
    oddities.Add(Oddity::UnknownType, number,
      "its geometric type " + Quoted(type) +
        " is none that DICOM knows; it was taken for a closed contour");
  }
  LoopSoup& soup = contours.File.Soup;
  const Shape shape = ShapeOf(type);
  LoopSoup::Chain chain;
  chain.Closed = shape == Shape::Closed;
  chain.Source = source;
  for (const Point3& point : points.Points)
  {
    chain.Points.push_back(static_cast<int>(soup.Points.size()));
    soup.Points.push_back(point);
    if (shape == Shape::Points)
    {
      soup.Chains.push_back(chain);
      contours.GeometricTypes.push_back(type);
      chain.Points.clear();
    }
  }
  if (!chain.Points.empty())
  {
    soup.Chains.push_back(std::move(chain));
    contours.GeometricTypes.push_back(type);
  }
}

StructureSetContours StructureSetFile::Internals::ReadContours(int index, Monitor& monitor)
{
  const QuietDCMTK quiet;
  StructureSetContours result;
  const auto left = this->WhyEmpty.find(index);
  if (left != this->WhyEmpty.end())
  {
    result.File.Report.push_back(this->NameOf(index) + ": " + left->second);
    return result;
  }
  const std::vector<DcmItem*>& items = this->ContourItems[index];
  ContourOddities oddities(this->NameOf(index));
  for (std::size_t i = 0; i < items.size(); ++i)
  {
    monitor.Update(static_cast<double>(i) / static_cast<double>(items.size()), "reading contours");
    this->AddContour(*items[i], static_cast<int>(i), oddities, result);
  }
  result.File.Report = oddities.Lines();
  if (items.empty())
  {
    result.File.Report.push_back(this->NameOf(index) + ": it has no contours.");
  }
  return result;
}

bool StructureSetFile::IsStructureSet(const std::string& fileName)
{
  if (!BeginsAsDICOM(fileName))
  {
    return false;
  }
  const QuietDCMTK quiet;
  DcmFileFormat file;
  return LoadDICOMUntil(fileName, file, DCM_StudyDate).empty() &&
    GetUID(*file.getDataset(), DCM_SOPClassUID) == UID_RTStructureSetStorage;
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
