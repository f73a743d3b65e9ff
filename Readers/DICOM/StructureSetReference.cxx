// SPDX-License-Identifier: GPL-3.0-or-later
#include "DICOM/StructureSetReference.h"

#include "Base/Text.h"
#include "DICOM/DrawnSlices.h"
#include "DICOM/LoadDICOM.h"
#include "DICOM/ReferenceImages.h"

#include <dcmtk/dcmdata/dcuid.h>

#include <algorithm>
#include <filesystem>
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

StructureSetReference::StructureSetReference() : Frames{ NewUID() } {}

StructureSetReference::StructureSetReference(const std::string& path, Monitor& monitor)
{
  std::error_code status;
  if (std::filesystem::is_directory(path, status))
  {
    this->TakeImages(path, "", monitor);
    return;
  }
  LoadDICOM(path, this->File);
  const std::string classUID = GetUID(this->Data(), DCM_SOPClassUID);
  if (classUID == UID_RTStructureSetStorage)
  {
    this->TakeStructureSet(path, monitor);
  }
  else if (HasPlane(this->Data()))
  {
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    this->TakeImages(folder.string(), GetUID(this->Data(), DCM_SeriesInstanceUID), monitor);
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
  this->TakeFrames();
  DrawnSlices drawn = ReadDrawnSlices(this->Data(), this->Frames.front(), monitor);
  if (drawn.Malformed > 0)
  {
    this->Report.push_back(Counted(static_cast<std::size_t>(drawn.Malformed), "contour") +
      " of the reference malformed: they tell no plane, and are copied as they are.");
  }
  for (auto& [frame, slices] : drawn.SlicesOfFrame)
  {
    const std::size_t listed = ListedImages(this->Data(), frame).size();
    const std::size_t count = std::max(slices.size(), listed);
    this->SlicesOfFrame[frame] = ReferenceSlices(std::move(slices), count);
  }
}

void StructureSetReference::TakeFrames()
{
  const auto take = [this](const std::string& uid)
  {
    if (!uid.empty() &&
      std::find(this->Frames.begin(), this->Frames.end(), uid) == this->Frames.end())
    {
      this->Frames.push_back(uid);
    }
  };
  for (DcmItem* frame : ItemsOf(this->Data(), DCM_ReferencedFrameOfReferenceSequence))
  {
    take(GetUID(*frame, DCM_FrameOfReferenceUID));
  }
  for (DcmItem* roi : ItemsOf(this->Data(), DCM_StructureSetROISequence))
  {
    take(GetUID(*roi, DCM_ReferencedFrameOfReferenceUID));
  }
  if (this->Frames.empty())
  {
    take(GetUID(this->Data(), DCM_FrameOfReferenceUID));
  }
  this->NamesFrames = !this->Frames.empty();
  if (!this->NamesFrames)
  {
    this->Frames = { NewUID() };
    this->Report.push_back("The reference names no frame of reference, so the new file has one of "
                           "its own: no image is known to share it.");
  }
}

void StructureSetReference::TakeImages(
  const std::string& folder, const std::string& series, Monitor& monitor)
{
  this->Kind = KindOfReference::Images;
  ReferenceImages images = ReadReferenceImages(folder, series, monitor);
  this->File = images.First;
  this->FileNames = std::move(images.FileNames);
  this->Report = std::move(images.Report);
  this->TakeFrames();
  const std::size_t count = images.Slices.size();
  this->SlicesOfFrame[this->Frames.front()] = ReferenceSlices(std::move(images.Slices), count);
}

bool StructureSetReference::HasFrame(const std::string& drawn) const
{
  return drawn.empty() || !this->NamesFrames ||
    std::find(this->Frames.begin(), this->Frames.end(), drawn) != this->Frames.end();
}

std::string StructureSetReference::WhyNotIn(const std::string& drawn) const
{
  return "it is in the frame of reference " + Listed(this->Frames, 3) +
    ", and the contours were drawn in " + drawn +
    ", whose coordinates have nothing to do with it; give the structure set that they were drawn "
    "in, or an image of the series that they were drawn on.";
}

std::string StructureSetReference::FrameFor(const std::string& drawn) const
{
  const bool isKept = this->NamesFrames || this->IsNone();
  return drawn.empty() || !isKept ? this->Frames.front() : drawn;
}

const ReferenceSlices& StructureSetReference::GetSlices(const std::string& frame) const
{
  static const ReferenceSlices none;
  const auto found = this->SlicesOfFrame.find(frame);
  return found == this->SlicesOfFrame.end() ? none : found->second;
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

void StructureSetReference::AddImagesTo(DcmItem& data, const std::vector<std::string>& frames)
{
  if (this->IsStructureSet())
  {
    this->CopyFrames(data);
  }
  std::set<std::string> there;
  for (DcmItem* frame : ItemsOf(data, DCM_ReferencedFrameOfReferenceSequence))
  {
    there.insert(GetUID(*frame, DCM_FrameOfReferenceUID));
  }
  for (const std::string& frame : frames)
  {
    if (there.insert(frame).second)
    {
      this->MakeFrame(frame, data);
    }
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
    return !GetUID(frame, DCM_FrameOfReferenceUID).empty();
  };
  Prune(data, DCM_ReferencedFrameOfReferenceSequence, hasUID);
}

void StructureSetReference::MakeFrame(const std::string& frame, DcmItem& data)
{
  DcmItem& item = AppendItem(data, DCM_ReferencedFrameOfReferenceSequence);
  Put(item, DCM_FrameOfReferenceUID, frame);
  if (this->Kind != KindOfReference::Images)
  {
    return;
  }
  DcmItem& image = this->Data();
  DcmItem& study = AppendItem(item, DCM_RTReferencedStudySequence);
  // The class is retired, and what the standard still wants here.
  Put(study, DCM_ReferencedSOPClassUID, UID_RETIRED_DetachedStudyManagementSOPClass);
  Put(study, DCM_ReferencedSOPInstanceUID, GetUID(image, DCM_StudyInstanceUID));
  DcmItem& series = AppendItem(study, DCM_RTReferencedSeriesSequence);
  Put(series, DCM_SeriesInstanceUID, GetUID(image, DCM_SeriesInstanceUID));
  for (const ReferenceSlice& slice : this->GetSlices(frame).GetSlices())
  {
    AddImage(slice.ClassUID, slice.InstanceUID, series);
  }
}
}
