// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ReferenceImages.h
 * @brief The images of one series in a folder, with their planes.
 *
 * For the sources of this folder only, because it takes in DCMTK's headers.
 */
#ifndef recon_ReferenceImages_h
#define recon_ReferenceImages_h

#include "Base/Monitor.h"
#include "DICOM/DICOMItem.h"
#include "DICOM/ReferenceSlices.h"

#include <string>
#include <vector>

namespace recon
{
struct ReferenceImages
{
  DcmFileFormat First; ///< one of the images, without its pixels
  std::vector<ReferenceSlice> Slices;
  std::vector<std::string> FileNames; ///< of all images of the series, those left out included
  std::vector<std::string> Report;    ///< what was left out; a sentence a kind
};

/// Whether an image of this data set has one plane: position and orientation.
bool HasPlane(DcmItem& image);

/**
 * Left out are images that lie across most of the others (localizers, which some scanners put into
 * the series), that have another frame of reference than most, or that tell no plane; and files
 * that are damaged.
 *
 * @param series its Series Instance UID (0020,000e); empty where the folder has one series only
 * @throws Error where there are none, or, without a series, several
 */
ReferenceImages ReadReferenceImages(
  const std::string& folder, const std::string& series, Monitor& monitor);
}

#endif
