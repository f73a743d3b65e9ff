// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @file ReferenceSlices.h
 * @brief The images that a structure set refers to, and which of them a contour lies on.
 */
#ifndef recon_ReferenceSlices_h
#define recon_ReferenceSlices_h

#include "Base/Geometry.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace recon
{
/// An image with its plane in the patient coordinate system, mm.
struct ReferenceSlice
{
  std::string ClassUID;
  std::string InstanceUID;
  Vector3 Normal{ 0, 0, 1 }; ///< of length 1; its largest component is positive
  double Offset = 0;         ///< along Normal, from the origin
  /// Around the pixels of an image; around all that is drawn, for an image that is known from that.
  std::array<Point3, 4> Outline{};
  double PixelArea = 0; ///< mm2; 0 where it is unknown
};

/// Of length 1 with a positive largest component, and exactly an axis where it is one but for
/// rounding. Zero where the direction is.
Vector3 SliceNormal(const Vector3& direction);

class ReferenceSlices
{
public:
  ReferenceSlices() = default;

  /**
   * @param slices those whose plane is known
   * @param listed number of images that there are, those of unknown plane included
   *
   * A contour lies on a slice within half the distance of the slices. Where some images have no
   * known plane, because nothing is drawn on them, that distance may be a multiple of the true one:
   * unless so few images are listed that there is no room for more between those known, a contour
   * must lie within 0.1 mm of a known plane.
   */
  ReferenceSlices(std::vector<ReferenceSlice> slices, std::size_t listed);

  /// The slice that all points of a contour are nearest to; nullptr where they lie on none.
  const ReferenceSlice* Find(const std::vector<Point3>& contour) const;

  const std::vector<ReferenceSlice>& GetSlices() const { return this->Slices; }
  /// Largest distance of a contour from its slice, mm.
  double GetTolerance() const { return this->Tolerance; }

private:
  std::vector<ReferenceSlice> Slices;
  double Tolerance = 0;
};
}

#endif
