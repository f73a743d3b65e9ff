// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ReadReferenceSlices.h
 * @brief The planes of the images that contours are to lie on.
 */
#ifndef recon_ReadReferenceSlices_h
#define recon_ReadReferenceSlices_h

#include "Base/Monitor.h"
#include "DICOM/ReferenceSlices.h"

#include <string>
#include <vector>

namespace recon
{
struct SlicesOfReference
{
  std::vector<ReferenceSlice> Slices; ///< by increasing offset, one a plane
  double Tolerance = 0;               ///< mm; a contour so near to a slice belongs to it
  std::string FrameOfReferenceUID;    ///< that they are in
  std::vector<std::string> Report;    ///< a sentence for everything that was left out
};

/**
 * The images of known plane, in one frame of reference.
 *
 * @param path an RT structure set, an image of a series, or a folder of images, as
 * StructureSetReference takes them
 * @param frame of reference that is meant; empty for the reference's only or first one
 * @throws Error where it is none of these, damaged, in other frames of reference, or tells no plane
 */
SlicesOfReference ReadReferenceSlices(
  const std::string& path, const std::string& frame, Monitor& monitor);
}

#endif
