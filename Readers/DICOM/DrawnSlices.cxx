// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/DrawnSlices.h"

#include "Base/BoundingBox.h"
#include "Base/Geometry.h"

#include <utility>

namespace recon
{
namespace
{
/// The largest contour that a structure set has on an image.
struct DrawnImage
{
  ReferenceSlice Slice;
  Vector3 Area{ 0, 0, 0 };
  std::vector<Point3> Points;
};

/// The images of one frame of reference.
struct DrawnFrame
{
  std::map<std::string, DrawnImage> Images;
  Vector3 LargestArea{ 0, 0, 0 };
};

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

/// A rectangle at the slice's offset, 1 mm around the other slices' contours as well.
void OutlineDrawn(const std::vector<DrawnImage>& drawn, std::vector<ReferenceSlice>& slices)
{
  for (ReferenceSlice& slice : slices)
  {
    const PlanarFrame frame = PlanarFrame::About(slice.Normal);
    Box2 box;
    for (const DrawnImage& image : drawn)
    {
      for (const Point3& p : image.Points)
      {
        box.Add(frame.ToPlane(p));
      }
    }
    box = box.Grown(1);
    slice.Outline = { frame.ToSpace(box.Low, slice.Offset),
      frame.ToSpace({ box.High[0], box.Low[1] }, slice.Offset),
      frame.ToSpace(box.High, slice.Offset),
      frame.ToSpace({ box.Low[0], box.High[1] }, slice.Offset) };
  }
}

std::vector<ReferenceSlice> SlicesOf(DrawnFrame& frame)
{
  std::vector<ReferenceSlice> slices;
  std::vector<DrawnImage> kept;
  for (auto& [uid, image] : frame.Images)
  {
    // The normal of a small contour is noise: rounded coordinates, and tips of almost no area.
    constexpr double large = 100; // mm2
    image.Slice.Normal = SliceNormal(Norm(image.Area) > large ? image.Area : frame.LargestArea);
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

/// The frames of reference of the contours of a structure set.
class FramesOfContours
{
public:
  FramesOfContours(DcmItem& structureSet, const std::string& otherwise);

  const std::string& FrameOf(DcmItem& roiContours, const std::string& image) const;

private:
  const std::string& Otherwise;
  std::map<std::string, std::string> OfNumber; ///< of an ROI
  std::map<std::string, std::string> OfImage;
};

FramesOfContours::FramesOfContours(DcmItem& structureSet, const std::string& otherwise)
  : Otherwise(otherwise)
{
  for (DcmItem* roi : ItemsOf(structureSet, DCM_StructureSetROISequence))
  {
    const std::string frame = GetUID(*roi, DCM_ReferencedFrameOfReferenceUID);
    if (!frame.empty())
    {
      this->OfNumber.emplace(GetText(*roi, DCM_ROINumber), frame);
    }
  }
  for (DcmItem* item : ItemsOf(structureSet, DCM_ReferencedFrameOfReferenceSequence))
  {
    const std::string frame = GetUID(*item, DCM_FrameOfReferenceUID);
    for (const std::string& image : ListedImages(structureSet, frame))
    {
      this->OfImage.emplace(image, frame);
    }
  }
}

const std::string& FramesOfContours::FrameOf(DcmItem& roiContours, const std::string& image) const
{
  const auto ofROI = this->OfNumber.find(GetText(roiContours, DCM_ReferencedROINumber));
  if (ofROI != this->OfNumber.end())
  {
    return ofROI->second;
  }
  const auto ofImage = this->OfImage.find(image);
  return ofImage != this->OfImage.end() ? ofImage->second : this->Otherwise;
}

/// The image that a contour lies on; nullptr where it refers to none or to several, as a contour
/// between two images does, which is in the plane of neither.
DcmItem* ImageOf(DcmItem& contour)
{
  const std::vector<DcmItem*> images = ItemsOf(contour, DCM_ContourImageSequence);
  return images.size() == 1 ? images[0] : nullptr;
}

void AddContour(DcmItem& image, std::vector<Point3> points, DrawnFrame& frame)
{
  const Vector3 area = AreaVector(points);
  const std::string uid = GetUID(image, DCM_ReferencedSOPInstanceUID);
  DrawnImage& drawn = frame.Images[uid];
  if (drawn.Points.empty() || Norm(area) > Norm(drawn.Area))
  {
    drawn.Slice.InstanceUID = uid;
    drawn.Slice.ClassUID = GetUID(image, DCM_ReferencedSOPClassUID);
    drawn.Area = area;
    drawn.Points = std::move(points);
  }
  if (Norm(area) > Norm(frame.LargestArea))
  {
    frame.LargestArea = area;
  }
}
}

std::set<std::string> ListedImages(DcmItem& structureSet, const std::string& frame)
{
  std::set<std::string> listed;
  for (DcmItem* item : ItemsOf(structureSet, DCM_ReferencedFrameOfReferenceSequence))
  {
    if (GetUID(*item, DCM_FrameOfReferenceUID) != frame)
    {
      continue;
    }
    for (DcmItem* study : ItemsOf(*item, DCM_RTReferencedStudySequence))
    {
      for (DcmItem* series : ItemsOf(*study, DCM_RTReferencedSeriesSequence))
      {
        for (DcmItem* image : ItemsOf(*series, DCM_ContourImageSequence))
        {
          listed.insert(GetUID(*image, DCM_ReferencedSOPInstanceUID));
        }
      }
    }
  }
  return listed;
}

DrawnSlices ReadDrawnSlices(DcmItem& structureSet, const std::string& frame, Monitor& monitor)
{
  DrawnSlices result;
  const FramesOfContours frames(structureSet, frame);
  std::map<std::string, DrawnFrame> drawn;
  const std::vector<DcmItem*> rois = ItemsOf(structureSet, DCM_ROIContourSequence);
  for (std::size_t r = 0; r < rois.size(); ++r)
  {
    monitor.Update(
      static_cast<double>(r) / static_cast<double>(rois.size()), "reading the reference");
    for (DcmItem* contour : ItemsOf(*rois[r], DCM_ContourSequence))
    {
      DcmItem* image = ImageOf(*contour);
      ContourPoints points = image ? GetContourPoints(*contour) : ContourPoints();
      result.Malformed += points.Fault.empty() ? 0 : 1;
      if (!points.Points.empty())
      {
        const std::string uid = GetUID(*image, DCM_ReferencedSOPInstanceUID);
        AddContour(*image, std::move(points.Points), drawn[frames.FrameOf(*rois[r], uid)]);
      }
    }
  }
  for (auto& [uid, images] : drawn)
  {
    result.SlicesOfFrame[uid] = SlicesOf(images);
  }
  return result;
}
}
