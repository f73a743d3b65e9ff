// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file DrawnSlices.h
 * @brief The planes of images that the contours of a structure set tell, for it lists images
 * without their planes.
 *
 * For the sources of this folder only, because it takes in DCMTK's headers.
 */
#ifndef recon_DrawnSlices_h
#define recon_DrawnSlices_h

#include "Base/Monitor.h"
#include "DICOM/DICOMItem.h"
#include "DICOM/ReferenceSlices.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace recon
{
struct DrawnSlices
{
  /// By frame of reference, as coordinates of two of them have nothing to do with each other.
  std::map<std::string, std::vector<ReferenceSlice>> SlicesOfFrame;
  int Malformed = 0; ///< contours that could not be used
};

/// The images that a structure set lists for a frame of reference, of known plane or not.
std::set<std::string> ListedImages(DcmItem& structureSet, const std::string& frame);

/**
 * An image's plane is that of the largest contour that refers to it and to no other image.
 *
 * @param frame of ROIs that do not name theirs, and whose images are listed for none
 */
DrawnSlices ReadDrawnSlices(DcmItem& structureSet, const std::string& frame, Monitor& monitor);
}

#endif
