// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file StructureSetReference.h
 * @brief What a new structure set takes from an existing one, or from the images it is drawn on:
 * patient, study, frame of reference, and the images with their planes.
 *
 * For the sources of this folder only, because it takes in DCMTK's headers.
 */
#ifndef recon_StructureSetReference_h
#define recon_StructureSetReference_h

#include "Base/Monitor.h"
#include "DICOM/DICOMItem.h"
#include "DICOM/ReferenceSlices.h"

#include <map>
#include <string>
#include <vector>

namespace recon
{
class StructureSetReference
{
public:
  /// No reference: no patient, no images, and a frame of reference of its own.
  StructureSetReference();

  /**
   * @param path an RT structure set; or an image (CT, MR, PET) of a series, whose other images are
   * taken from the same folder; or a folder with the images of one series
   * @throws Error where it is none of these, or damaged
   */
  StructureSetReference(const std::string& path, Monitor& monitor);

  StructureSetReference(const StructureSetReference&) = delete;
  StructureSetReference& operator=(const StructureSetReference&) = delete;

  bool IsStructureSet() const { return this->Kind == KindOfReference::StructureSet; }
  bool IsNone() const { return this->Kind == KindOfReference::None; }
  /// The structure set, or one of the images without its pixels; an empty item where there is none.
  DcmItem& Data() { return *this->File.getDataset(); }

  /// Its frames of reference, those of its ROIs included; one that is new where it names none.
  const std::vector<std::string>& GetFrames() const { return this->Frames; }
  /// Whether contours of a frame of reference can be written: where it is one of these, or where
  /// either side does not name one.
  bool HasFrame(const std::string& drawn) const;
  /// A sentence for contours of a frame of reference that it does not have.
  std::string WhyNotIn(const std::string& drawn) const;
  /// The frame of reference that contours are written in: that which they were drawn in where it is
  /// named, otherwise the first.
  std::string FrameFor(const std::string& drawn) const;
  /// The images of a frame of reference.
  const ReferenceSlices& GetSlices(const std::string& frame) const;

  /// Whether writing there would destroy what is referred to.
  bool IsPartOfIt(const std::string& fileName) const;
  /// What was odd about it; a sentence each.
  const std::vector<std::string>& GetReport() const { return this->Report; }

  /// Adds the Referenced Frame of Reference Sequence (3006,0010) with all images, and at least with
  /// these frames.
  void AddImagesTo(DcmItem& data, const std::vector<std::string>& frames);

private:
  enum class KindOfReference
  {
    None,
    StructureSet,
    Images
  };

  void TakeStructureSet(const std::string& path, Monitor& monitor);
  void TakeImages(const std::string& folder, const std::string& series, Monitor& monitor);
  void TakeFrames();
  void CopyFrames(DcmItem& data);
  void MakeFrame(const std::string& frame, DcmItem& data);

  KindOfReference Kind = KindOfReference::None;
  DcmFileFormat File;
  std::vector<std::string> Frames;
  bool NamesFrames = false;
  std::map<std::string, ReferenceSlices> SlicesOfFrame;
  std::vector<std::string> FileNames;
  std::vector<std::string> Report;
};
}

#endif
