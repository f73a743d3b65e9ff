// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ContoursOnSlices.h
 * @brief Contours that were drawn on some planes, on the slices of a series of images.
 */
#ifndef recon_ContoursOnSlices_h
#define recon_ContoursOnSlices_h

#include "Base/Monitor.h"
#include "Contours/ContourSet.h"
#include "DICOM/ReadReferenceSlices.h"

namespace recon
{
struct SliceContourOptions
{
  enum MethodType
  {
    Implicit = 0, ///< smooth, from contours on any planes
    Polyhedral =
      1 ///< straight between the contours of parallel planes, which come back as they were drawn
  };
  MethodType Method = Implicit;
  /// Also on slices beyond the outermost drawn points, where the implicit function closes.
  bool Extrapolate = false;
  /// Contours of less are left out; square units. 0: SpeckArea of the images' pixels; below: none.
  double SmallestArea = 0;
  int Threads = 0; ///< 0 = as many as the machine has; the result does not depend on it
};

/**
 * The contours of the solid that the drawn ones make, on those slices that lie between the
 * outermost drawn points, or so near to them that a contour there belongs to the slice
 * (SlicesOfReference::Tolerance).
 *
 * Polyhedral: on a slice that has drawn contours in its plane, those are the result; a slice beyond
 * the last drawn plane, by no more than that tolerance, takes its contours.
 *
 * @throws Error where no slice lies there, or the method has none to give; Aborted
 */
ContourSet ContoursOnSlices(const ContourSet& drawn, const SlicesOfReference& slices,
  const SliceContourOptions& options, Monitor& monitor);
}

#endif
