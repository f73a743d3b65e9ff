// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/StructureSetReference.h"

#include "Contours/ContourPlanes.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace recon
{
namespace
{
[[noreturn]] void Fail(const std::string& path, const std::string& sentence)
{
  throw Error("Cannot take " + path + " as reference: " + sentence);
}

bool IsImage(DcmItem& data)
{
  double ignored = 0;
  return GetNumber(data, DCM_ImagePositionPatient, 2, ignored) &&
    GetNumber(data, DCM_ImageOrientationPatient, 5, ignored);
}

/// Twice the area of a closed contour along its normal (Newell).
Vector3 AreaVector(const std::vector<Point3>& points)
{
  Vector3 sum{ 0, 0, 0 };
  for (std::size_t i = 1; i + 1 < points.size(); ++i)
  {
    sum = sum + Cross(points[i] - points[0], points[i + 1] - points[0]);
  }
  return sum;
}

double MeanOffset(const std::vector<Point3>& points, const Vector3& normal)
{
  double sum = 0;
  for (const Point3& p : points)
  {
    sum += Dot(normal, p);
  }
  return sum / static_cast<double>(points.size());
}

/// The largest contour that a structure set has on an image.
struct DrawnImage
{
  ReferenceSlice Slice;
  Vector3 Area{ 0, 0, 0 };
  std::vector<Point3> Points;
};

void GetCount(DcmItem& image, const DcmTagKey& key, int& count)
{
  Uint16 value = 0;
  if (image.findAndGetUint16(key, value).good() && value > 0)
  {
    count = value;
  }
}

ReferenceSlice SliceOfImage(DcmItem& image)
{
  ReferenceSlice slice;
  slice.ClassUID = GetText(image, DCM_SOPClassUID);
  slice.InstanceUID = GetText(image, DCM_SOPInstanceUID);
  Vector3 row{};
  Vector3 column{};
  Point3 corner{};
  for (unsigned long a = 0; a < 3; ++a)
  {
    GetNumber(image, DCM_ImageOrientationPatient, a, row[a]);
    GetNumber(image, DCM_ImageOrientationPatient, a + 3, column[a]);
    GetNumber(image, DCM_ImagePositionPatient, a, corner[a]);
  }
  slice.Normal = SliceNormal(Cross(row, column));
  slice.Offset = Dot(slice.Normal, corner);
  // The position is the centre of the first pixel; the first spacing is that of the rows.
  double spacing[2] = { 1, 1 };
  int rows = 1;
  int columns = 1;
  GetNumber(image, DCM_PixelSpacing, 0, spacing[0]);
  GetNumber(image, DCM_PixelSpacing, 1, spacing[1]);
  GetCount(image, DCM_Rows, rows);
  GetCount(image, DCM_Columns, columns);
  const Vector3 across = (columns * spacing[1]) * row;
  const Vector3 down = (rows * spacing[0]) * column;
  const Point3 start = corner - (0.5 * spacing[1] * row + 0.5 * spacing[0] * column);
  slice.Outline = { start, start + across, start + across + down, start + down };
  return slice;
}

/// A rectangle at the slice's offset, 1 mm around the other slices' contours as well.
void OutlineDrawn(const std::vector<DrawnImage>& drawn, std::vector<ReferenceSlice>& slices)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (ReferenceSlice& slice : slices)
  {
    const PlanarFrame frame = MakeFrame(slice.Normal);
    Point2 low{ infinity, infinity };
    Point2 high{ -infinity, -infinity };
    for (const DrawnImage& image : drawn)
    {
      for (const Point3& p : image.Points)
      {
        const Point2 q = frame.ToPlane(p);
        for (int a = 0; a < 2; ++a)
        {
          low[a] = std::min(low[a], q[a] - 1);
          high[a] = std::max(high[a], q[a] + 1);
        }
      }
    }
    slice.Outline = { frame.ToSpace(low, slice.Offset),
      frame.ToSpace({ high[0], low[1] }, slice.Offset), frame.ToSpace(high, slice.Offset),
      frame.ToSpace({ low[0], high[1] }, slice.Offset) };
  }
}

/// Images that the reference lists in a frame of reference, of known plane or not.
std::set<std::string> ListedImages(DcmItem& data, const std::string& frameOfReference)
{
  std::set<std::string> listed;
  for (DcmItem* frame : ItemsOf(data, DCM_ReferencedFrameOfReferenceSequence))
  {
    if (GetText(*frame, DCM_FrameOfReferenceUID) != frameOfReference)
    {
      continue;
    }
    for (DcmItem* study : ItemsOf(*frame, DCM_RTReferencedStudySequence))
    {
      for (DcmItem* series : ItemsOf(*study, DCM_RTReferencedSeriesSequence))
      {
        for (DcmItem* image : ItemsOf(*series, DCM_ContourImageSequence))
        {
          listed.insert(GetText(*image, DCM_ReferencedSOPInstanceUID));
        }
      }
    }
  }
  return listed;
}

/// Removes the items of a sequence that wanted() refuses, and the sequence where none is left.
template <typename Wanted>
void Prune(DcmItem& parent, const DcmTagKey& key, Wanted wanted)
{
  DcmElement* element = nullptr;
  if (parent.findAndGetElement(key, element).bad())
  {
    return;
  }
  if (auto* sequence = dynamic_cast<DcmSequenceOfItems*>(element))
  {
    for (DcmItem* item : ItemsOf(*sequence))
    {
      if (!wanted(*item))
      {
        delete sequence->remove(item);
      }
    }
  }
  if (ItemsOf(parent, key).empty())
  {
    parent.findAndDeleteElement(key);
  }
}

bool HasItems(DcmItem& item, const DcmTagKey& key)
{
  return !ItemsOf(item, key).empty();
}

void AddImage(const std::string& classUID, const std::string& instanceUID, DcmItem& parent)
{
  DcmItem& item = AppendItem(parent, DCM_ContourImageSequence);
  Put(item, DCM_ReferencedSOPClassUID, classUID);
  Put(item, DCM_ReferencedSOPInstanceUID, instanceUID);
}
}

StructureSetReference::StructureSetReference() : FrameOfReferenceUID(NewUID()) {}

StructureSetReference::StructureSetReference(const std::string& path, Monitor& monitor)
{
  std::error_code status;
  if (std::filesystem::is_directory(path, status))
  {
    this->TakeImages(path, "", monitor);
    return;
  }
  LoadDICOM(path, this->File);
  const std::string classUID = GetText(this->Data(), DCM_SOPClassUID);
  if (classUID == UID_RTStructureSetStorage)
  {
    this->TakeStructureSet(path, monitor);
  }
  else if (IsImage(this->Data()))
  {
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    this->TakeImages(folder.string(), GetText(this->Data(), DCM_SeriesInstanceUID), monitor);
  }
  else
  {
    Fail(path,
      "it is a DICOM object of class " + (classUID.empty() ? "(none)" : ClassName(classUID)) +
        ", expected an RT structure set, or a single-frame image with position and orientation.");
  }
}

void StructureSetReference::TakeStructureSet(const std::string& path, Monitor& monitor)
{
  this->Kind = KindOfReference::StructureSet;
  this->FileNames = { path };
  this->TakeFrameOfReference();
  const std::set<std::string> listed = ListedImages(this->Data(), this->FrameOfReferenceUID);
  std::vector<ReferenceSlice> slices = this->SlicesDrawnOn(monitor);
  if (ItemsOf(this->Data(), DCM_ReferencedFrameOfReferenceSequence).size() > 1)
  {
    // Coordinates of two frames of reference have nothing to do with each other.
    slices.erase(
      std::remove_if(slices.begin(), slices.end(),
        [&listed](const ReferenceSlice& slice) { return listed.count(slice.InstanceUID) == 0; }),
      slices.end());
  }
  const std::size_t count = std::max(slices.size(), listed.size());
  this->Slices = ReferenceSlices(std::move(slices), count);
}

void StructureSetReference::TakeFrameOfReference()
{
  std::set<std::string> frames;
  const auto take = [&](const std::string& uid)
  {
    if (!uid.empty() && frames.insert(uid).second && frames.size() == 1)
    {
      this->FrameOfReferenceUID = uid;
    }
  };
  for (DcmItem* frame : ItemsOf(this->Data(), DCM_ReferencedFrameOfReferenceSequence))
  {
    take(GetText(*frame, DCM_FrameOfReferenceUID));
  }
  if (frames.size() > 1)
  {
    this->Report.push_back("The reference has " + std::to_string(frames.size()) +
      " frames of reference; the new ROIs are written in the first, " + this->FrameOfReferenceUID +
      ", and refer to its images only.");
  }
  if (frames.empty())
  {
    take(GetText(this->Data(), DCM_FrameOfReferenceUID));
  }
  if (frames.empty())
  {
    this->FrameOfReferenceUID = NewUID();
    this->Report.push_back("The reference names no frame of reference, so the new file has one of "
                           "its own: no image is known to share it.");
  }
}

std::vector<ReferenceSlice> StructureSetReference::SlicesDrawnOn(Monitor& monitor)
{
  std::map<std::string, DrawnImage> drawn;
  Vector3 largest{ 0, 0, 0 };
  int malformed = 0;
  const std::vector<DcmItem*> rois = ItemsOf(this->Data(), DCM_ROIContourSequence);
  for (std::size_t r = 0; r < rois.size(); ++r)
  {
    monitor.Update(
      static_cast<double>(r) / static_cast<double>(rois.size()), "reading the reference");
    for (DcmItem* contour : ItemsOf(*rois[r], DCM_ContourSequence))
    {
      const std::vector<DcmItem*> images = ItemsOf(*contour, DCM_ContourImageSequence);
      // Several images, for a contour between two: it is in the plane of neither.
      if (images.size() != 1)
      {
        continue;
      }
      ContourPoints read = GetContourPoints(*contour);
      malformed += read.Fault.empty() ? 0 : 1;
      std::vector<Point3>& points = read.Points;
      if (points.empty())
      {
        continue;
      }
      const std::string uid = GetText(*images[0], DCM_ReferencedSOPInstanceUID);
      const Vector3 area = AreaVector(points);
      DrawnImage& image = drawn[uid];
      if (image.Points.empty() || Norm(area) > Norm(image.Area))
      {
        image.Slice.InstanceUID = uid;
        image.Slice.ClassUID = GetText(*images[0], DCM_ReferencedSOPClassUID);
        image.Area = area;
        image.Points = std::move(points);
      }
      if (Norm(area) > Norm(largest))
      {
        largest = area;
      }
    }
  }
  if (malformed > 0)
  {
    this->Report.push_back("The reference has " + std::to_string(malformed) +
      " malformed contours; they tell no plane, and are copied as they are.");
  }
  std::vector<ReferenceSlice> slices;
  std::vector<DrawnImage> kept;
  for (auto& [uid, image] : drawn)
  {
    // The normal of a small contour is noise: rounded coordinates, and tips of almost no area.
    constexpr double large = 100; // mm2
    image.Slice.Normal = SliceNormal(Norm(image.Area) > large ? image.Area : largest);
    image.Slice.Offset = MeanOffset(image.Points, image.Slice.Normal);
    if (Norm(image.Slice.Normal) > 0)
    {
      slices.push_back(image.Slice);
      kept.push_back(std::move(image));
    }
  }
  OutlineDrawn(kept, slices);
  return slices;
}

void StructureSetReference::TakeImages(
  const std::string& folder, const std::string& seriesUID, Monitor& monitor)
{
  this->Kind = KindOfReference::Images;
  std::vector<std::filesystem::path> paths;
  std::error_code status;
  for (const auto& entry : std::filesystem::directory_iterator(folder, status))
  {
    if (entry.is_regular_file(status))
    {
      paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  std::string series = seriesUID;
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    monitor.Update(
      static_cast<double>(i) / static_cast<double>(paths.size()), "reading the reference");
    DcmFileFormat file;
    // A file without preamble in a folder of anything is not tried: any file might be one.
    const OFCondition condition = file.loadFileUntilTag(
      paths[i].c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_fileOnly, DCM_PixelData);
    DcmItem& data = *file.getDataset();
    if (condition.bad() || !IsImage(data))
    {
      continue;
    }
    const std::string ofSeries = GetText(data, DCM_SeriesInstanceUID);
    if (series.empty())
    {
      series = ofSeries;
    }
    if (ofSeries != series)
    {
      if (seriesUID.empty())
      {
        Fail(
          folder, "it has images of several series; give one image of the series that is meant.");
      }
      continue;
    }
    this->Images.push_back(SliceOfImage(data));
    this->FileNames.push_back(paths[i].string());
    if (this->Images.size() == 1)
    {
      this->File = file;
    }
  }
  if (this->Images.empty())
  {
    Fail(folder, "there are no images with position and orientation in it.");
  }
  this->TakeFrameOfReference();
  this->Slices = ReferenceSlices(this->Images, this->Images.size());
}

bool StructureSetReference::IsPartOfIt(const std::string& fileName) const
{
  return std::any_of(this->FileNames.begin(), this->FileNames.end(),
    [&fileName](const std::string& part)
    {
      std::error_code status;
      return std::filesystem::equivalent(part, fileName, status) && !status;
    });
}

void StructureSetReference::AddImagesTo(DcmItem& data)
{
  if (this->IsStructureSet())
  {
    this->CopyFrames(data);
  }
  if (!HasItems(data, DCM_ReferencedFrameOfReferenceSequence))
  {
    this->MakeFrame(data);
  }
}

void StructureSetReference::CopyFrames(DcmItem& data)
{
  CopyElement(this->Data(), DCM_ReferencedFrameOfReferenceSequence, data);
  // Series without images and studies without series are what some writers leave and the standard
  // forbids.
  const auto hasImages = [](DcmItem& series) { return HasItems(series, DCM_ContourImageSequence); };
  const auto hasSeries = [&](DcmItem& study)
  {
    Prune(study, DCM_RTReferencedSeriesSequence, hasImages);
    return HasItems(study, DCM_RTReferencedSeriesSequence);
  };
  const auto hasUID = [&](DcmItem& frame)
  {
    Prune(frame, DCM_RTReferencedStudySequence, hasSeries);
    return !GetText(frame, DCM_FrameOfReferenceUID).empty();
  };
  Prune(data, DCM_ReferencedFrameOfReferenceSequence, hasUID);
}

void StructureSetReference::MakeFrame(DcmItem& data)
{
  DcmItem& frame = AppendItem(data, DCM_ReferencedFrameOfReferenceSequence);
  Put(frame, DCM_FrameOfReferenceUID, this->FrameOfReferenceUID);
  if (this->Images.empty())
  {
    return;
  }
  DcmItem& image = this->Data();
  DcmItem& study = AppendItem(frame, DCM_RTReferencedStudySequence);
  // The class is retired, and what the standard still wants here.
  Put(study, DCM_ReferencedSOPClassUID, UID_RETIRED_DetachedStudyManagementSOPClass);
  Put(study, DCM_ReferencedSOPInstanceUID, GetText(image, DCM_StudyInstanceUID));
  DcmItem& series = AppendItem(study, DCM_RTReferencedSeriesSequence);
  Put(series, DCM_SeriesInstanceUID, GetText(image, DCM_SeriesInstanceUID));
  for (const ReferenceSlice& slice : this->Images)
  {
    AddImage(slice.ClassUID, slice.InstanceUID, series);
  }
}

std::vector<ReferenceSlice> ReadReferenceSlices(const std::string& path, Monitor& monitor)
{
  const QuietDCMTK quiet;
  const StructureSetReference reference(path, monitor);
  std::vector<ReferenceSlice> slices = reference.GetSlices().GetSlices();
  if (slices.empty())
  {
    Fail(path, "it does not say which image any of its contours lies on, so it tells no slices.");
  }
  std::stable_sort(slices.begin(), slices.end(),
    [](const ReferenceSlice& a, const ReferenceSlice& b) { return a.Offset < b.Offset; });
  return slices;
}
}
